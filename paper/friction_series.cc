#include "paper/friction_series.h"

#include <Eigen/Dense>
#include <cmath>

#include "core/error.h"
#include "paper/unit_table.h"

namespace asperity {

std::vector<FrictionPoint> read_friction_series(const std::filesystem::path& file) {
  const UnitTable table(file);
  const bool has_sd = table.has("lateral_force_sd");
  std::vector<FrictionPoint> series;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    FrictionPoint point{table.number("normal_force", Dimension::force, row),
                        {table.number("lateral_force", Dimension::force, row)}};
    if (has_sd) point.lateral_force.sd = table.number("lateral_force_sd", Dimension::force, row);
    if (!std::isfinite(point.normal_force) || !std::isfinite(point.lateral_force.value))
      throw InputError(file.string() + ": row " + std::to_string(row + 1) + " lacks a force");
    series.push_back(point);
  }
  return series;
}

FrictionFit fit_friction(const std::vector<FrictionPoint>& series,
                         const std::function<double(double)>& scale) {
  const auto n = static_cast<Eigen::Index>(series.size());
  if (n < 3)
    throw InputError("a friction coefficient with its offset and their uncertainty needs three points, not " +
                     std::to_string(n));
  bool has_sd = true;
  for (const auto& point : series)
    has_sd = has_sd && point.lateral_force.has_sd() && point.lateral_force.sd > 0;
  Eigen::MatrixXd A(n, 2);
  Eigen::VectorXd b(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const FrictionPoint& point = series[static_cast<std::size_t>(i)];
    const double weight = has_sd ? 1 / point.lateral_force.sd : 1, s = scale(point.normal_force);
    A(i, 0) = weight * s * point.normal_force;
    A(i, 1) = weight * s;
    b[i] = weight * point.lateral_force.value;
  }
  // Columns of order one: mu and mu h differ by the size of a load.
  const Eigen::Vector2d unit = A.colwise().norm();
  const Eigen::MatrixXd scaled = A * unit.cwiseInverse().asDiagonal();
  const Eigen::Vector2d x = unit.cwiseInverse().asDiagonal() * scaled.colPivHouseholderQr().solve(b);
  const double s2 = (b - A * x).squaredNorm() / static_cast<double>(n - 2);
  Eigen::Matrix2d covariance = unit.cwiseInverse().asDiagonal() * (scaled.transpose() * scaled).inverse() *
                               unit.cwiseInverse().asDiagonal();
  if (!has_sd) covariance *= s2;
  const double mu = x[0], h = x[1] / x[0];
  // h = x1/x0: dh = (dx1 - h dx0)/mu.
  const double variance_h =
      (covariance(1, 1) - 2 * h * covariance(0, 1) + h * h * covariance(0, 0)) / (mu * mu);
  const double covariance_mu_h = (covariance(0, 1) - h * covariance(0, 0)) / mu;
  FrictionFit fit;
  fit.coefficient = {mu, std::sqrt(covariance(0, 0))};
  fit.offset = {h, std::sqrt(variance_h)};
  fit.correlation = fit.coefficient.sd > 0 && fit.offset.sd > 0
                        ? covariance_mu_h / (fit.coefficient.sd * fit.offset.sd)
                        : 0;
  fit.chi2_reduced = has_sd ? s2 : 1;
  return fit;
}

RollingContact mean_rolling(const RollingContact& substrate, const RollingContact& indenter) {
  const double sum = substrate.factor + indenter.factor;
  return {sum / 2, (substrate.factor * substrate.offset + indenter.factor * indenter.offset) / sum};
}

}  // namespace asperity

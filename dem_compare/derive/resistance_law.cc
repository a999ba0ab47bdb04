#include "dem_compare/derive/resistance_law.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.h"
#include "dem_compare/cases/case_numbers.h"

namespace asperity {
namespace {

using Points = std::vector<ResistancePoint>;

/// Scatters tried, at equal distances of their logarithms.
std::vector<double> scatters(double low, double high, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(low * std::pow(high / low, i / (count - 1.0)));
  return values;
}

std::size_t realisations_of(const Points& points) {
  std::set<std::string> names;
  for (const auto& point : points) names.insert(point.realisation);
  return names.size();
}

/// A realisation's common scatter shows only if there are several, and is apart from the cases' own if one
/// has several.
bool has_common_scatter(const Points& points) {
  const std::size_t count = realisations_of(points);
  return count > 1 && count < points.size();
}

/// Relative scatters are of `level`, the resistance expected of each case: taken of the measured values
/// themselves, a common scatter would pull the fit below all of them (Peelle's puzzle; Fröhner 1997).
Eigen::MatrixXd covariance_of(const Points& points, const Eigen::VectorXd& level, double case_scatter,
                              double realisation_scatter) {
  const auto n = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd V(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const ResistancePoint &p = points[static_cast<std::size_t>(i)],
                            &q = points[static_cast<std::size_t>(j)];
      V(i, j) = p.realisation == q.realisation
                    ? realisation_scatter * realisation_scatter * level[i] * level[j]
                    : 0;
      if (i == j) V(i, i) += p.sd * p.sd + case_scatter * case_scatter * level[i] * level[i];
    }
  return V;
}

Eigen::VectorXd values_of(const Points& points) {
  Eigen::VectorXd y(static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) y[static_cast<Eigen::Index>(i)] = points[i].value;
  return y;
}

/// Columns of mu and mu h; one column where h cannot be told.
Eigen::MatrixXd design(const Points& points, LengthScale scale, bool with_offset) {
  Eigen::MatrixXd X(static_cast<Eigen::Index>(points.size()), with_offset ? 2 : 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    X(row, 0) = points[i].length(scale) * points[i].load;
    if (with_offset) X(row, 1) = points[i].length(scale);
  }
  return X;
}

double log_determinant(const Eigen::LLT<Eigen::MatrixXd>& factor) {
  return 2 * factor.matrixLLT().diagonal().array().log().sum();
}

struct GeneralisedFit {
  Eigen::VectorXd parameters;
  Eigen::MatrixXd covariance;
  double log_likelihood = 0;  ///< restricted
};

GeneralisedFit generalised_fit(const Eigen::MatrixXd& X, const Eigen::VectorXd& y, const Eigen::MatrixXd& V) {
  const Eigen::LLT<Eigen::MatrixXd> factor(V);
  const Eigen::MatrixXd A = factor.matrixL().solve(X);
  const Eigen::VectorXd b = factor.matrixL().solve(y);
  const Eigen::MatrixXd normal = A.transpose() * A;
  const Eigen::LLT<Eigen::MatrixXd> normal_factor(normal);
  GeneralisedFit fit;
  fit.parameters = normal_factor.solve(A.transpose() * b);
  fit.covariance = normal_factor.solve(Eigen::MatrixXd::Identity(normal.rows(), normal.cols()));
  fit.log_likelihood = -0.5 * (log_determinant(factor) + log_determinant(normal_factor) +
                               (b - A * fit.parameters).squaredNorm());
  return fit;
}

bool same_load_and_radius(const ResistancePoint& one, const ResistancePoint& other) {
  return same_load(one.load, other.load) && one.particle_radius == other.particle_radius;
}

/// In units of a load, a resistance and a length of order one.
Points in_units(Points points, double load, double value, double length) {
  for (auto& point : points) {
    point.load /= load;
    point.value /= value, point.sd /= value;
    point.particle_radius /= length, point.contact_radius /= length;
  }
  return points;
}

/// Mean resistance of the contact of each case: what is expected whatever the law.
Eigen::VectorXd mean_of_contact(const Points& points) {
  Eigen::VectorXd means(static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    double sum = 0;
    int count = 0;
    for (const auto& other : points)
      if (same_load_and_radius(other, points[i])) sum += other.value, ++count;
    means[static_cast<Eigen::Index>(i)] = sum / count;
  }
  return means;
}

/// What a solved case is good for (balances, mesh), whatever its path says, and the most that is tried.
constexpr double smallest_scatter = 1e-3, largest_scatter = 1;
constexpr int scatter_steps = 31;

}  // namespace

double ResistancePoint::length(LengthScale scale) const {
  switch (scale) {
    case LengthScale::particle_radius:
      return particle_radius;
    case LengthScale::contact_radius:
      return contact_radius;
    case LengthScale::none:
      break;
  }
  return 1;
}

std::vector<double> distinct_loads(const Points& points) {
  std::vector<double> loads;
  for (const auto& point : points) loads.push_back(point.load);
  std::sort(loads.begin(), loads.end());
  loads.erase(std::unique(loads.begin(), loads.end(), same_load), loads.end());
  return loads;
}

ResistanceLaw fit_resistance(const Points& points, LengthScale scale) {
  if (points.empty()) throw InputError("a law of resistance needs a case that slips fully");
  const std::vector<double> loads = distinct_loads(points);
  ResistanceLaw law;
  law.loads = {loads.front(), loads.back()};
  law.has_offset = loads.size() > 1;
  const double load = loads.back(), unit = values_of(points).cwiseAbs().maxCoeff();
  double longest = 0;
  for (const auto& point : points) longest = std::max(longest, point.length(scale));
  const Points scaled = in_units(points, load, unit, longest);
  const Eigen::MatrixXd X = design(scaled, scale, law.has_offset);
  const Eigen::VectorXd y = values_of(scaled);
  law.degrees_of_freedom = static_cast<int>(y.size() - X.cols());

  const Eigen::VectorXd level = mean_of_contact(scaled);
  const Eigen::VectorXd expected =
      X * generalised_fit(X, y, covariance_of(scaled, level, largest_scatter, 0)).parameters;
  double best = -std::numeric_limits<double>::infinity();
  GeneralisedFit fit;
  const std::vector<double> tried = law.degrees_of_freedom > 0
                                        ? scatters(smallest_scatter, largest_scatter, scatter_steps)
                                        : std::vector{smallest_scatter};
  std::vector<double> common{0.0};
  if (has_common_scatter(points) && law.degrees_of_freedom > 0)
    common.insert(common.end(), tried.begin(), tried.end());
  for (const double shared : common)
    for (const double own : tried) {
      GeneralisedFit candidate = generalised_fit(X, y, covariance_of(scaled, expected, own, shared));
      if (!(candidate.log_likelihood > best)) continue;
      best = candidate.log_likelihood;
      fit = std::move(candidate);
      law.case_scatter = own, law.realisation_scatter = shared;
    }
  const double mu = fit.parameters[0], mu_h = law.has_offset ? fit.parameters[1] : 0;
  law.coefficient = mu * unit / (load * longest);
  law.covariance(0, 0) = fit.covariance(0, 0) * std::pow(unit / (load * longest), 2);
  if (law.has_offset) {
    law.offset = mu_h / mu * load;
    Eigen::Matrix2d slopes;  // of (mu, h) with respect to (mu, mu h)
    slopes << unit / (load * longest), 0, -mu_h / (mu * mu) * load, load / mu;
    law.covariance = slopes * fit.covariance * slopes.transpose();
  }
  law.misfit = std::sqrt(((X * fit.parameters - y).array() / y.array()).square().mean());
  return law;
}

double log_evidence(const Points& points, LengthScale scale) {
  double log_load = 0, log_value = 0, log_length = 0;
  for (const auto& point : points) {
    log_load += std::log(point.load) / static_cast<double>(points.size());
    log_value += std::log(point.value) / static_cast<double>(points.size());
    log_length += std::log(point.length(scale)) / static_cast<double>(points.size());
  }
  const Points scaled = in_units(points, std::exp(log_load), std::exp(log_value), std::exp(log_length));
  const Eigen::MatrixXd X = design(scaled, scale, true);
  const Eigen::VectorXd y = values_of(scaled);
  const Eigen::MatrixXd prior = X * X.transpose();  // sd one for both numbers

  const Eigen::VectorXd level = mean_of_contact(scaled);
  const std::vector<double> own_scatters = scatters(smallest_scatter, largest_scatter, scatter_steps);
  const std::vector<double> common = has_common_scatter(points) ? own_scatters : std::vector{0.0};
  std::vector<double> logs;
  for (const double shared : common)
    for (const double own : own_scatters) {
      const Eigen::LLT<Eigen::MatrixXd> factor(covariance_of(scaled, level, own, shared) + prior);
      const Eigen::VectorXd white = factor.matrixL().solve(y);
      logs.push_back(-0.5 * (white.squaredNorm() + log_determinant(factor) +
                             static_cast<double>(y.size()) * std::log(2 * M_PI)));
    }
  const double largest = *std::max_element(logs.begin(), logs.end());
  double sum = 0;
  for (const double value : logs) sum += std::exp(value - largest);
  return largest + std::log(sum / static_cast<double>(logs.size()));
}

double leave_one_out(const Points& points, LengthScale scale) {
  constexpr std::size_t fewest = 3;
  if (distinct_loads(points).size() < fewest) return std::numeric_limits<double>::quiet_NaN();
  double squares = 0;
  for (const auto& left_out : points) {
    Points others;
    for (const auto& point : points)
      if (!same_load_and_radius(point, left_out)) others.push_back(point);
    squares += std::pow(fit_resistance(others, scale).at(left_out, scale) / left_out.value - 1, 2) /
               static_cast<double>(points.size());
  }
  return std::sqrt(squares);
}

}  // namespace asperity

#include "paper/exponential_law.h"

#include <cmath>

#include "core/error.h"
#include "core/root.h"
#include "dem_compare/numbers/least_squares.h"

namespace asperity {
namespace {

using Values = std::vector<double>;

[[noreturn]] void no_decay() {
  throw WorkError(
      "no decaying exponential goes through these points: their change does not slow down with roughness");
}

/// Exactly through three points with x rising: (y0 - y1)/(y1 - y2) fixes d.
ExponentialLaw through(const Values& x, const Values& y) {
  const double wanted = (y[0] - y[1]) / (y[1] - y[2]), first = x[1] - x[0], second = x[2] - x[1];
  // (1 - exp(-first/d))/(exp(-first/d) (1 - exp(-second/d))): falls from infinity to first/second as d grows.
  const auto excess = [&](double log_d) {
    const double d = std::exp(log_d);
    return std::log(std::expm1(first / d) / -std::expm1(-second / d)) - std::log(wanted);
  };
  if (!(wanted > first / second) || !std::isfinite(wanted)) no_decay();
  constexpr double narrow = 0.01, wide = 1e5;
  double low = std::log(narrow * (x[2] - x[0])), high = std::log(wide * (x[2] - x[0]));
  if (excess(low) * excess(high) > 0) no_decay();
  ExponentialLaw law;
  law.d = std::exp(root_between(excess, low, high, 50));
  law.c = (y[0] - y[2]) / (std::exp(-x[0] / law.d) - std::exp(-x[2] / law.d));
  law.b = y[0] - law.c * std::exp(-x[0] / law.d);
  return law;
}

ExponentialLaw best(const Values& x, const Values& y, const Values& sd) {
  const std::size_t n = x.size();
  const ExponentialLaw start = through({x[0], x[n / 2], x[n - 1]}, {y[0], y[n / 2], y[n - 1]});
  if (n == 3) return start;
  const auto law_of = [&](const Eigen::VectorXd& p) {
    return ExponentialLaw{start.b * p[0], start.c * p[1], start.d * std::exp(p[2])};
  };
  const auto residuals = [&](const Eigen::VectorXd& p) {
    Eigen::VectorXd r(static_cast<Eigen::Index>(n));
    for (std::size_t i = 0; i < n; ++i) r[static_cast<Eigen::Index>(i)] = (law_of(p)(x[i]) - y[i]) / sd[i];
    return r;
  };
  return law_of(fit_least_squares(residuals, Eigen::Vector3d(1, 1, 0)).parameters);
}

}  // namespace

Uncertain ExponentialFit::at(const Uncertain& x) const {
  const double decay = std::exp(-x.value / law.d);
  const Eigen::Vector3d slopes(1, decay, law.c * decay * x.value / (law.d * law.d));
  const double along = x.has_sd() ? law.c * decay / law.d * x.sd : 0;
  return {law(x.value), std::sqrt(slopes.dot(covariance * slopes) + along * along)};
}

ExponentialFit fit_exponential(const std::vector<Uncertain>& x, const std::vector<Uncertain>& y) {
  const std::size_t n = x.size();
  if (n < 3 || y.size() != n)
    throw InputError("a decaying exponential needs three points or more, not " + std::to_string(n));
  Values xs, ys, sds;
  for (std::size_t i = 0; i < n; ++i) {
    xs.push_back(x[i].value);
    ys.push_back(y[i].value);
    sds.push_back(y[i].has_sd() ? y[i].sd : 1);
    if (i > 0 && !(xs[i] > xs[i - 1]))
      throw InputError("the places of the points of a decaying exponential must rise");
  }
  ExponentialFit fit;
  fit.law = best(xs, ys, sds);
  for (std::size_t i = 0; i < n; ++i) fit.chi2 += std::pow((fit.law(xs[i]) - ys[i]) / sds[i], 2);

  constexpr double share_of_sd = 1e-3;  // of a central difference
  fit.covariance.setZero();
  const auto add = [&](Values& values, std::size_t i, double sd) {
    if (!(sd > 0)) return;
    const double value = values[i];
    values[i] = value + share_of_sd * sd;
    const ExponentialLaw up = best(xs, ys, sds);
    values[i] = value - share_of_sd * sd;
    const ExponentialLaw down = best(xs, ys, sds);
    values[i] = value;
    const Eigen::Vector3d change =
        Eigen::Vector3d(up.b - down.b, up.c - down.c, up.d - down.d) / (2 * share_of_sd);
    fit.covariance += change * change.transpose();
  };
  for (std::size_t i = 0; i < n; ++i) {
    add(xs, i, x[i].sd);
    add(ys, i, y[i].sd);
  }
  fit.b = {fit.law.b, std::sqrt(fit.covariance(0, 0))};
  fit.c = {fit.law.c, std::sqrt(fit.covariance(1, 1))};
  fit.d = {fit.law.d, std::sqrt(fit.covariance(2, 2))};
  return fit;
}

}  // namespace asperity

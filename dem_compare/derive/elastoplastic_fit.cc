#include "dem_compare/derive/elastoplastic_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "dem_compare/cases/normal_numbers.h"
#include "dem_compare/numbers/least_squares.h"
#include "dem_compare/numbers/statistics.h"

namespace asperity {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Values = std::vector<double>;

constexpr std::size_t fewest_loading = 4, fewest_unloading = 3;  // steps
/// Solved to about 1e-6 of the load: smaller pulls are none.
constexpr double least_pull = 1e-5;

/// Work along the path, trapezoids [J].
double work_of(const Values& approach, const Values& force) {
  double work = 0;
  for (std::size_t i = 0; i + 1 < force.size(); ++i)
    work += (force[i] + force[i + 1]) / 2 * (approach[i + 1] - approach[i]);
  return work;
}

/// Enough steps, and more of the work stays than a few asperities that yield and coarse steps leave.
bool tells_enough(const LoadUnload& curve) {
  std::size_t bearing = 0;
  for (std::size_t i = curve.loading; i < curve.force.size(); ++i) bearing += curve.force[i] > 0;
  if (curve.loading < fewest_loading || bearing < fewest_unloading) return false;
  constexpr double least_loss = 0.03;
  return work_of(curve.approach, curve.force) >
         least_loss * curve.largest_force() * curve.largest_approach() / 2;
}

/// What a fit leaves, relative to the largest force.
VectorXd residuals_of(const NormalLaw& law, const LoadUnload& curve, double offset) {
  const Values force = forces_along(law, curve, offset);
  VectorXd residuals(static_cast<Index>(force.size()));
  for (std::size_t i = 0; i < force.size(); ++i)
    residuals[static_cast<Index>(i)] = (force[i] - curve.force[i]) / curve.largest_force();
  return residuals;
}

/// Parameters of a fit: logarithms of two ratios to their start, then the offset over the largest approach
/// where it is fitted, then the logarithm of a third ratio where there is one.
template <class LawAt>
std::optional<LeastSquaresFit> fitted(const LawAt& law_at, const LoadUnload& curve, bool with_offset,
                                      const std::vector<VectorXd>& starts) {
  const auto residuals = [&](const VectorXd& p) {
    const double offset = with_offset ? p[2] * curve.largest_approach() : 0;
    return residuals_of(law_at(p), curve, offset);
  };
  const VectorXd* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const VectorXd& start : starts)
    if (const double left = residuals(start).squaredNorm(); left < least) least = left, best = &start;
  if (!best) return std::nullopt;
  try {
    LeastSquaresFit fit = fit_least_squares(residuals, *best);
    const bool is_sound =
        fit.parameters.allFinite() && fit.covariance(0, 0) >= 0 && fit.covariance(1, 1) >= 0;
    return is_sound ? std::optional(fit) : std::nullopt;
  } catch (const WorkError&) {
    return std::nullopt;  // too few points for so many numbers, or no minimum
  }
}

/// Approach at which the unloading has no force left, a straight line in F^(2/3) as Hertz' [m].
double approach_without_force(const LoadUnload& curve, const Values& force) {
  std::size_t last = curve.loading;  // that still bears
  while (last + 1 < force.size() && force[last + 1] > 0) ++last;
  const auto power = [&](std::size_t i) { return std::pow(std::max(0.0, force[i]), 2.0 / 3); };
  // Under a pull the next step is beyond zero: between the two.
  if (last + 1 < force.size() && force[last + 1] < 0) {
    const double share = force[last] / (force[last] - force[last + 1]);
    return curve.approach[last] + share * (curve.approach[last + 1] - curve.approach[last]);
  }
  const double slope = (power(last - 1) - power(last)) / (curve.approach[last - 1] - curve.approach[last]);
  return curve.approach[last] - power(last) / slope;
}

}  // namespace

double LoadUnload::pull_off() const {
  const double least = *std::min_element(force.begin(), force.end());
  return -least > least_pull * largest_force() ? -least : 0;
}

Values forces_along(const NormalLaw& law, const LoadUnload& curve, double offset) {
  Values forces;
  NormalState state;
  for (const double approach : curve.approach) {
    state = law->advance(state, approach - offset);
    forces.push_back(state.force);
  }
  return forces;
}

ElastoplasticNumbers numbers_of(const LoadUnload& curve, const Values& force) {
  ElastoplasticNumbers numbers;
  Values approach, bearing;
  for (std::size_t i = curve.loading - 1; i < force.size() && force[i] > 0; ++i)
    approach.push_back(curve.approach[i]), bearing.push_back(force[i]);
  const auto tangents = tangent_stiffness(approach, bearing);
  numbers.unloading_stiffness = tangents.empty() ? unknown : tangents.front().stiffness;
  numbers.imprint = approach_without_force(curve, force);
  numbers.dissipated = work_of(curve.approach, force);
  return numbers;
}

ElastoplasticQuality quality_of(const NormalLaw& law, const LoadUnload& curve, double offset) {
  constexpr double good_enough = 0.1;
  ElastoplasticQuality quality;
  const Values force = forces_along(law, curve, offset);
  quality.misfit =
      std::sqrt(residuals_of(law, curve, offset).squaredNorm() / static_cast<double>(force.size()));
  quality.solved = numbers_of(curve, curve.force);
  quality.law = numbers_of(curve, force);
  quality.solved.imprint -= offset;
  quality.law.imprint -= offset;
  for (std::size_t i = curve.loading; i-- > 0;) {
    if (std::abs(force[i] - curve.force[i]) > good_enough * curve.force[i]) break;
    quality.good = LoadRange{curve.force[i], curve.largest_force()};
  }
  return quality;
}

std::optional<ElastoplasticFit<ThorntonNing>> fit_thornton_ning(const LoadUnload& curve, const Hertz& bodies,
                                                                bool with_offset) {
  if (!tells_enough(curve)) return std::nullopt;
  const double p_0 = bodies.peak_pressure(curve.largest_force()), pull = curve.pull_off();
  const double w_0 = pull / (3 * M_PI * bodies.radius);  // of a surface twice as flat
  const Index size = 2 + (with_offset ? 1 : 0) + (pull > 0 ? 1 : 0);
  const auto law_at = [&](const VectorXd& p) {
    return ThorntonNing{bodies.reduced_modulus * std::exp(p[0]), bodies.radius, p_0 * std::exp(p[1]),
                        pull > 0 ? w_0 * std::exp(p[size - 1]) : 0};
  };
  std::vector<VectorXd> starts;
  for (const double modulus : {0.5, 0.75, 1.0, 1.5})
    for (const double pressure : {0.15, 0.25, 0.4, 0.55, 0.7, 0.85})
      for (const double offset : {0.0, 0.3}) {
        if (offset > 0 && !with_offset) continue;
        VectorXd start = VectorXd::Zero(size);
        start[0] = std::log(modulus), start[1] = std::log(pressure);
        if (with_offset) start[2] = offset;
        starts.push_back(start);
      }
  const auto fit = fitted(law_at, curve, with_offset, starts);
  if (!fit) return std::nullopt;
  ElastoplasticFit<ThorntonNing> result;
  result.law = law_at(fit->parameters);
  constexpr double hardly_yielded = 0.98;  // of the largest force: p_y is any that is large enough
  if (!(result.law.yield_force() < hardly_yielded * curve.largest_force())) return std::nullopt;
  if (with_offset) result.offset = fit->parameters[2] * curve.largest_approach();
  result.first_sd = result.law.reduced_modulus * std::sqrt(fit->covariance(0, 0));
  result.second_sd = result.law.yield_pressure * std::sqrt(fit->covariance(1, 1));
  result.quality = quality_of(result.law, curve, result.offset);
  return result;
}

std::optional<ElastoplasticFit<Luding>> fit_luding(const LoadUnload& curve, double radius, bool with_offset) {
  if (!tells_enough(curve)) return std::nullopt;
  // Steps that pull are for k_c, which follows in closed form.
  LoadUnload bearing = curve;
  while (!(bearing.force.back() > 0)) bearing.approach.pop_back(), bearing.force.pop_back();
  const double secant = curve.largest_force() / curve.largest_approach();
  const auto law_at = [&](const VectorXd& p) {
    const double k1 = secant * std::exp(p[0]);
    return Luding{k1, k1 * (1 + std::exp(p[1])), 0, 0, radius};
  };
  std::vector<VectorXd> starts;
  for (const double ratio : {0.1, 0.4, 1.0, 3.0})
    for (const double offset : {0.0, 0.3}) {
      if (offset > 0 && !with_offset) continue;
      VectorXd start = VectorXd::Zero(with_offset ? 3 : 2);
      start[0] = offset, start[1] = std::log(ratio);
      if (with_offset) start[2] = offset;
      starts.push_back(start);
    }
  const auto fit = fitted(law_at, bearing, with_offset, starts);
  if (!fit) return std::nullopt;
  ElastoplasticFit<Luding> result;
  Luding& law = result.law = law_at(fit->parameters);
  if (with_offset) result.offset = fit->parameters[2] * curve.largest_approach();
  const double grown = law.unloading_stiffness - law.loading_stiffness, k_p = law.unloading_stiffness;
  result.first_sd = law.loading_stiffness * std::sqrt(fit->covariance(0, 0));
  result.second_sd =
      std::hypot(result.first_sd * k_p / law.loading_stiffness, grown * std::sqrt(fit->covariance(1, 1)));
  const double largest = law.full_approach = curve.largest_approach() - result.offset;
  // The strongest pull is where the unloading line meets -k_c delta.
  if (const double pull = curve.pull_off(); pull > 0 && pull < grown * largest)
    law.adhesion_stiffness = pull * k_p / (grown * largest - pull);
  result.quality = quality_of(law, curve, result.offset);
  return result;
}

}  // namespace asperity

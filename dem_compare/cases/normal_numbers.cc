#include "dem_compare/cases/normal_numbers.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/residual_imprint.h"
#include "dem_compare/numbers/least_squares.h"
#include "dem_compare/numbers/statistics.h"

namespace asperity {
namespace {

using Values = std::vector<double>;

/// Slope at x[at] of the parabola through three points, one of which is `at`.
double parabola_slope(const Values& x, const Values& y, std::size_t i, std::size_t j, std::size_t k,
                      std::size_t at) {
  const auto term = [&](std::size_t p, std::size_t q, std::size_t r) {
    return y[p] * (2 * x[at] - x[q] - x[r]) / ((x[p] - x[q]) * (x[p] - x[r]));
  };
  return term(i, j, k) + term(j, i, k) + term(k, i, j);
}

/// Slope at `at` from its neighbours `reach` steps away, moved inwards at the ends.
double slope(const Values& x, const Values& y, std::size_t at, std::size_t reach) {
  const std::size_t last = x.size() - 1;
  const std::size_t left = at >= reach ? at - reach : 0, right = std::min(at + reach, last);
  if (left == at) return parabola_slope(x, y, at, std::min(reach, last - 1), std::min(2 * reach, last), at);
  if (right == at)
    return parabola_slope(x, y, at, std::max(last - reach, std::size_t{1}),
                          last >= 2 * reach ? last - 2 * reach : 0, at);
  return parabola_slope(x, y, left, at, right, at);
}

/// Steps of a branch under load, with what the contact bears: load and attraction.
struct Branch {
  Values approach, force;
};

Branch branch_of(const History& history, const HistoryBranch& range, double attraction) {
  Branch branch;
  for (std::size_t i = range.first; i <= range.last; ++i) {
    if (history.normal_force[i] <= 0) continue;
    branch.approach.push_back(history.normal_displacement[i]);
    branch.force.push_back(history.normal_force[i] + attraction);
  }
  return branch;
}

/// Parameters: relative prefactor, then the exponent unless it is given, then the offset over the largest
/// approach.
LeastSquaresFit fit_power_law(const Values& approach, const Values& force, double fixed_exponent,
                              bool with_offset) {
  const double largest_force = *std::max_element(force.begin(), force.end());
  const double largest_approach = *std::max_element(approach.begin(), approach.end());
  const bool fits_exponent = std::isnan(fixed_exponent);
  Eigen::VectorXd start(1 + (fits_exponent ? 1 : 0) + (with_offset ? 1 : 0));
  start.setZero();
  start[0] = 1;
  if (fits_exponent) start[1] = 1.5;
  return fit_least_squares(
      [&](const Eigen::VectorXd& p) {
        const double exponent = fits_exponent ? p[1] : fixed_exponent;
        const double offset = with_offset ? p[p.size() - 1] : 0;
        Eigen::VectorXd residual(static_cast<Eigen::Index>(force.size()));
        for (std::size_t i = 0; i < force.size(); ++i) {
          const double indentation = std::max(0.0, approach[i] / largest_approach - offset);
          residual[static_cast<Eigen::Index>(i)] =
              p[0] * std::pow(indentation, exponent) - force[i] / largest_force;
        }
        return residual;
      },
      start);
}

FittedNumber parameter(const LeastSquaresFit& fit, Eigen::Index i, double unit) {
  return {fit.parameters[i] * unit, std::sqrt(fit.covariance(i, i)) * unit};
}

/// Under the load.
std::vector<TangentStiffness> tangents_of(const Branch& branch, double attraction) {
  std::vector<TangentStiffness> tangents = tangent_stiffness(branch.approach, branch.force);
  for (TangentStiffness& tangent : tangents) tangent.force -= attraction;
  return tangents;
}

/// The steps of the first loading; stiffnesses are those of `numbers`.
std::vector<LoadPoint> load_points(const History& history, const HistoryBranch& loading, const Hertz& hertz,
                                   double attraction, const NormalNumbers& numbers) {
  std::vector<LoadPoint> points;
  for (std::size_t i = loading.first; i <= loading.last; ++i) {
    LoadPoint point;
    const double force = point.force = history.normal_force[i];
    if (force <= 0) continue;
    point.approach = history.normal_displacement[i];
    point.stiffness = stiffness_at(numbers.loading, force);
    point.step_error =
        points.size() < numbers.loading.size() ? numbers.loading[points.size()].error : unknown;
    point.unloading_stiffness = stiffness_at(numbers.unloading, force);
    point.contact_area = history.contact_area[i];
    point.mean_pressure = point.contact_area > 0 ? force / point.contact_area : unknown;
    point.largest_pressure = history.max_pressure[i];
    point.plastic_volume = history.plastic_volume[i];
    const double hertz_force = hertz.force(point.approach), borne = force + attraction;
    point.force_ratio = hertz_force > 0 ? borne / hertz_force : unknown;
    point.stiffness_ratio = point.stiffness / hertz.normal_stiffness(borne);
    point.unloading_ratio = point.unloading_stiffness / hertz.normal_stiffness(borne);
    point.area_ratio = point.contact_area / hertz.contact_area(borne);
    point.pressure_ratio = point.largest_pressure / hertz.peak_pressure(borne);
    points.push_back(point);
  }
  return points;
}

}  // namespace

std::vector<TangentStiffness> tangent_stiffness(const Values& approach, const Values& force) {
  std::vector<TangentStiffness> tangents;
  if (force.size() < 3) return tangents;
  Values transformed;
  for (const double f : force) transformed.push_back(std::pow(f, 2.0 / 3.0));
  for (std::size_t i = 0; i < force.size(); ++i) {
    const double to_stiffness = 1.5 * std::cbrt(force[i]);
    const double narrow = slope(approach, transformed, i, 1) * to_stiffness;
    const double wide = force.size() > 3 ? slope(approach, transformed, i, 2) * to_stiffness : unknown;
    tangents.push_back({force[i], approach[i], narrow, std::abs(narrow - wide)});
  }
  return tangents;
}

double stiffness_at(const std::vector<TangentStiffness>& branch, double force) {
  // A load that is a step's own but for rounding counts as inside.
  const double tolerance = 1e-6 * force;
  for (std::size_t i = 0; i + 1 < branch.size(); ++i) {
    const auto& low = branch[i].force < branch[i + 1].force ? branch[i] : branch[i + 1];
    const auto& high = branch[i].force < branch[i + 1].force ? branch[i + 1] : branch[i];
    if (force < low.force - tolerance || force > high.force + tolerance) continue;
    const double share =
        (std::cbrt(force) - std::cbrt(low.force)) / (std::cbrt(high.force) - std::cbrt(low.force));
    return low.stiffness + std::clamp(share, 0.0, 1.0) * (high.stiffness - low.stiffness);
  }
  return unknown;
}

RadiusFit fit_radius(const Values& approach, const Values& force, double reduced_modulus, bool with_offset) {
  const LeastSquaresFit fit = fit_power_law(approach, force, 1.5, with_offset);
  const double largest_force = *std::max_element(force.begin(), force.end());
  const double largest_approach = *std::max_element(approach.begin(), approach.end());
  const double root = largest_force / (4.0 / 3.0 * reduced_modulus * std::pow(largest_approach, 1.5));
  const FittedNumber prefactor = parameter(fit, 0, root);
  RadiusFit result;
  result.radius = {prefactor.value * prefactor.value, 2 * prefactor.value * prefactor.standard_error};
  if (with_offset) result.offset = parameter(fit, 1, largest_approach);
  result.relative_rms = fit.rms_residual;
  return result;
}

ExponentFit fit_exponent(const Values& approach, const Values& force, bool with_offset) {
  const LeastSquaresFit fit = fit_power_law(approach, force, unknown, with_offset);
  ExponentFit result;
  result.exponent = parameter(fit, 1, 1);
  if (with_offset) result.offset = parameter(fit, 2, *std::max_element(approach.begin(), approach.end()));
  result.relative_rms = fit.rms_residual;
  return result;
}

double NormalNumbers::unloading_stiffness() const {
  return unloading.empty() ? unknown : unloading.front().stiffness;
}
double NormalNumbers::loading_stiffness() const {
  return loading.empty() ? unknown : loading.back().stiffness;
}

double NormalNumbers::at_load(double force, double LoadPoint::*member) const {
  const double tolerance = 1e-6 * force;  // a step's own load but for rounding
  for (std::size_t i = 0; i < loads.size(); ++i) {
    if (std::abs(loads[i].force - force) <= tolerance) return loads[i].*member;
    if (i + 1 < loads.size() && loads[i].force < force && force < loads[i + 1].force) {
      const double share = (force - loads[i].force) / (loads[i + 1].force - loads[i].force);
      return loads[i].*member + share * (loads[i + 1].*member - loads[i].*member);
    }
  }
  return unknown;
}

NormalNumbers normal_numbers(const History& history, const Hertz& hertz, double attraction) {
  NormalNumbers numbers;
  numbers.residual_imprint = unknown;
  if (history.size() == 0) return numbers;
  const std::size_t largest = row_of_largest_load(history.normal_force);
  numbers.largest_force = history.normal_force[largest];
  numbers.approach_there = history.normal_displacement[largest];
  numbers.plastic_volume = history.plastic_volume.back();
  numbers.dissipated_energy = history.dissipated_energy.back();

  bool loaded = false, unloaded = false, reloaded = false;
  Branch first_loading;
  HistoryBranch loading_range;
  for (const auto& range : history_branches(history)) {
    const Branch branch = branch_of(history, range, attraction);
    if (range.kind == HistoryBranch::Kind::loading && !loaded) {
      loaded = true;
      first_loading = branch;
      numbers.loading = tangents_of(branch, attraction);
      loading_range = range;
      // Four numbers at most are fitted; fewer steps would leave nothing to judge the misfit by.
      constexpr std::size_t fewest_for_fits = 5;
      if (branch.force.size() >= fewest_for_fits) {
        try {
          numbers.radius = fit_radius(branch.approach, branch.force, hertz.reduced_modulus, false);
          numbers.radius_with_offset = fit_radius(branch.approach, branch.force, hertz.reduced_modulus, true);
          numbers.exponent = fit_exponent(branch.approach, branch.force, false);
          numbers.exponent_with_offset = fit_exponent(branch.approach, branch.force, true);
          numbers.has_fits = true;
        } catch (const WorkError&) {
          numbers.has_fits =
              false;  // a history no power law describes has no fit; the curves are shown anyway
        }
      }
    } else if (range.kind == HistoryBranch::Kind::unloading && !unloaded) {
      unloaded = true;
      numbers.unloading = tangents_of(branch, attraction);
      const auto of_range = [&](const Values& column) {
        return Values(column.begin() + static_cast<long>(range.first),
                      column.begin() + static_cast<long>(range.last) + 1);
      };
      const ResidualImprint left =
          residual_imprint(first_loading.approach, first_loading.force, of_range(history.normal_displacement),
                           of_range(history.normal_force));
      numbers.imprint_force = left.force;
      numbers.residual_imprint = left.depth;
    } else if (range.kind == HistoryBranch::Kind::loading && unloaded && !reloaded) {
      reloaded = true;
      numbers.reloading = tangents_of(branch, attraction);
    }
  }
  if (loaded) numbers.loads = load_points(history, loading_range, hertz, attraction, numbers);
  return numbers;
}

}  // namespace asperity

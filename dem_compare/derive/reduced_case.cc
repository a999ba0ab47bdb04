#include "dem_compare/derive/reduced_case.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "dem_compare/cases/normal_numbers.h"
#include "results/energy_balance.h"
#include "results/region_edge.h"

namespace asperity {
namespace {

/// Of F = K delta^(3/2) - F0 over the first loading.
struct AttractionFit {
  double attraction = 0;   ///< F0, not below zero [N]
  double relative_sd = 0;  ///< of K [-]
};

AttractionFit fitted_attraction(const NormalNumbers& numbers) {
  std::vector<double> x, y;
  for (const auto& point : numbers.loads)
    if (point.approach > 0) x.push_back(std::pow(point.approach, 1.5)), y.push_back(point.force);
  constexpr std::size_t fewest = 4;
  if (x.size() < fewest) return {};
  const double n = static_cast<double>(x.size()), mean_x = scatter_of(x).mean, mean_y = scatter_of(y).mean;
  double square = 0, product = 0, misfit = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    square += (x[i] - mean_x) * (x[i] - mean_x);
    product += (x[i] - mean_x) * (y[i] - mean_y);
  }
  const double slope = product / square, attraction = slope * mean_x - mean_y;
  if (!(attraction > 0)) return {};
  for (std::size_t i = 0; i < x.size(); ++i) misfit += std::pow(y[i] - mean_y - slope * (x[i] - mean_x), 2);
  return {attraction, std::sqrt(misfit / (n - 2) / square) / slope};
}

std::optional<NormalFit> fit_of(const ReducedCase& reduced, const NormalNumbers& numbers) {
  std::vector<double> approach, force;
  for (const auto& point : numbers.loads) {
    approach.push_back(point.approach);
    force.push_back(point.force + reduced.attraction);
  }
  // Asperities touch before the spheres would: only an offset gives back the stiffness of a rough contact.
  const bool with_offset = reduced.is_rough;
  const std::size_t fewest = with_offset ? 4 : 3;
  if (force.size() < fewest) return std::nullopt;
  const Hertz& hertz = reduced.hertz;
  NormalFit fit;
  try {
    const RadiusFit radius = fit_radius(approach, force, hertz.reduced_modulus, with_offset);
    const FittedNumber& fitted = radius.radius;
    const double modulus = hertz.reduced_modulus * std::sqrt(fitted.value / hertz.radius);
    fit.radius = reduced.number(fitted.value, fitted.standard_error);
    fit.modulus = reduced.number(modulus, modulus * fitted.standard_error / (2 * fitted.value));
    fit.offset = radius.offset.value;
    fit.misfit = radius.relative_rms;
  } catch (const WorkError&) {
    return std::nullopt;  // no Hertzian curve describes it; the caller says which cases were fitted
  }
  if (numbers.has_fits) {
    const ExponentFit& exponent = with_offset ? numbers.exponent_with_offset : numbers.exponent;
    fit.exponent = exponent.exponent.value;
    fit.exponent_error = exponent.exponent.standard_error;
  }
  const auto [least, most] = std::minmax_element(force.begin(), force.end());
  fit.loads = {*least - reduced.attraction, *most - reduced.attraction};
  fit.steps = force.size();
  return fit;
}

std::optional<CaseNumber> stiffness_of(const ReducedCase& reduced, const NormalNumbers& numbers) {
  CaseNumber number = reduced.effective(normal_stiffness_key);
  if (!reduced.solved->finished() || !reduced.solved->result->has(normal_stiffness_key))
    number = reduced.number(numbers.unloading_stiffness(),
                            numbers.unloading.empty() ? unknown : numbers.unloading.front().error);
  return number.value > 0 ? std::optional(number) : std::nullopt;
}

/// First loading and first unloading of the steps that bear; empty without either.
std::optional<LoadUnload> load_unload_of(const History& history) {
  LoadUnload curve;
  for (const HistoryBranch& branch : history_branches(history)) {
    const bool loads = branch.kind == HistoryBranch::Kind::loading;
    if (branch.kind == HistoryBranch::Kind::hold) continue;
    if (loads != (curve.loading == 0)) return std::nullopt;  // another order
    for (std::size_t i = branch.first; i <= branch.last; ++i) {
      const bool is_turning_point = !loads && i == branch.first;
      if (is_turning_point || (loads && !(history.normal_force[i] > 0))) continue;
      curve.approach.push_back(history.normal_displacement[i]);
      curve.force.push_back(history.normal_force[i]);
    }
    if (!loads) return curve;
    curve.loading = curve.force.size();
    if (curve.loading == 0) return std::nullopt;
  }
  return std::nullopt;
}

void reduce_yielding(const History& history, ReducedCase& reduced) {
  for (std::size_t i = 0; i < history.size(); ++i) {
    if (!(history.plastic_volume[i] > 0)) continue;
    if (!reduced.yields()) reduced.yielded_from = history.normal_force[i];
    reduced.plastic_volume = std::max(reduced.plastic_volume, history.plastic_volume[i]);
  }
  if (reduced.yields() && reduced.is_pressed()) reduced.yielded = load_unload_of(history);
}

ReducedCase reduced(const SolvedCase& solved) {
  ReducedCase reduced;
  reduced.solved = &solved;
  reduced.motion = solved.motion();
  reduced.hertz = solved.hertz();
  reduced.is_rough = solved.is_rough();
  reduced.relaxes = solved.relaxes();
  ContactInputs beside_the_force = solved.entries.all();
  beside_the_force.erase("Interface/Attraction force");
  reduced.is_adhesive = adheres(beside_the_force);
  reduced.attraction = solved.attraction_force();
  reduced.realisation = realisation_of(solved);
  reduced.spacing = solved.interface_spacing();
  NormalNumbers numbers = normal_numbers(solved.history, reduced.hertz, reduced.attraction);
  AttractionFit adhesion;
  if (reduced.is_adhesive && !reduced.is_rough) {
    adhesion = fitted_attraction(numbers);
    reduced.attraction = std::max(reduced.attraction, adhesion.attraction);
    numbers = normal_numbers(solved.history, reduced.hertz, reduced.attraction);
  }
  const auto& force = solved.history.normal_force;
  reduced.largest_force = numbers.largest_force;
  if (!force.empty()) reduced.smallest_force = *std::min_element(force.begin(), force.end());
  reduced.normal_fit = fit_of(reduced, numbers);
  if (auto& fit = reduced.normal_fit)
    fit->modulus.sd = std::hypot(fit->modulus.sd, adhesion.relative_sd * fit->modulus.value);
  reduced.normal_stiffness = stiffness_of(reduced, numbers);
  reduce_yielding(solved.history, reduced);
  if (const MotionMode* mode = mode_of(solved)) reduced.moving = moving_case(solved, *mode);
  for (const std::string& doubt : {open_energy_words(solved), region_edge_words(solved)})
    if (!doubt.empty()) reduced.doubts.push_back(doubt);
  return reduced;
}

std::vector<CaseNumber> pressed_by_half_spaces(const ReducedCases& cases, const char* name) {
  std::vector<SolvedNumber> numbers;
  for (const ReducedCase& reduced : cases) {
    const CaseNumber number = reduced.effective(name);
    if (reduced.is_pressed() && number.value > 0)
      numbers.push_back({reduced.solved, number.load, number.value, number.sd});
  }
  return by_half_spaces(numbers, name);
}

}  // namespace

CaseNumber ReducedCase::effective(const char* name) const {
  const EffectiveNumber stated = solved->effective(name);
  return number(stated.value, stated.sd);
}

ReducedSet reduced_set(const ParameterSet& set) {
  ReducedSet all{set.inputs, {}, {}};
  for (const SolvedCase& solved : set.cases) all.cases.push_back(reduced(solved));
  for (const char* name : {normal_stiffness_key, pull_off_key, sliding_mode().stiffness_key,
                           torsion_mode().stiffness_key, rolling_mode().stiffness_key})
    all.by_half_spaces[name] = pressed_by_half_spaces(all.cases, name);
  return all;
}

}  // namespace asperity

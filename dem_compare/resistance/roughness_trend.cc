#include "dem_compare/resistance/roughness_trend.h"

#include <algorithm>
#include <cmath>

#include "core/topography_spec.h"
#include "dem_compare/cases/case_numbers.h"
#include "dem_compare/cases/path_averages.h"
#include "dem_compare/resistance/paired_paths.h"

namespace asperity {
namespace {

using Contacts = std::vector<const MovingContact*>;
using States = std::vector<const MovingState*>;

/// The substrate's surface, whatever its RMS.
std::string spectrum_of(const MovingContact& contact) {
  const auto found = contact.inputs.find("Substrate/Topography");
  const TopographySpec surface =
      found == contact.inputs.end() ? TopographySpec() : TopographySpec(found->second);
  if (!surface.generator()) return surface.canonical();
  GeneratorParameters generator = *surface.generator();
  generator.spectrum.rms = 0;
  return generator.text_without_seed();
}

/// Families of two contacts or more; the rough contact that comes first in the study leads each. Smooth ones
/// belong to all.
std::vector<Contacts> families_of_contacts(const MovingStudy& study) {
  std::vector<Contacts> found;
  std::vector<const MovingContact*> seen;
  for (const auto& lead : study.contacts) {
    if (lead.bodies.rms == 0 || std::count(seen.begin(), seen.end(), &lead)) continue;
    Contacts family{&lead};
    for (const auto& other : study.contacts)
      if (&other != &lead && differ_by_roughness(lead, other)) family.push_back(&other);
    for (const auto* contact : family)
      if (contact->bodies.rms > 0) seen.push_back(contact);
    std::stable_sort(family.begin(), family.end(),
                     [](const auto* a, const auto* b) { return a->bodies.rms < b->bodies.rms; });
    if (family.size() > 1) found.push_back(family);
  }
  return found;
}

/// Slope over RMS of paths on the same surfaces: block by block, so that topography which all of them meet
/// drops out of its error; that of the misfit from a straight line stays.
Trend slope_of(const std::vector<double>& rms, const std::vector<const SteadyPath*>& paths,
               const States& states, DissipationPart part) {
  std::vector<Uncertain> means;
  for (std::size_t i = 0; i < paths.size(); ++i)
    means.push_back(paths[i]->of(part) * (1 / states[i]->scale()));
  Trend trend = fit_trend(rms, means);
  const auto rates = rates_in_common(paths, part);
  if (rates.empty()) return trend;
  std::vector<double> slopes;
  std::vector<Uncertain> means_in_common(paths.size(), {0, 0}), open_balances(paths.size(), {0, 0});
  for (std::size_t k = 0; k < rates.front().size(); ++k) {
    std::vector<Uncertain> y;
    for (std::size_t i = 0; i < paths.size(); ++i) {
      y.push_back({rates[i][k] / states[i]->scale(), 0});
      means_in_common[i].value += y.back().value / static_cast<double>(rates.front().size());
    }
    slopes.push_back(fit_trend(rms, y).slope.value);
  }
  for (std::size_t i = 0; i < paths.size(); ++i)
    if (part == DissipationPart::total && std::isfinite(paths[i]->unbalanced))
      open_balances[i].sd = paths[i]->unbalanced / states[i]->scale();
  const Uncertain paired = mean_of_blocks(slopes);
  const double of_misfit = fit_trend(rms, means_in_common).slope.sd,
               of_balances = fit_trend(rms, open_balances).slope.sd;
  trend.slope = {paired.value, std::max(std::hypot(paired.sd, of_balances), of_misfit)};
  return trend;
}

/// One slope per realisation that all states share; empty if none is shared by all.
std::vector<Trend> slopes_by_realisation(const std::vector<double>& rms, const States& states,
                                         DissipationPart part) {
  std::vector<Trend> slopes;
  for (const auto& lead : states.back()->cases) {
    std::vector<const SteadyPath*> paths;
    for (const auto* state : states)
      for (const auto& item : state->cases)
        if (same_realisation(item.seeds, lead.seeds)) {
          paths.push_back(&item.first);
          break;
        }
    if (paths.size() != states.size()) return {};
    slopes.push_back(slope_of(rms, paths, states, part));
  }
  return slopes;
}

Trend trend_of(const std::vector<double>& rms, const States& states, DissipationPart part) {
  std::vector<Uncertain> means;
  for (const auto* state : states) {
    std::vector<Uncertain> values;
    for (const auto& item : state->cases) values.push_back(item.first.of(part) * (1 / state->scale()));
    means.push_back(mean_of_realisations(values));
  }
  Trend trend = fit_trend(rms, means);
  const auto slopes = slopes_by_realisation(rms, states, part);
  if (slopes.empty()) return trend;
  std::vector<Uncertain> each;
  for (const auto& slope : slopes) each.push_back(slope.slope);
  trend.slope = mean_of_realisations(each);
  return trend;
}

void add_loads(RoughnessTrend& trend) {
  std::vector<double> loads;
  for (const auto* contact : trend.contacts)
    for (const auto* state : contact->of(*trend.mode)) {
      const bool known =
          std::any_of(loads.begin(), loads.end(), [&](double load) { return same_load(load, state->load); });
      if (!known) loads.push_back(state->load);
    }
  std::sort(loads.begin(), loads.end());
  for (const double load : loads) {
    std::vector<double> rms;
    States states;
    for (const auto* contact : trend.contacts)
      if (const MovingState* state = contact->find(*trend.mode, load))
        rms.push_back(contact->bodies.rms), states.push_back(state);
    if (states.size() < 2) continue;
    trend.loads.push_back(
        {load, trend_of(rms, states, DissipationPart::total),
         trend_of(rms, states, DissipationPart::friction), trend_of(rms, states, DissipationPart::plastic),
         trend_of(rms, states, DissipationPart::adhesion), trend_of(rms, states, DissipationPart::force)});
  }
  std::vector<Uncertain> relative;
  for (const auto& at : trend.loads) relative.push_back(at.total.relative());
  trend.relative = cautious_mean(relative);
}

void add_coefficients(RoughnessTrend& trend) {
  std::vector<double> rms;
  std::vector<Uncertain> values;
  for (const auto* contact : trend.contacts) {
    std::vector<double> loads;
    std::vector<Uncertain> resistances;
    for (const auto* state : contact->of(*trend.mode)) {
      const double length = trend.mode == &sliding_mode() ? 1 : contact->bodies.radius;
      loads.push_back(state->load);
      resistances.push_back(state->resistance * (1 / length));
    }
    if (loads.size() < 2) continue;
    trend.coefficients.push_back(coefficient_over_loads(contact->bodies.rms, loads, resistances));
    rms.push_back(contact->bodies.rms);
    values.push_back(trend.coefficients.back().coefficient);
  }
  trend.coefficient = fit_trend(rms, values);
}

}  // namespace

CoefficientOverLoads coefficient_over_loads(double rms, const std::vector<double>& loads,
                                            const std::vector<Uncertain>& resistances) {
  // mu is the slope; mu h the value at no load.
  const Trend line = fit_trend(loads, resistances);
  double mean_load = 0;
  for (const double load : loads) mean_load += load / static_cast<double>(loads.size());
  const Uncertain offset = ratio(line.mean, line.slope);
  return {rms, line.slope, {offset.value - mean_load, offset.sd}};
}

Trend::Sign RoughnessTrend::sign() const { return sign_of(relative); }

Uncertain RoughnessTrend::relative_of(Trend TrendAtLoad::*part) const {
  std::vector<Uncertain> shares;
  for (const auto& at : loads) {
    const Uncertain& slope = (at.*part).slope;
    shares.push_back({slope.value / at.total.mean.value, slope.sd / std::abs(at.total.mean.value)});
  }
  return cautious_mean(shares);
}

bool differ_by_roughness(const MovingContact& one, const MovingContact& other) {
  const auto differ = differing_inputs(one, other);
  if (differ.size() != 1 || differ.front() != "Substrate/Topography") return false;
  if (!std::isfinite(one.bodies.rms) || !std::isfinite(other.bodies.rms) ||
      one.bodies.rms == other.bodies.rms)
    return false;
  return spectrum_of(one) == spectrum_of(other) || one.bodies.rms == 0 || other.bodies.rms == 0;
}

std::vector<RoughnessTrend> roughness_trends(const MovingStudy& study) {
  std::vector<RoughnessTrend> trends;
  for (const auto& family : families_of_contacts(study))
    for (const MotionMode* mode : all_motions()) {
      RoughnessTrend trend;
      trend.mode = mode;
      for (const auto* contact : family)
        if (!contact->of(*mode).empty()) trend.contacts.push_back(contact);
      add_loads(trend);
      if (trend.loads.empty()) continue;
      add_coefficients(trend);
      trends.push_back(std::move(trend));
    }
  return trends;
}

}  // namespace asperity

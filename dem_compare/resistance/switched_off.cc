#include "dem_compare/resistance/switched_off.h"

#include <algorithm>
#include <optional>

#include "dem_compare/cases/case_numbers.h"
#include "dem_compare/cases/path_averages.h"
#include "dem_compare/resistance/paired_paths.h"
#include "dem_compare/resistance/roughness_trend.h"

namespace asperity {
namespace {

using Mechanism = Contribution::Mechanism;

bool is_of(Mechanism mechanism, const std::string& entry) {
  const auto ends_with = [&](const std::string& name) {
    return entry.size() >= name.size() && entry.compare(entry.size() - name.size(), name.size(), name) == 0;
  };
  if (mechanism == Mechanism::adhesion)
    return entry == "Interface/Work of adhesion" || entry == "Interface/Work of adhesion on separation" ||
           entry == "Interface/Adhesion law" || entry == "Interface/Adhesion range";
  if (mechanism == Mechanism::relaxation)
    return ends_with("/Relaxing share") || ends_with("/Relaxation time");
  for (const char* name : {"/Yield stress", "/Hardening modulus", "/Hardening", "/Voce saturation",
                           "/Voce rate", "/Rate sensitivity", "/Rate exponent", "/Creep time"})
    if (ends_with(name)) return true;
  return false;
}

bool has(Mechanism mechanism, const MovingContact& contact) {
  if (mechanism == Mechanism::adhesion) return contact.adheres;
  return mechanism == Mechanism::relaxation ? contact.relaxes : contact.can_yield;
}

std::optional<Mechanism> mechanism_between(const MovingContact& with, const MovingContact& without) {
  const auto differ = differing_inputs(with, without);
  for (const Mechanism mechanism : {Mechanism::yielding, Mechanism::relaxation, Mechanism::adhesion}) {
    if (has(mechanism, with) && !has(mechanism, without) &&
        std::all_of(differ.begin(), differ.end(), [&](const auto& entry) { return is_of(mechanism, entry); }))
      return mechanism;
  }
  return std::nullopt;
}

void compare(const MovingState& with, const MovingState& without, Contribution& result) {
  std::vector<Uncertain> total, friction, plastic, adhesion;
  for (const auto& one : with.cases)
    for (const auto& other : without.cases) {
      if (!same_realisation(one.seeds, other.seeds)) continue;
      total.push_back(paired_difference(one.first, other.first, DissipationPart::total));
      friction.push_back(paired_difference(one.first, other.first, DissipationPart::friction));
      plastic.push_back(paired_difference(one.first, other.first, DissipationPart::plastic));
      adhesion.push_back(paired_difference(one.first, other.first, DissipationPart::adhesion));
      break;
    }
  result.realisations = static_cast<int>(total.size());
  result.whole = with.resistance;
  result.difference = mean_of_realisations(total);
  result.parts = {mean_of_realisations(friction), mean_of_realisations(plastic),
                  mean_of_realisations(adhesion), result.difference};
}

}  // namespace

const char* name_of(Mechanism mechanism) {
  if (mechanism == Mechanism::adhesion) return "adhesion";
  return mechanism == Mechanism::relaxation ? "relaxation" : "yielding";
}

Uncertain Contribution::share() const { return ratio(difference, whole); }

std::vector<Contribution> contributions(const MovingStudy& study) {
  std::vector<Contribution> found;
  for (const auto& with : study.contacts)
    for (const auto& without : study.contacts) {
      const auto mechanism = mechanism_between(with, without);
      if (!mechanism) continue;
      for (const auto& state : with.states) {
        const MovingState* other = without.find(*state.mode, state.load);
        if (!other) continue;
        Contribution contribution;
        contribution.mechanism = *mechanism;
        contribution.with = &with, contribution.without = &without;
        contribution.mode = state.mode, contribution.load = state.load;
        compare(state, *other, contribution);
        if (contribution.realisations > 0) found.push_back(contribution);
      }
    }
  return found;
}

std::vector<ContributionTrend> contribution_trends(const std::vector<Contribution>& contributions) {
  std::vector<ContributionTrend> trends;
  std::vector<bool> used(contributions.size(), false);
  for (std::size_t i = 0; i < contributions.size(); ++i) {
    if (used[i]) continue;
    const Contribution& lead = contributions[i];
    std::vector<const Contribution*> family;
    for (std::size_t k = i; k < contributions.size(); ++k) {
      const Contribution& other = contributions[k];
      if (other.mechanism != lead.mechanism || other.mode != lead.mode || !same_load(other.load, lead.load))
        continue;
      if (&other != &lead && !differ_by_roughness(*lead.with, *other.with)) continue;
      used[k] = true;
      family.push_back(&other);
    }
    if (family.size() < 2) continue;
    std::stable_sort(family.begin(), family.end(),
                     [](const auto* a, const auto* b) { return a->with->bodies.rms < b->with->bodies.rms; });
    std::vector<double> rms;
    std::vector<Uncertain> differences;
    ContributionTrend trend;
    for (const auto* one : family) {
      const double scale = one->with->find(*one->mode, one->load)->scale();
      rms.push_back(one->with->bodies.rms);
      differences.push_back(one->difference * (1 / scale));
      trend.whole += one->whole.value / scale / static_cast<double>(family.size());
    }
    trend.smoothest = family.front(), trend.roughest = family.back();
    trend.difference = fit_trend(rms, differences);
    trends.push_back(trend);
  }
  return trends;
}

}  // namespace asperity

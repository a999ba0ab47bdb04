#include "dem_compare/derive/motion_derivation.h"

#include <algorithm>
#include <cmath>

#include "dem_compare/cases/path_averages.h"
#include "dem_compare/numbers/statistics.h"

namespace asperity {
namespace {

using About = OpenQuestion::About;
using From = Origin::From;

/// Cases of one mode, by load.
using MovedCases = std::vector<const ReducedCase*>;

Uncertain resistance_of(const ReducedCase& item) { return item.moving->resistance(); }

/// One resistance per case, in their order; those at one load share their degrees of freedom.
std::vector<Uncertain> resistances_of(const MovedCases& cases) {
  std::vector<Uncertain> all(cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    std::vector<std::size_t> at_load;
    std::vector<Uncertain> means;
    for (std::size_t k = 0; k < cases.size(); ++k)
      if (same_load(cases[k]->moving->load, cases[i]->moving->load))
        at_load.push_back(k), means.push_back(resistance_of(*cases[k]));
    if (at_load.front() != i) continue;
    means = with_shared_degrees_of_freedom(means);
    for (std::size_t k = 0; k < at_load.size(); ++k) all[at_load[k]] = means[k];
  }
  return all;
}

CaseNumber number_of(const ReducedCase& item, double value, double sd) {
  return {item.moving->load, item.realisation, item.spacing, value, sd};
}

void find_test_of_law(const ResistanceLaw& law, LawFindings& findings) {
  if (!law.has_offset)
    findings.open.push_back({About::offset});
  else if (law.degrees_of_freedom == 0)
    findings.open.push_back({About::test_of_law});
  else
    findings.found.push_back(MisfitFact{law.misfit, law.degrees_of_freedom + 2});
}

/// Stiffness of a contact that was only pressed: `solve` probes it in each direction at the largest load.
std::vector<CaseNumber> probed_when_pressed(const ReducedSet& set, const MotionMode& mode) {
  std::vector<CaseNumber> probed;
  for (const auto& reduced : set.cases) {
    const CaseNumber number = reduced.effective(mode.stiffness_key);
    if (reduced.is_pressed() && number.value > 0) probed.push_back(number);
  }
  for (const auto& number : set.by_half_spaces.at(mode.stiffness_key)) probed.push_back(number);
  return probed;
}

void derive_stiffness(const ReducedSet& set, const MovedCases& seen, Derivation& derivation,
                      LawFindings& findings) {
  const MotionMode& mode = *findings.mode;
  std::vector<CaseNumber> probed = probed_when_pressed(set, mode), reversed;
  bool has_energies = false;
  for (const ReducedCase* item : seen) {
    has_energies = has_energies || item->moving->has_energies();
    const CaseNumber stated = item->effective(mode.stiffness_key);
    if (stated.value > 0) probed.push_back(number_of(*item, stated.value, stated.sd));
    const ReversalStiffness& reversal = item->moving->reversal;
    if (reversal.value > 0) reversed.push_back(number_of(*item, reversal.value, reversal.error));
  }
  ContactParameters& parameters = derivation.parameters;
  const auto radius = [&](double load) { return parameters.contact_radius(load); };
  const auto law_of = [&](const std::vector<CaseNumber>& all) {
    return fit_power(counted_of(all), radius, mode.stiffness_exponent);
  };
  if (probed.empty() && reversed.empty())
    return findings.open.push_back(
        {&mode == &rolling_mode() ? About::rolling_stiffness : About::stiffness, Derived::stiffness, &mode});
  const std::vector<CaseNumber>& written = probed.empty() ? reversed : probed;
  const PowerLaw law = law_of(written);
  const auto source = !probed.empty()                            ? StiffnessSource::probe
                      : &mode == &rolling_mode() && has_energies ? StiffnessSource::second_pass
                                                                 : StiffnessSource::reversal;
  findings.found.push_back(StiffnessFact{&mode, source, law, counted_of(written)});
  if (!probed.empty() && !reversed.empty()) {
    const PowerLaw reversal = law_of(reversed);
    findings.found.push_back(ReversalFact{&mode, reversal});
    findings.details["reversal_stiffness"] = {
        {"value", reversal.value}, {"sd", reversal.sd}, {"at_load", reversal.at_load}};
  }
  find_growth(law, mode.stiffness_exponent, Derived::stiffness, findings);
  find_scatter_and_mesh(written, Derived::stiffness, findings);
  parameters.*mode.stiffness =
      EffectiveQuantity{law.value, law.sd, law.loads, LengthScale::contact_radius, law.at_load};
  const Origin from_cases{From::cases, unknown, "", written};
  auto& origin =
      derivation.origin_of(mode.stiffness) = {{From::stiffness, unknown, "", {}, source}, from_cases};
  if (mode.stiffness_exponent != 1) origin.push_back({From::smooth_growth, mode.stiffness_exponent});
  if (&mode != &sliding_mode()) return;
  constexpr double mindlin = 8;
  const double to_modulus = 1 / (mindlin * radius(law.at_load));
  parameters.reduced_shear_modulus =
      EffectiveQuantity{law.value * to_modulus, law.sd * to_modulus, law.loads};
  derivation.origin_of(&ContactParameters::reduced_shear_modulus) = {{From::lateral_stiffness}, from_cases};
}

/// One fact per load.
void find_resistances(const MovedCases& used, const std::vector<Uncertain>& resistances,
                      LawFindings& findings) {
  for (std::size_t i = 0; i < used.size();) {
    std::size_t end = i;
    while (end < used.size() && same_load(used[end]->moving->load, used[i]->moving->load)) ++end;
    const auto count = static_cast<double>(end - i);
    MeanResistanceFact fact{findings.mode, used[i]->moving->load, {0, 0}, static_cast<int>(end - i)};
    double variance = 0;
    for (; i < end; ++i) {
      const Uncertain& resistance = resistances[i];
      const SteadyPath& path = used[i]->moving->first;
      fact.mean.value += resistance.value / count;
      variance += resistance.sd * resistance.sd / (count * count);
      fact.fluctuation += path.fluctuation / resistance.value / count;
      fact.independent += path.independent;
    }
    fact.mean.sd = std::sqrt(variance);
    findings.found.push_back(fact);
  }
}

std::vector<std::string> folders_of(const MovedCases& cases) {
  std::vector<std::string> folders;
  for (const ReducedCase* item : cases) folders.push_back(item->folder());
  return folders;
}

/// What the paths of the cases were too short for.
void find_short_paths(const MovedCases& used, LawFindings& findings) {
  MovedCases changing;
  double shortest = std::numeric_limits<double>::infinity(), largest_drift = 0;
  for (const ReducedCase* item : used) {
    shortest = std::min(shortest, item->moving->steady_length() / (2 * item->moving->largest_contact_radius));
    if (!item->moving->first.still_changes()) continue;
    changing.push_back(item);
    largest_drift = std::max(largest_drift, std::abs(item->moving->first.drift));
  }
  const MotionMode* mode = findings.mode;
  if (!changing.empty())
    findings.open.push_back(
        {About::end_of_change, Derived::resistance, mode, largest_drift, folders_of(changing)});
  constexpr double diameters_wanted = 2;
  if (mode->path_is_length && shortest < diameters_wanted)
    findings.open.push_back({About::long_paths, Derived::resistance, mode, shortest});
}

nlohmann::ordered_json moved_case_json(const ReducedCase& item) {
  const MovingCase& moving = *item.moving;
  return {{"folder", item.folder()},
          {"load", moving.load},
          {"mean", moving.resistance().value},
          {"standard_error", moving.resistance().sd},
          {"is_dissipation", moving.has_energies()},
          {"fluctuation", moving.first.fluctuation},
          {"independent_stretches", moving.first.independent},
          {"way", moving.steady_length()},
          {"drift", moving.first.drift}};
}

/// Of torsion, whose moment where all slips is that of the pressures: more surfaces, as numbers and as points
/// of the fit.
double add_half_spaces(const MovedCases& used, const std::vector<Uncertain>& resistances,
                       const ContactParameters& parameters, LawFindings& findings,
                       std::vector<CaseNumber>& all) {
  if (findings.mode != &torsion_mode()) return 0;
  double shared = 0;
  std::vector<SolvedNumber> solved;
  for (std::size_t i = 0; i < used.size(); ++i)
    solved.push_back({used[i]->solved, used[i]->moving->load, resistances[i].value, resistances[i].sd});
  for (const auto& number : by_half_spaces(solved, "slipping_moment")) {
    all.push_back(number);
    shared = std::max(shared, number.shared_sd / number.value);
    findings.points.push_back({number.load, number.value, number.sd, number.realisation,
                               parameters.particle.radius, parameters.contact_radius(number.load)});
  }
  return shared;
}

/// What went in, beside what came out.
void add_local_friction(const Derivation& derivation, LawFindings& findings, std::vector<Origin>& origin) {
  const auto local = derivation.inputs.find("Interface/Friction coefficient");
  if (local == derivation.inputs.end()) return;
  origin.push_back({From::local_friction, unknown, local->second});
  findings.found.push_back(LocalFrictionFact{local->second});
}

void derive_resistance(const MovedCases& seen, Derivation& derivation, LawFindings& findings) {
  const MotionMode& mode = *findings.mode;
  ContactParameters& parameters = derivation.parameters;
  std::vector<CaseNumber> all;
  MovedCases steady, sticking, used;
  for (const ReducedCase* item : seen) {
    (item->moving->reached() ? steady : sticking).push_back(item);
    if (item->moving->reached())
      all.push_back(number_of(*item, resistance_of(*item).value, resistance_of(*item).sd));
  }
  if (!sticking.empty())
    findings.open.push_back({About::slip, Derived::resistance, &mode, unknown, folders_of(sticking)});
  if (all.empty()) return;
  const std::vector<std::size_t> on_mesh = on_one_mesh(all);
  for (const auto i : on_mesh) used.push_back(steady[i]);
  const std::vector<Uncertain> resistances = resistances_of(used);
  for (std::size_t i = 0; i < used.size(); ++i) {
    const CaseNumber& number = all[on_mesh[i]];
    findings.points.push_back({number.load, resistances[i].value, resistances[i].sd, number.realisation,
                               parameters.particle.radius, parameters.contact_radius(number.load)});
    findings.details["resistance"].push_back(moved_case_json(*used[i]));
  }
  const double shared = add_half_spaces(used, resistances, parameters, findings, all);
  find_resistances(used, resistances, findings);
  find_short_paths(used, findings);

  const bool is_dissipation = std::all_of(
      used.begin(), used.end(), [](const ReducedCase* item) { return item->moving->has_energies(); });
  const From from = !is_dissipation            ? From::steady_resistance
                    : &mode == &sliding_mode() ? From::dissipation_per_length
                                               : From::dissipation_per_angle;
  std::vector<Origin> origin{{from}, {From::cases, unknown, "", all}}, odds;
  if (is_dissipation) findings.found.push_back(DissipationFact{&mode});
  EffectiveQuantity &friction = (parameters.*mode.friction).emplace(),
                    &offset = (parameters.*mode.offset).emplace();
  ResistanceLaw law;
  if (mode.has_length) {
    const LengthChoice choice = choose_length(findings.points);
    law = choice.law();
    friction.length_scale = choice.scale();
    find_length(choice, findings);
    findings.details["length"] = to_json(choice);
    odds = {{From::odds, choice.log_odds}};
  } else {
    law = fit_resistance(findings.points, LengthScale::none);
    findings.found.push_back(LawFact{law});
    findings.details["law"] = to_json(law);
  }
  find_test_of_law(law, findings);
  find_scatter_and_mesh(all, Derived::resistance, findings);
  friction.value = law.coefficient;
  friction.sd = std::hypot(law.coefficient_sd(), shared * law.coefficient);
  offset.value = law.offset;
  if (law.has_offset) offset.sd = law.offset_sd();
  friction.load_range = offset.load_range = law.loads;
  derivation.origin_of(mode.offset) = law.has_offset ? origin : std::vector<Origin>{{From::no_offset}};
  origin.insert(origin.end(), odds.begin(), odds.end());
  add_local_friction(derivation, findings, origin);
  derivation.origin_of(mode.friction) = origin;
}

}  // namespace

void derive_motion(const ReducedSet& set, const MotionMode& mode, Derivation& derivation) {
  LawFindings findings;
  findings.mode = &mode;
  MovedCases seen;
  for (const auto& reduced : set.cases)
    if (reduced.motion == mode.motion) seen.push_back(&reduced);
  std::stable_sort(seen.begin(), seen.end(), [](const ReducedCase* a, const ReducedCase* b) {
    return a->moving->load < b->moving->load;
  });
  if (seen.empty()) {
    findings.open.push_back({About::experiment, Derived::resistance, &mode});
  } else {
    derive_resistance(seen, derivation, findings);
    derive_stiffness(set, seen, derivation, findings);
  }
  derivation.laws.push_back(std::move(findings));
}

}  // namespace asperity

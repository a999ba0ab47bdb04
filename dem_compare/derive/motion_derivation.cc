#include "dem_compare/derive/motion_derivation.h"

#include <algorithm>
#include <cmath>

#include "core/printed.h"
#include "dem_compare/cases/moving_case.h"
#include "dem_compare/derive/length_choice.h"
#include "dem_compare/derive/power_law.h"
#include "dem_compare/derive/rolling_stiffness.h"
#include "dem_compare/numbers/statistics.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

/// One case of the mode.
struct MotionCase {
  const SolvedCase* solved = nullptr;
  MovingCase moving;  ///< its steady resistance
  double load = 0, contact_radius = unknown;
  ReversalStiffness reversal;
  double probed_stiffness = unknown, probed_sd = unknown;  ///< by `solve`, without slip

  Uncertain resistance() const { return moving.resistance(); }
  double path() const {
    return moving.first.path + (moving.has_energies() || !moving.back.reached() ? 0 : moving.back.path);
  }
  CaseNumber number(double value, double sd) const {
    return {load, realisation_of(*solved), solved->interface_spacing(), value, sd};
  }
};

MotionCase observe(const SolvedCase& solved, const MotionMode& mode) {
  MotionCase seen;
  seen.solved = &solved;
  const EnergyHistory history = energy_history(solved, mode);
  if (history.size() == 0) return seen;
  seen.moving = moving_case(solved, history, path_of(mode, solved.hertz().radius));
  seen.load = seen.moving.reached()
                  ? seen.moving.load
                  : *std::max_element(history.normal_force.begin(), history.normal_force.end());
  seen.contact_radius = *std::max_element(history.contact_radius.begin(), history.contact_radius.end());
  if (seen.moving.reached()) {
    const double steady = seen.resistance().value;
    const bool by_topography = &mode == &rolling_mode() && seen.moving.has_energies();
    seen.reversal = by_topography
                        ? rolling_stiffness(history.position, history.resistance, steady)
                        : reversal_stiffness(history.position, history.resistance, steady, mode.partial_slip);
    if (by_topography && seen.contact_radius > 0)
      seen.reversal.error =
          std::hypot(seen.reversal.error, rolling_stiffness_mesh_error * solved.interface_spacing() /
                                              seen.contact_radius * seen.reversal.value);
  }
  const EffectiveNumber probed = solved.effective(mode.stiffness_key);
  seen.probed_stiffness = probed.value, seen.probed_sd = probed.sd;
  return seen;
}

void tell_test_of_law(const ResistanceLaw& law, LawReport& report) {
  if (!law.has_offset)
    report.not_identifiable.push_back(
        "h: one load cannot part mu f from mu h; solve a case at a tenth or ten times the load");
  else if (law.degrees_of_freedom == 0)
    report.not_identifiable.push_back(
        "whether the law holds: it passes through two cases whatever they are, and its uncertainty takes "
        "each for "
        "good to a thousandth; solve a third load");
  else
    report.findings.push_back("misfit of the law: " + percent(law.misfit) + " (root mean square of " +
                              std::to_string(law.degrees_of_freedom + 2) + " cases)");
}

void derive_motion_stiffness(const MotionMode& mode, const std::vector<MotionCase>& seen,
                             ContactParameters& parameters, LawReport& report) {
  std::vector<CaseNumber> probed, reversed;
  for (const auto& item : seen) {
    if (item.probed_stiffness > 0) probed.push_back(item.number(item.probed_stiffness, item.probed_sd));
    if (item.reversal.value > 0) reversed.push_back(item.number(item.reversal.value, item.reversal.error));
  }
  const auto radius = [&](double load) { return parameters.contact_radius(load); };
  const auto law_of = [&](const std::vector<CaseNumber>& all) {
    return fit_power(counted_of(all), radius, mode.stiffness_exponent);
  };
  if (probed.empty() && reversed.empty()) {
    report.not_identifiable.push_back(
        "the stiffness: no case was reversed after full slip; set Experiment/Reverse = true" +
        std::string(&mode == &rolling_mode() ? " and Experiment/Return distance to a contact radius or more"
                                             : ""));
    return;
  }
  const std::vector<CaseNumber>& written = probed.empty() ? reversed : probed;
  const PowerLaw law = law_of(written);
  const bool rolled = &mode == &rolling_mode() && std::any_of(seen.begin(), seen.end(), [](const auto& item) {
    return item.moving.has_energies();
  });
  const char* source = !probed.empty() ? "without slip"
                       : rolled        ? "of rolling back in a second pass, to half the loop's width"
                                       : "slope after the reversal";
  report.findings.push_back(
      std::string("stiffness ") + source + ": " + with_error(law.value, law.sd, mode.stiffness_unit) +
      " at " + format_quantity(law.at_load, Dimension::force) + "; " + extent_of(counted_of(written)));
  if (!probed.empty() && !reversed.empty()) {
    const PowerLaw reversal = law_of(reversed);
    report.findings.push_back("slope after the reversal, partial slip taken out: " +
                              with_error(reversal.value, reversal.sd, mode.stiffness_unit) + " at " +
                              format_quantity(reversal.at_load, Dimension::force));
    report.details["reversal_stiffness"] = {
        {"value", reversal.value}, {"sd", reversal.sd}, {"at_load", reversal.at_load}};
  }
  tell_exponent(law, mode.stiffness_exponent, "the stiffness", report);
  tell_scatter_and_mesh(written, "the stiffness", report);
  std::string provenance = std::string(source) + "; " + source_of(written);
  if (mode.stiffness_exponent != 1)
    provenance += "; of a smooth contact it grows as a^" + with_error(mode.stiffness_exponent, unknown, "") +
                  ", not as a";
  parameters.*mode.stiffness =
      EffectiveQuantity{law.value, law.sd, law.loads, LengthScale::contact_radius, law.at_load, provenance};
  if (&mode != &sliding_mode()) return;
  constexpr double mindlin = 8;
  const double to_modulus = 1 / (mindlin * radius(law.at_load));
  parameters.reduced_shear_modulus =
      EffectiveQuantity{law.value * to_modulus,
                        law.sd * to_modulus,
                        law.loads,
                        LengthScale::none,
                        unknown,
                        "k_l = 8 G* a fitted, a Hertz' with E* of this file; " + source_of(written)};
}

/// One line per load.
void tell_resistances(const MotionMode& mode, const std::vector<const MotionCase*>& used, LawReport& report) {
  for (std::size_t i = 0; i < used.size();) {
    std::size_t end = i;
    double mean = 0, variance = 0, fluctuation = 0, independent = 0;
    while (end < used.size() && same_load(used[end]->load, used[i]->load)) ++end;
    const auto count = static_cast<double>(end - i);
    for (std::size_t k = i; k < end; ++k) {
      const Uncertain resistance = used[k]->resistance();
      mean += resistance.value / count;
      variance += resistance.sd * resistance.sd / (count * count);
      fluctuation += used[k]->moving.first.fluctuation / resistance.value / count;
      independent += used[k]->moving.first.independent;
    }
    report.findings.push_back("at " + format_quantity(used[i]->load, Dimension::force) + ": " +
                              with_error(mean, std::sqrt(variance), mode.resistance_unit) +
                              (count > 1 ? ", mean of " + std::to_string(end - i) + " realisations" : "") +
                              "; fluctuation along the path " + percent(fluctuation) + ", " +
                              with_error(std::round(independent), unknown, "") + " independent blocks");
    i = end;
  }
}

std::string folders_of(const std::vector<const MotionCase*>& cases) {
  std::string text;
  for (const MotionCase* item : cases) text += (text.empty() ? "" : ", ") + item->solved->folder.string();
  return text;
}

/// What the paths of the cases were too short for.
void tell_paths(const MotionMode& mode, const std::vector<const MotionCase*>& used, LawReport& report) {
  std::vector<const MotionCase*> changing;
  double shortest = std::numeric_limits<double>::infinity(), largest_drift = 0;
  for (const MotionCase* item : used) {
    shortest = std::min(shortest, item->path() / (2 * item->contact_radius));
    if (!item->moving.first.still_changes()) continue;
    changing.push_back(item);
    largest_drift = std::max(largest_drift, std::abs(item->moving.first.drift));
  }
  if (!changing.empty())
    report.not_identifiable.push_back("where the resistance ends: it still changes, by up to " +
                                      percent(largest_drift) +
                                      " from the first half of the path to the second (" +
                                      folders_of(changing) + "); set " + mode.path_entry + " to more");
  constexpr double diameters_wanted = 2;
  if (mode.path_is_length && shortest < diameters_wanted)
    report.not_identifiable.push_back("fluctuation over long paths: the shortest steady path is " +
                                      with_error(std::round(10 * shortest) / 10, unknown, "") +
                                      " contact diameters, two or more are wanted; set " + mode.path_entry +
                                      " to more");
}

Json moved_case_json(const MotionCase& item) {
  return {{"folder", item.solved->folder.string()},
          {"load", item.load},
          {"mean", item.resistance().value},
          {"standard_error", item.resistance().sd},
          {"is_dissipation", item.moving.has_energies()},
          {"fluctuation", item.moving.first.fluctuation},
          {"independent_stretches", item.moving.first.independent},
          {"way", item.path()},
          {"drift", item.moving.first.drift}};
}

void derive_resistance(const MotionMode& mode, const std::vector<MotionCase>& seen,
                       ContactParameters& parameters, LawReport& report) {
  std::vector<CaseNumber> all;
  std::vector<const MotionCase*> steady, sticking, used;
  for (const auto& item : seen) {
    (item.moving.reached() ? steady : sticking).push_back(&item);
    if (item.moving.reached()) all.push_back(item.number(item.resistance().value, item.resistance().sd));
  }
  if (!sticking.empty())
    report.not_identifiable.push_back(
        "the resistance of cases that did not slip fully, or for fewer than three steps (" +
        folders_of(sticking) + "): set " + mode.path_entry + " to more");
  if (all.empty()) return;
  std::vector<ResistancePoint> points;
  for (const auto i : on_one_mesh(all)) {
    used.push_back(steady[i]);
    points.push_back({all[i].load, all[i].value, all[i].sd, all[i].realisation, parameters.particle.radius,
                      parameters.contact_radius(all[i].load)});
    report.details["resistance"].push_back(moved_case_json(*steady[i]));
  }
  tell_resistances(mode, used, report);
  tell_paths(mode, used, report);

  EffectiveQuantity friction, offset;
  ResistanceLaw law;
  const bool is_dissipation = std::all_of(used.begin(), used.end(),
                                          [](const MotionCase* item) { return item->moving.has_energies(); });
  const char* per = &mode == &sliding_mode() ? "path length" : "angle";
  const std::string provenance =
      (is_dissipation ? std::string("energy dissipated per ") + per +
                            " by slip, yielding and bonds on the steady first pass; "
                      : "steady resistance after full slip; ") +
      source_of(all);
  if (is_dissipation)
    report.findings.push_back(std::string("The resistance is the energy dissipated per ") + per +
                              ": the conservative topographic part is not in it.");
  if (mode.has_length) {
    const LengthChoice choice = choose_length(points);
    law = choice.law();
    friction.length_scale = choice.scale();
    tell_choice(choice, report);
    report.details["length"] = to_json(choice);
    friction.provenance = provenance + printed("; ln of the odds for a over r: %.3g", choice.log_odds);
  } else {
    law = fit_resistance(points, LengthScale::none);
    report.findings.push_back(to_text(law));
    report.details["law"] = to_json(law);
    friction.provenance = provenance;
  }
  report.points = points;
  tell_test_of_law(law, report);
  tell_scatter_and_mesh(all, "the resistance", report);
  friction.value = law.coefficient;
  friction.sd = law.coefficient_sd();
  offset.value = law.offset;
  if (law.has_offset) offset.sd = law.offset_sd();
  friction.load_range = offset.load_range = law.loads;
  offset.provenance = law.has_offset ? provenance : "one load cannot tell it; zero is assumed";
  parameters.*mode.friction = friction;
  parameters.*mode.offset = offset;
}

/// Local friction is an input of the cases: of the effective one, only what departs from it is found.
void tell_local_friction(const ParameterSet& set, const MotionMode& mode, ContactParameters& parameters,
                         LawReport& report) {
  auto& friction = parameters.*mode.friction;
  if (!friction) return;
  for (const auto& [entry, value] : set.inputs)
    if (entry == "Interface/Friction coefficient") {
      friction->provenance += "; local friction coefficient that went in: " + value;
      report.findings.push_back("The local friction coefficient of " + value +
                                " went in; what comes out follows from it.");
    }
}

}  // namespace

LawReport derive_motion(const ParameterSet& set, const MotionMode& mode, ContactParameters& parameters) {
  LawReport report;
  report.motion = mode.motion;
  report.title = mode.title;
  std::vector<MotionCase> seen;
  for (const auto& solved : set.cases)
    if (solved.motion() == mode.motion) seen.push_back(observe(solved, mode));
  std::stable_sort(seen.begin(), seen.end(),
                   [](const MotionCase& a, const MotionCase& b) { return a.load < b.load; });
  if (seen.empty()) {
    report.not_identifiable.push_back("all of it: there is no case with Experiment/Type = " +
                                      name_of(mode.motion));
    return report;
  }
  derive_resistance(mode, seen, parameters, report);
  tell_local_friction(set, mode, parameters, report);
  derive_motion_stiffness(mode, seen, parameters, report);
  return report;
}

}  // namespace asperity

#include "dem_compare/derive/motion_derivation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "dem_compare/derive/length_choice.h"
#include "dem_compare/derive/power_law.h"
#include "dem_compare/derive/rolling_stiffness.h"
#include "dem_compare/resistance/moving_case.h"
#include "dem_compare/statistics.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

/// One case of the mode.
struct MotionCase {
  const SolvedCase* solved = nullptr;
  double load = 0, contact_radius = unknown;
  SteadyResistance steady;
  bool is_dissipation = false;  ///< steady is energy dissipated per angle
  ReversalStiffness reversal;
  double probed_stiffness = unknown, probed_sd = unknown;  ///< by `solve`, without slip

  CaseNumber number(double value, double sd) const {
    return {load, realisation_of(*solved), solved->interface_spacing(), value, sd};
  }
};

/// As `steady_resistance` tells of a moment; none where the history holds no energies.
std::optional<SteadyResistance> dissipated_in_rolling(const SolvedCase& solved) {
  const auto moving = rolled_with_energies(solved);
  if (!moving) return std::nullopt;
  SteadyResistance steady;
  const SteadyWay& way = moving->first;
  if (!way.reached() || !std::isfinite(way.dissipated.total.value)) return steady;
  steady.reached = true;
  steady.mean = way.resistance().value;
  steady.standard_error = way.resistance().sd;
  steady.independent = way.stretches;
  steady.fluctuation = way.dissipated.total.sd * std::sqrt(static_cast<double>(way.stretches));
  steady.way = way.way;
  if (std::isfinite(way.drift + way.drift_error)) steady.drift = way.drift, steady.drift_error = way.drift_error;
  steady.load = moving->load;
  return steady;
}

MotionCase observe(const SolvedCase& solved, const MotionMode& mode) {
  MotionCase seen;
  seen.solved = &solved;
  const ContactHistory& history = solved.history;
  std::vector<double> position, resistance, force;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const double x = (history.*mode.position)[i], y = (history.*mode.resistance)[i],
                 f = history.normal_force[i];
    if (!std::isfinite(x + y + f)) continue;  // cells that are not known
    position.push_back(x), resistance.push_back(y), force.push_back(f);
  }
  if (force.empty()) return seen;
  const auto dissipated = &mode == &rolling_mode() ? dissipated_in_rolling(solved) : std::nullopt;
  seen.is_dissipation = dissipated.has_value();
  seen.steady = dissipated ? *dissipated : steady_resistance(position, resistance, force);
  seen.load = seen.steady.reached ? seen.steady.load : *std::max_element(force.begin(), force.end());
  const auto& radii = history.radius_of_whole();
  seen.contact_radius = *std::max_element(radii.begin(), radii.end());
  if (seen.steady.reached)
    seen.reversal = seen.is_dissipation ? rolling_stiffness(position, resistance, seen.steady.mean)
                                        : reversal_stiffness(position, resistance, seen.steady.mean, mode.partial_slip);
  if (seen.is_dissipation && seen.contact_radius > 0)
    seen.reversal.error = std::hypot(seen.reversal.error, rolling_stiffness_mesh_error * solved.interface_spacing() / seen.contact_radius * seen.reversal.value);
  if (solved.result.contains("effective") && solved.result["effective"].contains(mode.stiffness_key)) {
    const Json& entry = solved.result["effective"][mode.stiffness_key];
    if (entry.contains("value") && entry["value"].is_number())
      seen.probed_stiffness = entry["value"].get<double>();
    if (entry.contains("sd") && entry["sd"].is_number()) seen.probed_sd = entry["sd"].get<double>();
  }
  return seen;
}

void tell_test_of_law(const ResistanceLaw& law, LawReport& report) {
  if (!law.has_offset)
    report.not_told.push_back(
        "h: one load cannot part mu f from mu h; solve a case at a tenth or ten times the load");
  else if (law.degrees_of_freedom == 0)
    report.not_told.push_back(
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
  const auto law_of = [&](const std::vector<CaseNumber>& all) { return fit_power(counted_of(all), radius, mode.stiffness_exponent); };
  if (probed.empty() && reversed.empty()) {
    report.not_told.push_back(
        "the stiffness: no case was reversed after full slip; set Experiment/Reverse = true" +
        std::string(&mode == &rolling_mode() ? " and Experiment/Way back to a contact radius or more" : ""));
    return;
  }
  const std::vector<CaseNumber>& written = probed.empty() ? reversed : probed;
  const PowerLaw law = law_of(written);
  const bool rolled = std::any_of(seen.begin(), seen.end(), [](const auto& item) { return item.is_dissipation; });
  const char* source = !probed.empty() ? "without slip" : rolled ? "of rolling back over the own track, to half the loop's width" : "slope after the reversal";
  report.findings.push_back(std::string("stiffness ") + source + ": " +
                            with_error(law.value, law.sd, mode.stiffness_unit) + " at " +
                            format_quantity(law.at_load, Dimension::force) + "; " + extent_of(counted_of(written)));
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
      const SteadyResistance& steady = used[k]->steady;
      mean += steady.mean / count;
      variance += steady.standard_error * steady.standard_error / (count * count);
      fluctuation += steady.fluctuation / steady.mean / count;
      independent += steady.independent;
    }
    report.findings.push_back("at " + format_quantity(used[i]->load, Dimension::force) + ": " +
                              with_error(mean, std::sqrt(variance), mode.resistance_unit) +
                              (count > 1 ? ", mean of " + std::to_string(end - i) + " realisations" : "") +
                              "; fluctuation along the way " + percent(fluctuation) + ", " +
                              with_error(std::round(independent), unknown, "") + " independent stretches");
    i = end;
  }
}

std::string folders_of(const std::vector<const MotionCase*>& cases) {
  std::string text;
  for (const MotionCase* item : cases) text += (text.empty() ? "" : ", ") + item->solved->folder.string();
  return text;
}

/// What the ways of the cases were too short for.
void tell_ways(const MotionMode& mode, const std::vector<const MotionCase*>& used, LawReport& report) {
  std::vector<const MotionCase*> changing;
  double shortest = std::numeric_limits<double>::infinity(), largest_drift = 0;
  for (const MotionCase* item : used) {
    shortest = std::min(shortest, item->steady.way / (2 * item->contact_radius));
    if (!item->steady.still_changes()) continue;
    changing.push_back(item);
    largest_drift = std::max(largest_drift, std::abs(item->steady.drift));
  }
  if (!changing.empty())
    report.not_told.push_back("where the resistance ends: it still changes, by up to " +
                              percent(largest_drift) + " from the first half of the way to the second (" +
                              folders_of(changing) + "); set " + mode.way_entry + " to more");
  constexpr double diameters_wanted = 2;
  if (mode.way_is_length && shortest < diameters_wanted)
    report.not_told.push_back("fluctuation over long ways: the shortest steady way, there and back, is " +
                              with_error(std::round(10 * shortest) / 10, unknown, "") +
                              " contact diameters, two or more are wanted; set " + mode.way_entry +
                              " to more");
}

Json moved_case_json(const MotionCase& item) {
  return {{"folder", item.solved->folder.string()},
          {"load", item.load},
          {"mean", item.steady.mean},
          {"standard_error", item.steady.standard_error},
          {"fluctuation", item.steady.fluctuation},
          {"independent_stretches", item.steady.independent},
          {"way", item.steady.way},
          {"drift", item.steady.drift}};
}

void derive_resistance(const MotionMode& mode, const std::vector<MotionCase>& seen,
                       ContactParameters& parameters, LawReport& report) {
  std::vector<CaseNumber> all;
  std::vector<const MotionCase*> steady, sticking, used;
  for (const auto& item : seen) {
    (item.steady.reached ? steady : sticking).push_back(&item);
    if (item.steady.reached) all.push_back(item.number(item.steady.mean, item.steady.standard_error));
  }
  if (!sticking.empty())
    report.not_told.push_back(
        "the resistance of cases that did not slip fully, or for fewer than three steps (" +
        folders_of(sticking) + "): set " + mode.way_entry + " to more");
  if (all.empty()) return;
  std::vector<ResistancePoint> points;
  for (const auto i : on_one_mesh(all)) {
    used.push_back(steady[i]);
    points.push_back({all[i].load, all[i].value, all[i].sd, all[i].realisation, parameters.particle.radius,
                      parameters.contact_radius(all[i].load)});
    report.details["resistance"].push_back(moved_case_json(*steady[i]));
  }
  tell_resistances(mode, used, report);
  tell_ways(mode, used, report);

  EffectiveQuantity friction, offset;
  ResistanceLaw law;
  const bool is_dissipation = std::all_of(used.begin(), used.end(), [](const MotionCase* item) { return item->is_dissipation; });
  const std::string provenance = (is_dissipation ? "energy dissipated per angle by slip, yielding and bonds, after one contact radius; " : "steady resistance after full slip; ") + source_of(all);
  if (is_dissipation) report.findings.push_back("The resistance is the energy dissipated per angle: what hills of the surfaces take and give back is not in it.");
  if (mode.has_length) {
    const LengthChoice choice = choose_length(points);
    law = choice.law();
    friction.length_scale = choice.scale();
    tell_choice(choice, report);
    report.details["length"] = to_json(choice);
    char odds[64];
    std::snprintf(odds, sizeof odds, "; ln of the odds for a over r: %.3g", choice.log_odds);
    friction.provenance = provenance + odds;
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
void tell_local_friction(const ParameterSet& set, const MotionMode& mode, ContactParameters& parameters, LawReport& report) {
  auto& friction = parameters.*mode.friction;
  if (!friction) return;
  for (const auto& [entry, value] : set.inputs)
    if (entry == "Interface/Friction coefficient") {
      friction->provenance += "; local friction coefficient that went in: " + value;
      report.findings.push_back("The local friction coefficient of " + value + " went in; what comes out follows from it.");
    }
}

}  // namespace

LawReport derive_motion(const ParameterSet& set, const MotionMode& mode, ContactParameters& parameters) {
  LawReport report;
  report.title = mode.title;
  std::vector<MotionCase> seen;
  for (const auto& solved : set.cases)
    if (experiment_of(solved) == mode.experiment) seen.push_back(observe(solved, mode));
  std::stable_sort(seen.begin(), seen.end(),
                   [](const MotionCase& a, const MotionCase& b) { return a.load < b.load; });
  if (seen.empty()) {
    report.not_told.push_back(std::string("all of it: there is no case with Experiment/Type = ") +
                              mode.experiment);
    return report;
  }
  derive_resistance(mode, seen, parameters, report);
  tell_local_friction(set, mode, parameters, report);
  derive_motion_stiffness(mode, seen, parameters, report);
  return report;
}

}  // namespace asperity

#include "report/motion/motion_lead.h"

#include <algorithm>
#include <cmath>

#include "dem_compare/cases/moving_case.h"
#include "dem_compare/cases/parameter_sets.h"
#include "dem_compare/cases/path_averages.h"
#include "report/page/axis.h"
#include "report/page/display_units.h"
#include "report/page/words.h"
#include "report/sentences/phrases.h"

namespace asperity::report {
namespace {

/// As number_text; an sd below a thousandth, less than any solved case is good for, is left out.
std::string lead_number(const Uncertain& number) {
  constexpr double good_for = 1e-3;
  return number_text({number.value, number.sd < good_for * std::abs(number.value) ? NAN : number.sd});
}

/// "23.4 ± 0.3 µN" or "pN m".
std::string resistance_text(const Uncertain& number, const MotionMode& mode) {
  const bool slides = &mode == &sliding_mode();
  return lead_number(number * (1 / (slides ? uN : pN_m))) + (slides ? " µN" : " pN m");
}

std::string share_text(const Uncertain& part, const Uncertain& whole) {
  return lead_number(ratio(part, {whole.value, 0}) * per_cent) + " %";
}

/// By mechanism; what takes nothing is named too.
std::string mechanisms_sentence(const SolvedCase& solved, const ResistanceParts& parts) {
  if (!std::isfinite(parts.total.value) || parts.total.value == 0)
    return "Its dissipation by mechanism is not identifiable from its history.";
  return "Of it slip dissipates " + share_text(parts.friction, parts.total) + ", " +
         bodies_dissipate_by(solved.can_yield(), solved.relaxes()) + " " +
         share_text(parts.plastic, parts.total) + " and bonds that form and break " +
         share_text(parts.adhesion, parts.total) + ".";
}

/// Dimensionless: over the load, or over the load and the particle's radius.
Uncertain coefficient_of(const MovingCase& moving, const MotionMode& mode, double radius) {
  return moving.first.resistance() * (1 / (moving.load * (&mode == &sliding_mode() ? 1 : radius)));
}

std::vector<Tile> tiles_of_motion(const SolvedCase& solved, const MovingCase& moving,
                                  const MotionMode& mode) {
  const bool slides = &mode == &sliding_mode();
  const SteadyPath& path = moving.first;
  const Uncertain resistance = path.resistance();
  std::vector<Tile> tiles{
      {lead_number(coefficient_of(moving, mode, solved.hertz().radius)),
       slides ? "effective friction coefficient" : motion_name(mode) + " moment over load and radius",
       "steady resistance at " + in_units(moving.load, Dimension::force)},
      {resistance_text(resistance, mode), slides ? "lateral resistance" : motion_name(mode) + " resistance",
       "fluctuates along the path by " + resistance_text({path.fluctuation, NAN}, mode)}};
  if (!slides)
    tiles.push_back(
        {lead_number(resistance * (1 / (moving.load * solved.hertz().contact_radius(moving.load)))),
         "the same over load and contact radius", "that of Hertz"});
  const ResistanceParts& parts = path.dissipated;
  if (std::isfinite(parts.total.value) && parts.total.value != 0) {
    tiles.push_back({share_text(parts.friction, parts.total), "dissipated by slip", ""});
    tiles.push_back({share_text(parts.plastic, parts.total),
                     "dissipated by " + bodies_dissipate_by(solved.can_yield(), solved.relaxes()), ""});
    tiles.push_back({share_text(parts.adhesion, parts.total), "dissipated by bonds", "that form and break"});
  }
  const EffectiveNumber stiffness = solved.effective(mode.stiffness_key);
  constexpr double kN_per_m = 1e3, nN_m = 1e-9;
  if (std::isfinite(stiffness.value))
    tiles.push_back(
        {lead_number(Uncertain{stiffness.value, stiffness.sd} * (1 / (slides ? kN_per_m : nN_m))) +
             (slides ? " kN/m" : " nN m/rad"),
         motion_name(mode) + " stiffness", "without slip"});
  return tiles;
}

std::string against_local_friction(const SolvedCase& solved, const MovingCase& moving,
                                   const MotionMode& mode) {
  const double mu = solved.entries.quantity("Interface/Friction coefficient", Dimension::none, 0);
  if (!(mu > 0) || &mode == &rolling_mode()) return "";
  const double full = &mode == &sliding_mode()
                          ? mu * moving.load
                          : 3 * M_PI / 16 * mu * moving.load * solved.hertz().contact_radius(moving.load);
  return "Smooth elastic bodies with the local friction that went in, " +
         format_quantity(mu, Dimension::none) + ", resist with " + resistance_text({full, NAN}, mode) +
         "; this contact with " + lead_number(moving.first.resistance() * (1 / full)) + " times that.";
}

std::string noise_sentence(const SolvedCase& solved, const MotionMode& mode) {
  const EffectiveNumber floor = solved.effective("rolling_noise_floor");
  return &mode == &rolling_mode() && std::isfinite(floor.value)
             ? "The mesh itself shows moments of up to " + resistance_text({floor.value, NAN}, mode) +
                   " on smooth elastic bodies, which dissipate nothing."
             : "";
}

MotionLead lead_of_motion(const SolvedCase& solved, const MotionMode& mode) {
  MotionLead lead;
  const std::string name = motion_name(mode, true);
  const MovingCase moving = moving_case(solved, mode);
  if (!moving.first.reached()) {
    lead.headline =
        name +
        ": no steady resistance is known, for the path ends before the motion is steady for three steps (" +
        mode.path_entry + " must be more)";
    return lead;
  }
  const bool slides = &mode == &sliding_mode();
  lead.headline = name + " under " + in_units(moving.load, Dimension::force) + " takes " +
                  resistance_text(moving.first.resistance(), mode) + ", " +
                  lead_number(coefficient_of(moving, mode, solved.hertz().radius)) + " of the load" +
                  (slides ? "" : " times the particle’s radius") + ". " +
                  mechanisms_sentence(solved, moving.first.dissipated);
  for (const auto& sentence : {against_local_friction(solved, moving, mode), noise_sentence(solved, mode)})
    if (!sentence.empty()) lead.sentences.push_back(sentence);
  if (moving.first.still_changes())
    lead.sentences.push_back("It still changes along the path, by " +
                             percent_text(std::abs(moving.first.drift)) +
                             " from its first half to its second.");
  if (moving.back.reached())
    lead.sentences.push_back("In the second pass, on the return distance, it is " +
                             lead_number(ratio(moving.back.resistance(), moving.first.resistance())) +
                             " times that.");
  lead.tiles = tiles_of_motion(solved, moving, mode);
  return lead;
}

/// Steady in nothing: the largest forces and moments, and what was dissipated by the end.
MotionLead lead_of_program(const SolvedCase& solved) {
  const auto largest = [](const std::vector<double>& values) {
    double size = 0;
    for (const double value : values) size = std::isfinite(value) ? std::max(size, std::abs(value)) : size;
    return size;
  };
  const History& h = solved.history;
  const double load = largest(h.normal_force), lateral = largest(h.lateral_force);
  MotionLead lead;
  lead.headline = "Moved as written under up to " + in_units(load, Dimension::force) + ": at most " +
                  in_units(lateral, Dimension::force) + " lateral force along, " +
                  resistance_text({largest(h.rolling_moment), NAN}, rolling_mode()) + " rolling and " +
                  resistance_text({largest(h.torsion_moment), NAN}, torsion_mode()) + " torsion moment";
  const auto last = [](const std::vector<double>& values) { return values.empty() ? NAN : values.back(); };
  const double slip = last(h.friction_work), plastic = last(h.plastic_work) - last(h.hardening_energy),
               bonds = last(h.adhesion_loss);
  const double sum = slip + plastic + bonds;
  lead.tiles.push_back({in_units(lateral, Dimension::force), "largest lateral force",
                        percent_text(lateral / load) + " of the largest load"});
  if (sum > 0) {
    lead.sentences.push_back("Of what was dissipated, loading included, slip took " +
                             percent_text(slip / sum) + ", " +
                             bodies_dissipate_by(solved.can_yield(), solved.relaxes()) + " " +
                             percent_text(plastic / sum) + " and bonds " + percent_text(bonds / sum) + ".");
    lead.tiles.push_back({percent_text(slip / sum), "of the dissipation is slip", ""});
    lead.tiles.push_back(
        {percent_text(plastic / sum), "is " + bodies_dissipate_by(solved.can_yield(), solved.relaxes()), ""});
    lead.tiles.push_back({percent_text(bonds / sum), "is bonds that form and break", ""});
  }
  return lead;
}

}  // namespace

std::optional<MotionLead> motion_lead(const SolvedCase& solved) {
  if (solved.history.size() == 0) return std::nullopt;
  if (const MotionMode* mode = mode_of(solved)) return lead_of_motion(solved, *mode);
  if (solved.motion() == Motion::program) return lead_of_program(solved);
  return std::nullopt;
}

}  // namespace asperity::report

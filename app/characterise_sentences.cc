// What a plan will do, what will not be known, and how long it takes, in sentences.
#include <cmath>
#include <string>
#include <vector>

#include "app/characterise_plan.h"
#include "core/attraction_zone.h"
#include "core/printed.h"
#include "core/quantity.h"
#include "core/wait_text.h"

namespace asperity {
namespace {

/// more: what some of the motions have beyond it.
std::string rung_text(const Rung& rung, const std::string& more = "") {
  return std::to_string(rung.loads) + (rung.loads == 1 ? " load, " : " loads, ") +
         std::to_string(rung.realisations) + (rung.realisations == 1 ? " realisation" : " realisations") +
         more + printed(", at least %g cells over the contact radius", rung.cells_per_radius);
}

/// " (5 that roll, 10 under normal load alone)": motions that have more realisations than the rung.
std::string more_realisations(const CharacterisePlan& plan) {
  int rolled = plan.rung.realisations, pressed = plan.motions.front().realisations;
  for (const PlannedMotion& motion : plan.motions)
    if (motion.label.rfind("rolling", 0) == 0) rolled = motion.realisations;
  std::string text;
  if (rolled > plan.rung.realisations) text = std::to_string(rolled) + " that roll";
  if (pressed > plan.rung.realisations)
    text += (text.empty() ? "" : ", ") + std::to_string(pressed) + " under normal load alone";
  return text.empty() ? "" : " (" + text + ")";
}

/// Where attraction acts in a zone at the edges of contacts that the plan's cells do not resolve; empty where
/// they do.
std::string unresolved_attraction(const CharacteriseRequest& request, const CharacterisePlan& plan) {
  if (!request.adhesion) return "";
  constexpr double cells = cells_over_attraction_zone;
  const auto [work, range] = *request.adhesion;
  // The exponential law's stress at contact is w / range.
  const double zone = attraction_zone(smooth_contact(request).reduced_modulus, work, work / range);
  if (zone >= cells * plan.spacing) return "";
  return "attraction over " + format_quantity(range, Dimension::length) + " acts in a zone of " +
         format_quantity(zone, Dimension::length) +
         " at the edges of contacts, which these cells do not resolve: pull-off force and adhesive rolling "
         "resistance will be too large, and say by how much; a range of " +
         format_quantity(range * std::sqrt(cells * plan.spacing / zone), Dimension::length, 2) +
         " is resolved";
}

}  // namespace

std::vector<std::string> plan_sentences(const CharacteriseRequest& request, const CharacterisePlan& plan) {
  std::vector<std::string> sentences;
  std::string loads;
  for (const double load : plan.loads)
    loads += (loads.empty() ? "" : ", ") + format_quantity(load, Dimension::force);
  sentences.push_back(std::to_string(plan.cases) +
                      " cases by finite elements: normal load, sliding, rolling and torsion at " + loads +
                      "; " + rung_text(plan.rung, more_realisations(plan)) + ", nodes every " +
                      format_quantity(plan.spacing, Dimension::length));
  if (plan.motions.front().half_space_surfaces > 0)
    sentences.push_back(
        std::to_string(plan.motions.front().half_space_surfaces) +
        " surfaces by half-spaces, which tell the mean of moduli, stiffnesses and the torsion moment");
  sentences.push_back("about " + wait_text(plan.seconds) + " on two cores, to a factor of two");
  if (plan.seconds > request.time && plan.is_least)
    sentences.push_back("that is more than the " + wait_text(request.time) +
                        " that were asked for; it is the least that gives these numbers");
  if (plan.next)
    sentences.push_back("the next finer plan (" + rung_text(*plan.next) + ") takes about " +
                        wait_text(plan.next_seconds));
  if (!request.friction_is_known && request.friction.size() == 1)
    sentences.push_back(
        printed("local friction is not known, only an experiment tells it (--friction): quickly solved at "
                "%.2g alone, resistances may be twice as large or half",
                request.friction.front()));
  else if (!request.friction_is_known)
    sentences.push_back(printed(
        "local friction is not known, only an experiment tells it (--friction): solved at %g and at %g, "
        "and the answer lies between",
        request.friction.front(), request.friction.back()));
  if (!request.adhesion)
    sentences.push_back(
        "no work of adhesion is given (--adhesion \"77 mJ/m^2, 1 nm\"): pull-off force and adhesive rolling "
        "resistance will not be known");
  if (const std::string text = unresolved_attraction(request, plan); !text.empty()) sentences.push_back(text);
  if (plan.rung.realisations == 1)
    sentences.push_back(
        "one realisation: the scatter over the surface will not be known, and no interval holds it");
  if (request.quick)
    sentences.push_back("short paths in long steps: resistances are of the right order, not more");
  if (plan.loads.size() == 1)
    sentences.push_back("one load: offsets of the resistances and growth with the load will not be known");
  return sentences;
}

}  // namespace asperity

#include "report/sentences/resistance_answers.h"

#include <algorithm>
#include <cmath>

#include "core/joined.h"
#include "core/printed.h"
#include "dem_compare/cases/path_averages.h"
#include "report/sentences/phrases.h"

namespace asperity::report {
namespace {

using Sentences = std::vector<std::string>;
using Sign = Trend::Sign;

/// "Rolling of CONTACT at 100 uN"
std::string subject(const MotionMode& mode, const MovingContact& contact, double load) {
  return say("{} of {} at {}", {motion_name(mode, true), contact.label, force_text(load)});
}

struct Mechanism {
  std::string name;
  Trend TrendAtLoad::*trend;
};
std::vector<Mechanism> mechanisms_of(const RoughnessTrend& trend) {
  return {{"slip", &TrendAtLoad::friction},
          {bodies_dissipate_by(trend.contacts), &TrendAtLoad::plastic},
          {"bonds", &TrendAtLoad::adhesion}};
}

std::string parts_sentence(const RoughnessTrend& trend) {
  Sentences parts;
  for (const auto& mechanism : mechanisms_of(trend)) {
    const Uncertain share = trend.relative_of(mechanism.trend);
    if (std::isfinite(share.value))
      parts.push_back(mechanism.name + (" " + change_percent(per_nanometre(share))));
  }
  return parts.empty() ? "" : say(" Of this, per nm: {}.", {joined(parts, ", ")});
}

/// The paper's rolling friction falls, its sliding friction rises: which mechanisms do the same?
std::string cause_sentence(const RoughnessTrend& trend) {
  const bool rolls = trend.mode == &rolling_mode();
  if (!rolls && trend.mode != &sliding_mode()) return "";
  const Sign asked = rolls ? Sign::falls : Sign::rises;
  Sentences causes;
  for (const auto& mechanism : mechanisms_of(trend))
    if (sign_of(trend.relative_of(mechanism.trend)) == asked) causes.emplace_back(mechanism.name);
  const std::string motion = motion_name(*trend.mode), change = rolls ? "fall" : "rise",
                    names = joined(causes, " and ");
  if (names.empty())
    return say(" No mechanism of the simulation lets {} friction {} significantly with roughness.",
               {motion, change});
  if (trend.sign() == asked)
    return say(" The {} of {} friction with roughness is due to {}.", {change, motion, names});
  return say(" The dissipation by {} {}s with roughness; the resistance as a whole does not.",
             {names, change});
}

Sentences roughness_sentences(const ResistanceFindings& findings) {
  Sentences list;
  for (const auto& trend : findings.trends) {
    Sentences contacts, loads;
    for (const auto* contact : trend.contacts) contacts.push_back(contact->label);
    for (const auto& at : trend.loads)
      loads.push_back(force_text(at.load) + ": " + change_percent(per_nanometre(at.total.relative())));
    const Uncertain coefficient = trend.coefficient.relative();
    list.push_back(say("{} resistance ({}) {}{}.",
                       {motion_name(*trend.mode, true), joined(contacts, "; "), trend_words(trend.relative),
                        loads.size() > 1 ? " (" + joined(loads, ", ") + ")" : ""}) +
                   parts_sentence(trend) + cause_sentence(trend) +
                   (std::isfinite(coefficient.value)
                        ? say(" Its coefficient µ, the slope over the loads, {}.", {trend_words(coefficient)})
                        : ""));
  }
  if (list.empty())
    list.emplace_back(
        "How resistance changes with roughness is not identifiable: no two contacts differ by the "
        "substrate's RMS alone.");
  return list;
}

/// First what changes with roughness, then pair by pair.
Sentences mechanism_sentences(const ResistanceFindings& findings) {
  Sentences list;
  for (const auto& trend : findings.contribution_trends) {
    const Contribution &low = *trend.smoothest, &high = *trend.roughest;
    list.push_back(say(
        "The contribution of {} to {} at {} {}: {} of the resistance per nm of RMS, from {} ({}) to {} ({}).",
        {name_of(low.mechanism), motion_name(*low.mode), force_text(low.load),
         with_roughness(trend.difference.sign()), change_percent(per_nanometre(trend.relative())),
         change_percent(low.share()), low.with->label, change_percent(high.share()), high.with->label}));
  }
  for (const auto& one : findings.contributions)
    list.push_back(say("{}: {} contributes {} of the resistance{}, beside {}.",
                       {subject(*one.mode, *one.with, one.load), name_of(one.mechanism),
                        change_percent(one.share()), significance(one.difference), one.without->label}));
  return list;
}

Sentences input_sentences(const ResistanceFindings& findings) {
  Sentences list;
  for (const auto& one : findings.inputs)
    list.push_back(
        say("{} of {} and {} at {} scales with the {} to the power {}{}.",
            {motion_name(*one.mode, true), one.smaller->label, one.larger->label, force_text(one.load),
             one.input, number_text(one.exponent), significance(one.exponent)}));
  return list;
}

Sentences mesh_sentences(const ResistanceFindings& findings) {
  Sentences list;
  for (const auto& one : findings.meshes)
    list.push_back(say(
        "{}: on {} instead of {} the resistance is {} of it{}. A discretisation error of first order in the "
        "spacing would be {} on the mesh that counts here ({}).",
        {subject(*one.state->mode, *one.contact, one.state->load), length_text(one.fine),
         length_text(one.coarse), number_text(one.ratio), significance({one.ratio.value - 1, one.ratio.sd}),
         change_percent(one.excess()), length_text(one.state->spacing)}));
  return list;
}

Sentences rail_sentences(const MovingStudy& study) {
  Sentences list;
  for (const auto& contact : study.contacts)
    for (const auto& rail : contact.rails) {
      std::string text = say("On a rail of {} degrees, {}, {} across the flank: {} per angle",
                             {printed("%.0f", rail.inclination * 180 / M_PI), contact.label,
                              force_text(rail.load), moment_text(rail.resistance)});
      if (std::isfinite(rail.sum.value))
        text += say("; rolling and torsion on their own, M_ro cos + M_to sin, make {}: ratio {}",
                    {moment_text(rail.sum), number_text(rail.over_sum())});
      if (std::isfinite(rail.spin_over_torsion.value))
        text += say(". While it rolls, it resists its spin with {} of what torsion alone takes",
                    {number_text(rail.spin_over_torsion)});
      list.push_back(text + ".");
    }
  return list;
}

/// Those that are identifiable, or that none is.
std::string length_headline(const ResistanceFindings& findings, const MotionMode& mode) {
  Sentences verdicts;
  const bool moves = std::any_of(findings.study.contacts.begin(), findings.study.contacts.end(),
                                 [&](const auto& contact) { return !contact.of(mode).empty(); });
  if (!moves) return "";
  for (const auto& answer : findings.lengths) {
    const std::string verdict = length_verdict(answer);
    if (answer.mode == &mode && answer.verdict != LengthAnswer::Verdict::cannot_tell &&
        !std::count(verdicts.begin(), verdicts.end(), verdict))
      verdicts.push_back(verdict);
  }
  return say("Length of {} resistance: {}{}. ",
             {motion_name(mode), joined(verdicts, " / ", "not identifiable"),
              verdicts.size() > 1 ? " (it depends on the contact)" : ""});
}

std::string trend_headline(const ResistanceFindings& findings, const MotionMode& mode) {
  for (const auto& trend : findings.trends)
    if (trend.mode == &mode)
      return say("{} resistance {}. ", {motion_name(mode, true), with_roughness(trend.sign())});
  return "";
}

}  // namespace

ResistanceAnswers answers(const ResistanceFindings& findings) {
  ResistanceAnswers result;
  for (const auto* mode : {&rolling_mode(), &torsion_mode()})
    result.headline += length_headline(findings, *mode);
  for (const auto* mode : {&rolling_mode(), &sliding_mode()})
    result.headline += trend_headline(findings, *mode);
  if (result.headline.empty())
    result.headline = "Resistances are below; one load and one roughness answer neither question. ";
  result.headline.pop_back();
  result.length = length_sentences(findings.lengths);
  if (result.length.empty())
    result.length.emplace_back(
        "Which length rolling and torsion follow is not identifiable: no contact was rolled or spun under "
        "two loads, or with two radii.");
  result.roughness = roughness_sentences(findings);
  result.mechanisms = mechanism_sentences(findings);
  result.inputs = input_sentences(findings);
  result.mesh = mesh_sentences(findings);
  result.rails = rail_sentences(findings.study);
  result.measurement = measurement_sentences(findings);
  result.care = findings.study.remarks;
  return result;
}

}  // namespace asperity::report

#include <algorithm>
#include <cmath>

#include "dem_compare/cases/block_averages.h"
#include "dem_compare/resistance/findings.h"
#include "dem_compare/resistance/length_sentences.h"
#include "dem_compare/resistance/sentences.h"

namespace asperity {
namespace {

using Sentences = std::vector<std::string>;
using Sign = Trend::Sign;

/// Of a change with roughness [1/m]: over a nanometre.
Uncertain per_nanometre(const Uncertain& slope) {
  constexpr double nm = 1e-9;
  return {slope.value * nm, slope.sd * nm};
}

/// Slope of a part over the mean of the whole, over the loads [per metre].
Uncertain part_of(const RoughnessTrend& trend, Trend TrendAtLoad::*part) {
  std::vector<Uncertain> shares;
  for (const auto& at : trend.loads) {
    const Uncertain& slope = (at.*part).slope;
    shares.push_back({slope.value / at.total.mean.value, slope.sd / std::abs(at.total.mean.value)});
  }
  return cautious_mean(shares);
}

struct Part {
  const char* name;
  Trend TrendAtLoad::*member;
};
const std::vector<Part>& parts() {
  static const std::vector<Part> list{{"slip", &TrendAtLoad::friction},
                                      {"yielding", &TrendAtLoad::plastic},
                                      {"bonds", &TrendAtLoad::adhesion}};
  return list;
}

std::string parts_words(const RoughnessTrend& trend) {
  std::string text;
  for (const auto& part : parts()) {
    const Uncertain share = part_of(trend, part.member);
    if (std::isfinite(share.value))
      text += (text.empty() ? "" : ", ") + (part.name + (" " + change_percent(per_nanometre(share))));
  }
  return text.empty() ? "" : " Of this, per nm: " + text + ".";
}

std::string at_loads(const RoughnessTrend& trend) {
  std::string text;
  for (const auto& at : trend.loads) {
    const Uncertain change = at.total.relative();
    text += (text.empty() ? "" : ", ") + force_text(at.load) + ": " + change_percent(per_nanometre(change));
  }
  return trend.loads.size() > 1 ? " (" + text + ")" : "";
}

/// Parts whose own slope has the sign.
std::string causes(const RoughnessTrend& trend, Sign sign) {
  std::string names;
  for (const auto& part : parts())
    if (sign_of(part_of(trend, part.member)) == sign)
      names += (names.empty() ? "" : " and ") + std::string(part.name);
  return names;
}

std::string cause_words(const RoughnessTrend& trend) {
  const bool rolls = trend.mode == &rolling_mode(), slides = trend.mode == &sliding_mode();
  if (!rolls && !slides) return "";
  const Sign asked = rolls ? Sign::falls : Sign::rises;
  const std::string names = causes(trend, asked);
  const std::string verb = rolls ? "rolling friction fall" : "sliding friction rise",
                    own = rolls ? "falls" : "rises";
  if (names.empty())
    return " No mechanism of the simulation makes " + verb +
           " with roughness, as far as two standard deviations tell.";
  if (trend.sign() == asked) return " What makes " + verb + " with roughness is " + names + ".";
  return " What goes into " + names + " " + own + " with roughness; the resistance as a whole does not.";
}

std::string coefficient_words(const RoughnessTrend& trend) {
  const Uncertain change = trend.coefficient.relative();
  if (!std::isfinite(change.value)) return "";
  return " Its coefficient mu, the slope over the loads, " + trend_words(change) + ".";
}

Sentences roughness_sentences(const ResistanceFindings& findings) {
  Sentences list;
  for (const auto& trend : findings.trends) {
    std::string over;
    for (const auto* contact : trend.contacts) over += (over.empty() ? "" : "; ") + contact->label;
    list.push_back(motion_name(*trend.mode, true) + " resistance (" + over + ") " +
                   trend_words(trend.relative) + at_loads(trend) + "." + parts_words(trend) +
                   cause_words(trend) + coefficient_words(trend));
  }
  return list;
}

const char* name_of(Contribution::Mechanism mechanism) {
  return mechanism == Contribution::Mechanism::yielding ? "yielding" : "adhesion";
}

/// First what changes with roughness, then pair by pair.
Sentences mechanism_sentences(const ResistanceFindings& findings) {
  Sentences list;
  for (const auto& trend : findings.contribution_trends) {
    const Contribution &low = *trend.smoothest, &high = *trend.roughest;
    const Uncertain change = per_nanometre(trend.relative());
    const Sign sign = sign_of(trend.difference.slope);
    list.push_back("What " + std::string(name_of(low.mechanism)) + " contributes to " +
                   motion_name(*low.mode) + " at " + force_text(low.load) +
                   (sign == Sign::rises   ? " rises with roughness"
                    : sign == Sign::falls ? " falls with roughness"
                    : sign == Sign::none  ? " shows no trend with roughness"
                                          : " changes with roughness in a way that cannot be told") +
                   ": " + change_percent(change) + " of the resistance per nm of RMS, from " +
                   change_percent(low.share()) + " (" + low.with->label + ") to " +
                   change_percent(high.share()) + " (" + high.with->label + ").");
  }
  for (const auto& one : findings.contributions) {
    std::string text = motion_name(*one.mode, true) + " of " + one.with->label + " at " +
                       force_text(one.load) + ": " + name_of(one.mechanism);
    const Uncertain share = one.share();
    if (!one.difference.has_sd())
      text += " changes the resistance by " + change_percent(share) +
              "; whether that means anything cannot be told";
    else if (!one.is_told())
      text += " contributes nothing that shows (" + change_percent(share) + " of the resistance)";
    else
      text += " contributes " + change_percent(share) + " of the resistance";
    list.push_back(text + " (beside " + one.without->label + ").");
  }
  return list;
}

Sentences input_sentences(const ResistanceFindings& findings) {
  Sentences list;
  for (const auto& one : findings.inputs) {
    std::string text = motion_name(*one.mode, true) + " of " + one.smaller->label + " and " +
                       one.larger->label + " at " + force_text(one.load) + " goes with the " + one.input +
                       " to the power " + number_text(one.exponent);
    const Sign sign = sign_of(one.exponent);
    if (sign == Sign::none) text += ": no dependence that shows";
    if (sign == Sign::unknown) text += "; whether that means anything cannot be told";
    list.push_back(text + ".");
  }
  return list;
}

Sentences mesh_sentences(const ResistanceFindings& findings) {
  Sentences list;
  for (const auto& one : findings.meshes) {
    const auto length = [](double metres) { return format_quantity(metres, Dimension::length); };
    const bool shows = std::abs(one.ratio.value - 1) > 2 * one.ratio.sd;
    std::string text = motion_name(*one.state->mode, true) + " of " + one.contact->label + " at " +
                       force_text(one.state->load) + ": on " + length(one.fine) + " instead of " +
                       length(one.coarse) + " the resistance is " + number_text(one.ratio) + " of it";
    if (!one.ratio.has_sd())
      text += "; whether that means anything cannot be told";
    else if (!shows)
      text += ": no difference that shows";
    list.push_back(text + ". Were its error of first order in the spacing, the one that counts here (" +
                   length(one.state->spacing) + ") would differ from an ever finer mesh's by " +
                   change_percent(one.excess()) + ".");
  }
  return list;
}

Sentences rail_sentences(const MovingStudy& study) {
  Sentences list;
  for (const auto& contact : study.contacts)
    for (const auto& rail : contact.rails) {
      std::string text = "On a rail of " + number_text({std::round(rail.inclination * 180 / M_PI)}) +
                         " degrees, " + contact.label + ", " + force_text(rail.load) +
                         " across the flank: " + moment_text(rail.resistance) + " per angle";
      if (std::isfinite(rail.sum.value))
        text += "; rolling and torsion on their own, M_ro cos + M_to sin, make " + moment_text(rail.sum) +
                ": ratio " + number_text(rail.over_sum());
      if (std::isfinite(rail.spin_over_torsion.value))
        text += ". While it rolls, it resists its spin with " + number_text(rail.spin_over_torsion) +
                " of what torsion alone takes";
      list.push_back(text + ".");
    }
  return list;
}

std::string sigma_words(double sigmas) {
  return number_text({std::round(10 * std::abs(sigmas)) / 10}) + " sigma";
}

std::string trend_against_paper(const MeasuredTrend& one) {
  const bool coefficient = std::isnan(one.load), rolls = one.trend->mode == &rolling_mode();
  const std::string what =
      motion_name(*one.trend->mode, true) + " of " + one.trend->contacts.front()->label + " to " +
      one.trend->contacts.back()->label +
      (coefficient ? ", trend of the coefficient with RMS" : ", trend with RMS at " + force_text(one.load)) +
      (rolls ? " (at the silicon's contact: twice what the paper's mean over both contacts shows)" : "");
  const auto per_nm = [](const Uncertain& slope) { return number_text(per_nanometre(slope)) + " per nm"; };
  std::string text = what + ": simulated " + per_nm(one.simulated) + ", measured " + per_nm(one.measured);
  if (!std::isfinite(one.sigmas())) return text + "; cannot tell whether they agree.";
  constexpr double two_sigma = 2;
  if (one.is_opposite())
    return text + ". The simulations contradict the measurement: opposite signs, " +
           sigma_words(one.sigmas()) + " apart.";
  if (std::abs(one.sigmas()) <= two_sigma && std::abs(one.measured.value) < two_sigma * one.measured.sd)
    return text + "; cannot tell whether they agree, for the measured one is not told from none (" +
           sigma_words(one.sigmas()) + " apart).";
  return text +
         (std::abs(one.sigmas()) > two_sigma ? ". The simulations contradict the measurement: ratio "
                                             : ": they agree, ratio ") +
         number_text(one.over()) + ", " + sigma_words(one.sigmas()) + " apart.";
}

std::string magnitude_against_paper(const MeasuredMagnitude& one) {
  const std::string text =
      motion_name(*one.mode, true) + " of " + one.contact->label + " at " + force_text(one.load) +
      (one.indenter ? ", mean with the indenter's contact (" + one.indenter->label + ")" : "") + ": " +
      (one.mode == &sliding_mode() ? "F/P" : "M/(P r)") + " simulated " + number_text(one.simulated) +
      ", measured " + number_text(one.measured);
  if (!std::isfinite(one.sigmas()))
    return text + ", ratio " + number_text(one.over()) + " (its uncertainty cannot be told).";
  // Local friction went in: its size says nothing of the simulation.
  if (one.mode != &rolling_mode())
    return text + ", ratio " + number_text(one.over()) + ", " + sigma_words(one.sigmas()) +
           " apart; the size follows from the local friction of " +
           number_text({one.contact->bodies.friction}) + " that went in.";
  constexpr double two_sigma = 2;
  return text +
         (std::abs(one.sigmas()) > two_sigma ? "; they contradict each other: ratio "
                                             : "; they agree: ratio ") +
         number_text(one.over()) + ", " + sigma_words(one.sigmas()) + " apart.";
}

std::string law_against_paper(const MeasuredLaw& one) {
  constexpr double micro = 1e-6;
  const auto beside = [](const Uncertain& simulated, const Uncertain& measured) {
    return number_text(simulated) + " simulated, " + number_text(measured) + " measured, " +
           sigma_words((simulated.value - measured.value) / std::hypot(simulated.sd, measured.sd)) + " apart";
  };
  return motion_name(*one.mode, true) + " of " + one.contact->label +
         (one.indenter                  ? ", mean with the indenter's contact (" + one.indenter->label + ")"
          : one.mode == &rolling_mode() ? ", the silicon's contact alone beside a mean over two"
                                        : "") +
         ", over " + force_text(one.lowest_load) + " to " + force_text(one.highest_load) +
         (one.mode == &sliding_mode() ? "" : ", lambda = r") + ": mu " +
         beside(one.simulated.coefficient, one.coefficient) + "; h [uN] " +
         beside(one.simulated.offset * (1 / micro), one.offset * (1 / micro)) + ".";
}

/// True for a contact that stands for another one with a mechanism switched off: it was not measured.
bool is_reduced(const ResistanceFindings& findings, const MovingContact& contact) {
  return std::any_of(findings.contributions.begin(), findings.contributions.end(),
                     [&](const auto& one) { return one.without == &contact; });
}

/// The coefficient of the paper's rolling friction is a slope over loads.
Sentences coefficients_that_lack(const ResistanceFindings& findings) {
  const auto& trends = findings.published.trends;
  const auto rolls = [](const MeasuredTrend& one) { return one.trend->mode == &rolling_mode(); };
  const auto has_coefficient = [&](const MeasuredTrend& one) {
    return rolls(one) && one.trend->coefficient.slope.has_sd();
  };
  if (std::any_of(trends.begin(), trends.end(), rolls) &&
      std::none_of(trends.begin(), trends.end(), has_coefficient))
    return {
        "What falls with roughness in the paper is the coefficient mu, the slope of rolling resistance over "
        "loads of 0.1 to 3 mN; at a "
        "load below about 0.6 mN its resistance rises, with the offset h. To set that fall beside the "
        "simulations, at least two "
        "surfaces need two loads each: without them it cannot be told."};
  return {};
}

/// Those that tell, or that none does.
std::string length_headline(const ResistanceFindings& findings, const MotionMode& mode) {
  Sentences verdicts;
  const bool moves = std::any_of(findings.study.contacts.begin(), findings.study.contacts.end(),
                                 [&](const auto& contact) { return !contact.of(mode).empty(); });
  if (!moves) return "";
  for (const auto& answer : findings.lengths) {
    if (answer.mode != &mode) continue;
    const std::string words = verdict_words(answer);
    if (answer.verdict != LengthAnswer::Verdict::cannot_tell &&
        !std::count(verdicts.begin(), verdicts.end(), words))
      verdicts.push_back(words);
  }
  std::string text;
  for (const auto& verdict : verdicts) text += (text.empty() ? "" : " / ") + verdict;
  return "Length of " + motion_name(mode) + " resistance: " + (text.empty() ? "cannot tell" : text) +
         (verdicts.size() > 1 ? " (it depends on the contact)" : "") + ". ";
}

std::string trend_headline(const ResistanceFindings& findings, const MotionMode& mode) {
  for (const auto& trend : findings.trends)
    if (trend.mode == &mode) {
      const Sign sign = trend.sign();
      return motion_name(mode, true) + (sign == Sign::rises   ? " resistance rises with roughness. "
                                        : sign == Sign::falls ? " resistance falls with roughness. "
                                        : sign == Sign::none
                                            ? " resistance shows no trend with roughness. "
                                            : " resistance: its trend with roughness cannot be told. ");
    }
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
  result.length = length_sentences(findings);
  if (result.length.empty())
    result.length.push_back(
        "Which length rolling and torsion follow cannot be told: no contact was rolled or spun under two "
        "loads, or "
        "with two radii.");
  result.roughness = roughness_sentences(findings);
  if (result.roughness.empty())
    result.roughness.push_back(
        "How resistance changes with roughness cannot be told: no two contacts differ by the substrate's RMS "
        "alone.");
  result.mechanisms = mechanism_sentences(findings);
  result.inputs = input_sentences(findings);
  result.mesh = mesh_sentences(findings);
  result.rails = rail_sentences(findings.study);
  for (const auto& one : findings.published.trends) result.measurement.push_back(trend_against_paper(one));
  const Sentences missing = coefficients_that_lack(findings);
  result.measurement.insert(result.measurement.end(), missing.begin(), missing.end());
  for (const auto& one : findings.published.laws)
    if (!is_reduced(findings, *one.contact)) result.measurement.push_back(law_against_paper(one));
  for (const auto& one : findings.published.magnitudes)
    if (!is_reduced(findings, *one.contact)) result.measurement.push_back(magnitude_against_paper(one));
  for (const auto& remark : findings.published.remarks)
    result.measurement.push_back("No partner in the paper for " + remark + ".");
  result.care = findings.study.remarks;
  return result;
}

}  // namespace asperity

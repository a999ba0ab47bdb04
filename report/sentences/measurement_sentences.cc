#include <algorithm>
#include <cmath>

#include "dem_compare/cases/path_averages.h"
#include "report/sentences/phrases.h"
#include "report/sentences/resistance_answers.h"

namespace asperity::report {
namespace {

std::string ratio_and_sigmas(const Uncertain& over, double sigmas) {
  return say("ratio {}, {} apart", {number_text(over), sigma_text(sigmas)});
}

std::string of_trend(const MeasuredTrend& one) {
  const std::string apart = ratio_and_sigmas(one.over(), one.sigmas());
  switch (one.agreement()) {
    case Agreement::agree:
      return ": they agree, " + apart + ".";
    case Agreement::no_trend:
      return say("; agreement is not identifiable, for the measured trend is not significant ({} apart).",
                 {sigma_text(one.sigmas())});
    case Agreement::contradict:
      return ". The simulations contradict the measurement: " + apart + ".";
    case Agreement::opposite:
      return say(". The simulations contradict the measurement: opposite signs, {} apart.",
                 {sigma_text(one.sigmas())});
    default:
      return "; agreement is not identifiable.";
  }
}

std::string trend_sentence(const MeasuredTrend& one) {
  const RoughnessTrend& trend = *one.trend;
  return say(
      "{} of {} to {}, trend {}{}: simulated {} per nm, measured {} per nm{}",
      {motion_name(*trend.mode, true), trend.contacts.front()->label, trend.contacts.back()->label,
       std::isnan(one.load) ? "of the coefficient with RMS" : "with RMS at " + force_text(one.load),
       trend.mode == &rolling_mode()
           ? " (at the silicon's contact: twice what the paper's mean over both contacts shows)"
           : "",
       number_text(per_nanometre(one.simulated)), number_text(per_nanometre(one.measured)), of_trend(one)});
}

/// ", mean with the indenter's contact (LABEL)"; otherwise `alone`.
std::string mean_with(const MovingContact* indenter, const std::string& alone = "") {
  return indenter ? say(", mean with the indenter's contact ({})", {indenter->label}) : alone;
}

std::string of_magnitude(const MeasuredMagnitude& one) {
  const std::string apart = ratio_and_sigmas(one.over(), one.sigmas());
  if (!std::isfinite(one.sigmas()))
    return say(", ratio {} (of unknown significance).", {number_text(one.over())});
  // Local friction went in: its size says nothing of the simulation.
  if (one.mode != &rolling_mode())
    return say(", {}; the size follows from the local friction of {} that went in.",
               {apart, number_text({one.contact->bodies.friction})});
  constexpr double two_sigma = 2;
  return (std::abs(one.sigmas()) > two_sigma ? "; they contradict each other: " : "; they agree: ") + apart +
         ".";
}

std::string magnitude_sentence(const MeasuredMagnitude& one) {
  return say("{} of {} at {}{}: {} simulated {}, measured {}{}",
             {motion_name(*one.mode, true), one.contact->label, force_text(one.load), mean_with(one.indenter),
              one.mode == &sliding_mode() ? "F/P" : "M/(P r)", number_text(one.simulated),
              number_text(one.measured), of_magnitude(one)});
}

std::string both(const Uncertain& simulated, const Uncertain& measured) {
  return say("{} simulated, {} measured, {} apart",
             {number_text(simulated), number_text(measured),
              sigma_text((simulated.value - measured.value) / std::hypot(simulated.sd, measured.sd))});
}

std::string law_sentence(const MeasuredLaw& one) {
  constexpr double micro = 1e-6;
  const char* alone =
      one.mode == &rolling_mode() ? ", the silicon's contact alone beside a mean over two" : "";
  return say("{} of {}{}, over {} to {}{}: µ {}; h [uN] {}.",
             {motion_name(*one.mode, true), one.contact->label, mean_with(one.indenter, alone),
              force_text(one.lowest_load), force_text(one.highest_load),
              one.mode == &sliding_mode() ? "" : ", λ = r", both(one.simulated.coefficient, one.coefficient),
              both(one.simulated.offset * (1 / micro), one.offset * (1 / micro))});
}

/// The coefficient of the paper's rolling friction is a slope over loads.
bool lacks_coefficients(const std::vector<MeasuredTrend>& trends) {
  const auto rolls = [](const MeasuredTrend& one) { return one.trend->mode == &rolling_mode(); };
  return std::any_of(trends.begin(), trends.end(), rolls) &&
         std::none_of(trends.begin(), trends.end(), [&](const MeasuredTrend& one) {
           return rolls(one) && one.trend->coefficient.slope.has_sd();
         });
}

}  // namespace

std::vector<std::string> measurement_sentences(const ResistanceFindings& findings) {
  const AgainstPublished& published = findings.published;
  // A contact that stands for another one with a mechanism switched off was not measured.
  const auto is_reduced = [&](const MovingContact& contact) {
    return std::any_of(findings.contributions.begin(), findings.contributions.end(),
                       [&](const auto& one) { return one.without == &contact; });
  };
  std::vector<std::string> list;
  for (const auto& one : published.trends) list.push_back(trend_sentence(one));
  if (lacks_coefficients(published.trends))
    list.emplace_back(
        "What falls with roughness in the paper is the coefficient µ, the slope of rolling resistance over "
        "loads of 0.1 to 3 mN; at a load below about 0.6 mN its resistance rises, with the offset h. To set "
        "that fall beside the simulations, at least two surfaces need two loads each: without them it is not "
        "identifiable.");
  for (const auto& one : published.laws)
    if (!is_reduced(*one.contact)) list.push_back(law_sentence(one));
  for (const auto& one : published.magnitudes)
    if (!is_reduced(*one.contact)) list.push_back(magnitude_sentence(one));
  for (const auto& remark : published.remarks) list.push_back("No partner in the paper for " + remark + ".");
  return list;
}

}  // namespace asperity::report

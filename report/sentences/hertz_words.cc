#include "report/sentences/hertz_words.h"

#include <algorithm>
#include <cmath>

#include "core/printed.h"
#include "core/quantity.h"
#include "report/sentences/phrases.h"
#include "report/sentences/verdict_words.h"

namespace asperity::report {
namespace {

std::string percent_in_digits(double share, int digits) { return printed("%.*g %%", digits, 100 * share); }

/// "softer than Hertz by 20 % (17 to 23 %)"; `reference` " than Hertz" or "".
std::string softer_by(const LoadComparison& load, double tolerance, const std::string& reference = "") {
  const double departure = load.stiffness_ratio.mean - 1;
  return say("{}{} by {}{}", {departure < 0 ? "softer" : "stiffer", reference,
                              percent_off_one(load.stiffness_ratio.mean, tolerance),
                              interval_words(departure, load.stiffness_half_width)});
}

std::string stiffness_sentence(const GroupComparison& group, double tolerance) {
  if (group.loads.empty() || std::isnan(group.loads.back().stiffness_ratio.mean))
    return "too few load steps to judge (three are needed).";
  const LoadComparison &low = group.loads.front(), &high = group.loads.back();
  const std::string within = within_text(tolerance), at_low = force_text(low.force),
                    at_high = force_text(high.force);
  if (high.stiffness_judged == Judged::outside)
    return say("{} still at {}{}.",
               {softer_by(high, tolerance, " than Hertz"), at_high,
                &low == &high ? "" : say(" ({} at {})", {softer_by(low, tolerance), at_low})});
  if (high.stiffness_judged == Judged::not_known)
    return say("whether it is as stiff as Hertz {} is not known at {}: {}.",
               {within, at_high, softer_by(high, tolerance)});
  if (group.judged_at_all_loads == Judged::within)
    return say("as stiff as Hertz {} from {} to {}.", {within, at_low, at_high});
  const auto worst = std::find_if(group.loads.begin(), group.loads.end(), [](const LoadComparison& load) {
    return load.stiffness_judged == Judged::outside;
  });
  const std::string below =
      worst != group.loads.end()
          ? say("{} at {}", {softer_by(*worst, tolerance, " than Hertz"), force_text(worst->force)})
          : say("not known to be as stiff as Hertz at {}, where it is {}",
                {at_low, softer_by(low, tolerance)});
  return say("{}, {} from {} on.", {below, within, force_text(group.hertzian_from)});
}

/// The verdict is on means: says so where single surfaces scatter by more than the tolerance.
std::string scatter_sentence(const GroupComparison& group, double tolerance) {
  const LoadComparison* worst = nullptr;
  for (const auto& load : group.loads)
    if (load.stiffness_ratio.sd > (worst ? worst->stiffness_ratio.sd : tolerance)) worst = &load;
  if (!worst) return "";
  return say(" That is the mean; single realisations scatter about it by up to {} (at {}).",
             {percent_off_one(1 + worst->stiffness_ratio.sd, tolerance), force_text(worst->force)});
}

/// Not so if it is negative: the extrapolation of the first loading to zero is no better than that.
bool is_significant(const Estimate& imprint) {
  const double mesh = imprint.mesh ? std::abs(imprint.mean - imprint.mesh->extrapolated) : 0;
  return imprint.mean > 0 && !(imprint.mean <= imprint.sd) && imprint.mean > mesh;
}

/// "Hertz's within 5 %", "20 % (...) below Hertz's" and the like, by the interval.
std::string judged_words(double ratio, double doubt, double tolerance, const std::string& as,
                         const std::string& below, const std::string& above) {
  const Judged own = judged(ratio - 1, doubt, tolerance);
  const std::string within = within_text(tolerance);
  if (own == Judged::within) return as + " " + within;
  return say("{}{} {}{}", {percent_off_one(ratio, tolerance), interval_words(ratio - 1, doubt),
                           ratio < 1 ? below : above, own == Judged::outside ? "" : ", not known " + within});
}

std::string imprint_sentence(const GroupNumbers& numbers) {
  if (!(numbers.plastic_volume.mean > 0)) return "";
  if (!std::isfinite(numbers.residual_imprint.mean)) return " Material yielded.";
  return " Material yielded; " +
         (is_significant(numbers.residual_imprint)
              ? say("an imprint of {} stays.", {length_text(numbers.residual_imprint.mean)})
              : "its imprint is not significant beside scatter and mesh error.");
}

}  // namespace

std::string percent_off_one(double ratio, double tolerance) {
  const double size = std::abs(ratio - 1);
  constexpr int usual = 2, most = 15;
  const double rounding = 1e-12;
  int digits = usual;
  while (digits < most && std::abs(size - tolerance) > rounding &&
         percent_in_digits(size, digits) == percent_in_digits(tolerance, digits))
    ++digits;
  return percent_in_digits(size, digits);
}

std::string interval_words(double departure, double half_width) {
  constexpr double seen = 5e-4;
  if (!(half_width >= seen)) return "";
  const double low = 100 * (departure - half_width), high = 100 * (departure + half_width);
  const int decimals = half_width < 0.0995 ? 1 : 0;
  return printed(" (%+.*f to %+.*f %%)", decimals, low, decimals, high);
}

std::string verdict_against_hertz(const GroupComparison& group, double tolerance) {
  std::string words = "Loading: " + stiffness_sentence(group, tolerance) + scatter_sentence(group, tolerance);
  const GroupNumbers& numbers = group.numbers;
  if (group.loads.empty()) return words + imprint_sentence(numbers);
  const LoadComparison& top = group.loads.back();
  words += say(" Force at the same approach is {} at {}.",
               {judged_words(top.force_ratio.mean, top.force_half_width, tolerance, "Hertz's",
                             "below Hertz's", "above Hertz's"),
                force_text(numbers.force)});
  const double unloading = numbers.unloading_stiffness.mean / numbers.hertz.normal_stiffness(numbers.force);
  if (std::isfinite(unloading))
    words += say(" Unloading starts {}.",
                 {judged_words(unloading, top.unloading_half_width, tolerance, "as stiff as Hertz",
                               "softer than Hertz", "stiffer than Hertz")});
  return words + imprint_sentence(numbers);
}

}  // namespace asperity::report

#include "dem_compare/compare/hertz_verdict.h"

#include <cmath>
#include <cstdio>

#include "core/quantity.h"

namespace asperity {
namespace {

std::string rounded_force(double force) { return format_quantity(force, Dimension::force, 3); }

std::string percent_in_digits(double share, int digits) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.*g %%", digits, 100 * share);
  return buffer;
}

/// "softer than Hertz by 20 % (17 to 23 %)"; `reference` " than Hertz" or "".
std::string softer_by(const LoadComparison& load, double tolerance, const std::string& reference) {
  const double departure = load.stiffness_ratio.mean - 1;
  return (departure < 0 ? "softer" : "stiffer") + reference + " by " +
         percent_off_one(load.stiffness_ratio.mean, tolerance) +
         interval_words(departure, load.stiffness_doubt);
}

/// Between the lowest load and the first from which on all are within.
std::string up_to_hertz(const GroupComparison& group, double tolerance) {
  const LoadComparison& low = group.loads.front();
  const std::string from =
      ", within " + percent_in_digits(tolerance, 2) + " from " + rounded_force(group.hertzian_from) + " on.";
  const LoadComparison* worst = nullptr;
  for (const auto& load : group.loads)
    if (load.stiffness_judged == Judged::outside && !worst) worst = &load;
  if (worst) return softer_by(*worst, tolerance, " than Hertz") + " at " + rounded_force(worst->force) + from;
  return "not known to be as stiff as Hertz at " + rounded_force(low.force) + ", where it is " +
         softer_by(low, tolerance, "") + from;
}

std::string stiffness_sentence(const GroupComparison& group, double tolerance) {
  if (group.loads.empty() || std::isnan(group.loads.back().stiffness_ratio.mean))
    return "too few load steps to judge (three are needed).";
  const LoadComparison &low = group.loads.front(), &high = group.loads.back();
  const std::string within = percent_in_digits(tolerance, 2);
  if (high.stiffness_judged == Judged::outside) {
    const std::string before =
        &low == &high ? "" : " (" + softer_by(low, tolerance, "") + " at " + rounded_force(low.force) + ")";
    return softer_by(high, tolerance, " than Hertz") + " still at " + rounded_force(high.force) + before +
           ".";
  }
  if (high.stiffness_judged == Judged::not_known)
    return "whether it is as stiff as Hertz within " + within + " is not known at " +
           rounded_force(high.force) + ": " + softer_by(high, tolerance, "") + ".";
  if (group.judged_at_all_loads == Judged::within)
    return "as stiff as Hertz within " + within + " from " + rounded_force(low.force) + " to " +
           rounded_force(high.force) + ".";
  return up_to_hertz(group, tolerance);
}

/// The verdict is on means: says so where single surfaces scatter by more than the tolerance.
std::string scatter_sentence(const GroupComparison& group, double tolerance) {
  const LoadComparison* worst = nullptr;
  for (const auto& load : group.loads)
    if (load.stiffness_ratio.sd > (worst ? worst->stiffness_ratio.sd : tolerance)) worst = &load;
  if (!worst) return "";
  return " That is the mean; single realisations scatter about it by up to " +
         percent_off_one(1 + worst->stiffness_ratio.sd, tolerance) + " (at " + rounded_force(worst->force) +
         ").";
}

/// Not so if it is negative: the extrapolation of the first loading to zero is no better than that.
bool is_told_from_its_errors(const Estimate& imprint) {
  const double mesh = imprint.mesh ? std::abs(imprint.mean - imprint.mesh->extrapolated) : 0;
  return imprint.mean > 0 && !(imprint.mean <= imprint.sd) && imprint.mean > mesh;
}

/// "Force at the same approach is ..." and "Unloading starts ...", by their intervals.
std::string judged_words(double ratio, double doubt, double tolerance, const std::string& within,
                         const std::string& below, const std::string& above) {
  const std::string by = percent_off_one(ratio, tolerance) + interval_words(ratio - 1, doubt) + " " +
                         (ratio < 1 ? below : above);
  switch (judged(ratio - 1, doubt, tolerance)) {
    case Judged::within:
      return within + " within " + percent_in_digits(tolerance, 2);
    case Judged::outside:
      return by;
    default:
      return by + ", not known within " + percent_in_digits(tolerance, 2);
  }
}

std::string imprint_sentence(const GroupNumbers& numbers) {
  if (!(numbers.plastic_volume.mean > 0)) return "";
  std::string words = " Material yielded";
  if (std::isfinite(numbers.residual_imprint.mean))
    words += is_told_from_its_errors(numbers.residual_imprint)
                 ? "; an imprint of " + format_quantity(numbers.residual_imprint.mean, Dimension::length, 3) +
                       " stays"
                 : "; its imprint is too small to be told from scatter and mesh error";
  return words + ".";
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
  char text[64];
  const double low = 100 * (departure - half_width), high = 100 * (departure + half_width);
  const int decimals = half_width < 0.0995 ? 1 : 0;
  std::snprintf(text, sizeof text, " (%+.*f to %+.*f %%)", decimals, low, decimals, high);
  return text;
}

std::string verdict_against_hertz(const GroupComparison& group, double tolerance) {
  std::string words = "Loading: " + stiffness_sentence(group, tolerance) + scatter_sentence(group, tolerance);
  const GroupNumbers& numbers = group.numbers;
  if (!group.loads.empty()) {
    const LoadComparison& top = group.loads.back();
    words += " Force at the same approach is " +
             judged_words(top.force_ratio.mean, top.force_doubt, tolerance, "Hertz's", "below Hertz's",
                          "above Hertz's") +
             " at " + rounded_force(numbers.force) + ".";
  }
  const double unloading = numbers.unloading_stiffness.mean / numbers.hertz.normal_stiffness(numbers.force);
  if (std::isfinite(unloading) && !group.loads.empty())
    words += " Unloading starts " +
             judged_words(unloading, group.loads.back().unloading_doubt, tolerance, "as stiff as Hertz",
                          "softer than Hertz", "stiffer than Hertz") +
             ".";
  return words + imprint_sentence(numbers);
}

}  // namespace asperity

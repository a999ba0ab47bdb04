#include "dem_compare/resistance/length_sentences.h"

#include <algorithm>
#include <cmath>

#include "dem_compare/derive/law_report.h"
#include "dem_compare/resistance/sentences.h"

namespace asperity {
namespace {

/// "1.31 +- 0.01", or "1.31 to 1.34" of several; "" where none is known.
std::string exponents_words(const LengthAnswer& answer, const std::string& over,
                            const std::string& with_radius, const std::string& with_contact,
                            const std::string& with_bonds) {
  double low = INFINITY, high = -INFINITY;
  std::string single;
  for (const auto& exponent : answer.exponents) {
    const Uncertain& found = exponent.exponent.slope;
    if (exponent.over != over || !std::isfinite(found.value)) continue;
    low = std::min(low, found.value), high = std::max(high, found.value);
    single = number_text(found);
  }
  if (single.empty()) return "";
  constexpr double hundred = 100;
  const auto rounded = [](double value) { return number_text({std::round(hundred * value) / hundred}); };
  return " With the " + over + " the moment grows to the power " +
         (low == high ? single : rounded(low) + " to " + rounded(high)) +
         " (lambda = r without offset: " + with_radius + ", lambda = a: " + with_contact +
         (answer.mode == &rolling_mode() ? ", bonds along a smooth rim: " + with_bonds : "") + ").";
}

std::string odds_words(const LengthChoice& choice) {
  if (choice.log_odds == 0) return "";
  constexpr double most_that_matters = 1e6;
  const double odds = std::exp(std::abs(choice.log_odds));
  const bool is_contact = choice.log_odds > 0;
  return " Odds " + (odds > most_that_matters ? std::string("above 10^6") : number_text({odds})) +
         " to 1 for lambda = " + (is_contact ? "a" : "r") + ", an offset h left free" +
         (choice.is_told() ? "" : " (20 to 1 would be an answer)") + "; with it " +
         to_text(is_contact ? choice.with_contact : choice.with_radius) + ".";
}

std::string without_offset_words(const LengthAnswer& answer) {
  if (answer.verdict != LengthAnswer::Verdict::cannot_tell) return "";
  const auto alone = answer.without_offset();
  if (alone == LengthAnswer::Verdict::cannot_tell) return "";
  return std::string(" Without an offset the exponents would say: ") + verdict_words(alone) +
         "; more loads or radii would tell h apart.";
}

}  // namespace

const char* verdict_words(LengthAnswer::Verdict verdict) {
  switch (verdict) {
    case LengthAnswer::Verdict::particle_radius:
      return "lambda = r";
    case LengthAnswer::Verdict::contact_radius:
      return "lambda = a";
    case LengthAnswer::Verdict::neither:
      return "neither lambda = r nor lambda = a";
    default:
      return "cannot tell";
  }
}

std::string verdict_words(const LengthAnswer& answer) {
  const std::string words = verdict_words(answer.verdict);
  if (answer.verdict != LengthAnswer::Verdict::neither || !answer.choice || !answer.choice->is_told())
    return words;
  return words + ", of the two rather lambda = " + (answer.choice->log_odds > 0 ? "a" : "r");
}

std::vector<std::string> length_sentences(const ResistanceFindings& findings) {
  std::vector<std::string> list;
  for (const auto& answer : findings.lengths) {
    std::string radii;
    for (const double radius : answer.radii)
      radii += (radii.empty() ? "" : ", ") + format_quantity(radius, Dimension::length);
    list.push_back(motion_name(*answer.mode, true) + " of " + answer.contact +
                   (answer.radii.size() > 1 ? " (radii " + radii + ")" : "") + ": " + verdict_words(answer) +
                   "." + (answer.choice ? odds_words(*answer.choice) : "") +
                   exponents_words(answer, "load", "1", "1.33", "0.33") +
                   exponents_words(answer, "radius", "1", "0.33", "1.33") + without_offset_words(answer));
  }
  return list;
}

}  // namespace asperity

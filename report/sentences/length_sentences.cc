#include <algorithm>
#include <cmath>

#include "core/joined.h"
#include "core/printed.h"
#include "report/sentences/phrases.h"
#include "report/sentences/resistance_answers.h"

namespace asperity::report {
namespace {

using Verdict = LengthAnswer::Verdict;

const char* verdict_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::particle_radius:
      return "λ = r";
    case Verdict::contact_radius:
      return "λ = a";
    case Verdict::neither:
      return "neither λ = r nor λ = a";
    default:
      return "not identifiable";
  }
}

/// With the interval of the exponents; "" where none is known.
std::string exponents_sentence(const LengthAnswer& answer, const std::string& over) {
  double low = INFINITY, high = -INFINITY;
  const ScalingExponent* last = nullptr;
  for (const auto& exponent : answer.exponents) {
    const double found = exponent.exponent.slope.value;
    if (exponent.over != over || !std::isfinite(found)) continue;
    low = std::min(low, found), high = std::max(high, found), last = &exponent;
  }
  if (!last) return "";
  const auto hundredths = [](double value) { return std::round(100 * value) / 100; };
  return say(
      " The moment grows with the {} to the power {} (λ = r without offset: {}, λ = a: {}{}).",
      {over,
       low == high ? number_text(last->exponent.slope) : interval_text(hundredths(low), hundredths(high)),
       number_text({last->with_radius}), number_text({last->with_contact}),
       std::isfinite(last->with_bonds)
           ? say(", bonds along a smooth rim: {}", {number_text({last->with_bonds})})
           : ""});
}

std::string odds_sentence(const LengthAnswer& answer) {
  if (!answer.choice || answer.choice->log_odds == 0) return "";
  const LengthChoice& choice = *answer.choice;
  constexpr double most_that_matters = 1e6;
  const double odds = std::exp(std::abs(choice.log_odds));
  const bool is_contact = choice.log_odds > 0;
  return say(" Odds {} to 1 for λ = {}, an offset h left free{}; with it {}.",
             {odds > most_that_matters ? "above 10⁶" : number_text({odds}), is_contact ? "a" : "r",
              choice.is_told() ? "" : printed(" (decisive from %.0f to 1)", LengthChoice::telling_odds),
              law_words(is_contact ? choice.with_contact : choice.with_radius)});
}

std::string without_offset_sentence(const LengthAnswer& answer) {
  const Verdict alone = answer.without_offset();
  if (answer.verdict != Verdict::cannot_tell || alone == Verdict::cannot_tell) return "";
  return say(" Without an offset the exponents would give {}; more loads or radii would identify h.",
             {verdict_text(alone)});
}

}  // namespace

std::string length_verdict(const LengthAnswer& answer) {
  std::string text = verdict_text(answer.verdict);
  if (answer.verdict != Verdict::neither || !answer.choice || !answer.choice->is_told()) return text;
  return text + ", of the two rather λ = " + (answer.choice->log_odds > 0 ? "a" : "r");
}

std::vector<std::string> length_sentences(const std::vector<LengthAnswer>& lengths) {
  std::vector<std::string> list;
  for (const auto& answer : lengths) {
    std::vector<std::string> radii;
    for (const double radius : answer.radii) radii.push_back(length_text(radius));
    list.push_back(motion_name(*answer.mode, true) + " of " + answer.contact +
                   (radii.size() > 1 ? say(" (radii {})", {joined(radii, ", ")}) : "") + ": " +
                   length_verdict(answer) + "." + odds_sentence(answer) + exponents_sentence(answer, "load") +
                   exponents_sentence(answer, "radius") + without_offset_sentence(answer));
  }
  return list;
}

}  // namespace asperity::report

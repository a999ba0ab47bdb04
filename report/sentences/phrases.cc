#include "report/sentences/phrases.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/printed.h"
#include "dem_compare/cases/path_averages.h"

namespace asperity::report {
namespace {

/// With a minus sign in place of the hyphen; no "-0.0".
std::string with_decimals(double value, int decimals) {
  const std::string text = printed("%.*f", std::max(0, decimals), std::abs(value));
  return (value < 0 && text.find_first_of("123456789") != std::string::npos ? "−" : "") + text;
}

/// As many decimals as two digits of the sd ask for.
std::string value_and_sd(const Uncertain& number) {
  const int decimals = 1 - static_cast<int>(std::floor(std::log10(number.sd)));
  return with_decimals(number.value, decimals) + " ± " + with_decimals(number.sd, decimals);
}

std::string power_of_ten(int exponent) {
  static const char* const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) text += digits[digit - '0'];
  return text;
}

}  // namespace

std::string say(const std::string& pattern, std::initializer_list<std::string> texts) {
  std::string said;
  std::size_t from = 0;
  for (const auto& text : texts) {
    const std::size_t place = pattern.find("{}", from);
    said += pattern.substr(from, place - from) + text;
    from = place + 2;
  }
  return said + pattern.substr(from);
}

std::string motion_name(const MotionMode& mode, bool capital) {
  std::string name = name_of(mode.motion);
  if (capital) name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

std::string number_text(const Uncertain& number) {
  if (!std::isfinite(number.value)) return "unknown";
  const bool has_sd = number.has_sd() && number.sd > 0;
  const double size = std::max(std::abs(number.value), has_sd ? number.sd : 0);
  constexpr double large = 1e5, small = 1e-3;
  const bool is_plain = size == 0 || (size >= (has_sd ? small : 0.1 * small) && size < large);
  const int exponent = is_plain ? 0 : static_cast<int>(std::floor(std::log10(size)));
  const Uncertain scaled = number * std::pow(10.0, -exponent);
  std::string text =
      has_sd ? value_and_sd(scaled) : (scaled.value < 0 ? "−" : "") + printed("%.3g", std::abs(scaled.value));
  if (is_plain) return text;
  return (has_sd ? "(" + text + ") " : text + "·") + power_of_ten(exponent);
}

std::string plus_minus(const Scatter& scatter, double unit, int digits) {
  if (!std::isfinite(scatter.mean)) return "–";
  // Beyond these decimals of the chosen unit a number is zero to whoever reads the table.
  constexpr int most_decimals = 4;
  if (scatter.mean == 0 && !(scatter.sd > 0)) return "0";
  const double sd = scatter.sd / unit;
  const double mean =
      std::abs(scatter.mean / unit) < 0.5 * std::pow(10, -most_decimals) ? 0.0 : scatter.mean / unit;
  const auto place = [](double x) {
    return x > 0 ? static_cast<int>(std::floor(std::log10(x))) : -most_decimals;
  };
  const auto decimals = [&](int wanted) { return std::clamp(wanted, 0, most_decimals); };
  if (!std::isfinite(sd)) return printed("%.*f", decimals(digits - 1 - place(std::abs(mean))), mean);
  // As many decimals as show two digits of the scatter, but not more digits of the mean than asked for plus
  // one.
  const int shown = decimals(std::min(1 - place(sd), digits - place(std::abs(mean))));
  return printed("%.*f ± %.*f", shown, mean, shown, sd);
}

std::string mesh_error_text(const Estimate& estimate) {
  if (!estimate.mesh || !std::isfinite(estimate.mesh->relative_error)) return "–";
  const double error = 100 * estimate.mesh->relative_error, doubt = 100 * estimate.mesh->standard_error;
  constexpr double whole_percents_from = 9.95;
  const int decimals =
      std::max(std::abs(error), std::isfinite(doubt) ? doubt : 0) < whole_percents_from ? 1 : 0;
  const std::string size = printed("%.*f", decimals, std::abs(error));
  const bool is_zero = size.find_first_of("123456789") == std::string::npos;
  return (is_zero     ? ""
          : error < 0 ? "−"
                      : "+") +
         size + (std::isfinite(doubt) ? printed(" ± %.*f", decimals, doubt) : "") + " %";
}

std::string interval_text(double low, double high) {
  return number_text({low}) + (low == high ? "" : " to " + number_text({high}));
}

std::string change_percent(const Uncertain& share) {
  return (share.value > 0 ? "+" : "") + number_text(share * per_cent) + " %";
}

std::string moment_text(const Uncertain& moment) {
  constexpr double pico = 1e-12;
  return number_text(moment * (1 / pico)) + " pN m";
}

std::string force_text(double force) { return format_quantity(force, Dimension::force); }

std::string length_text(double length) { return format_quantity(length, Dimension::length); }

std::string share_text(double share) {
  const double percents = per_cent * share;
  return printed(std::abs(percents) >= 10 ? "%.0f %%" : "%.2g %%", percents);
}

std::string quantity_text(const Uncertain& quantity, Dimension dimension) {
  constexpr int digits = 4;
  std::string text = format_quantity(quantity.value, dimension, digits);
  if (!(quantity.has_sd() && quantity.sd > 0)) return text;
  const auto blank = text.find(' ');
  if (blank == std::string::npos) return number_text(quantity);
  const std::string unit = text.substr(blank + 1);
  return number_text(quantity * (1 / unit_factor(unit, dimension))) + " " + unit;
}

std::string quantity_text(const Uncertain& quantity, const std::string& unit) {
  if (!unit.empty() && unit.front() == 'N') return quantity_text(quantity, Dimension::force) + unit.substr(1);
  return quantity_text(quantity, Dimension::none) + (unit.empty() ? "" : " " + unit);
}

std::string law_words(const ResistanceLaw& law, const std::string& symbol) {
  constexpr double micro = 1e-6;
  return say("{} = {}, h = {}",
             {symbol, number_text({law.coefficient, law.coefficient_sd()}),
              law.has_offset ? number_text({law.offset / micro, law.offset_sd() / micro}) + " uN"
                             : "0 (not identifiable)"});
}

std::string sigma_text(double sigmas) { return printed("%.3g σ", std::round(10 * std::abs(sigmas)) / 10); }

std::string bodies_dissipate_by(bool yields, bool relaxes) {
  if (!relaxes) return "yielding";
  return yields ? "yielding and relaxation" : "relaxation";
}

std::string bodies_dissipate_by(const std::vector<const MovingContact*>& contacts) {
  const auto any = [&](bool MovingContact::*member) {
    return std::any_of(contacts.begin(), contacts.end(),
                       [&](const auto* contact) { return contact->*member; });
  };
  return bodies_dissipate_by(any(&MovingContact::can_yield), any(&MovingContact::relaxes));
}

std::string bodies_dissipate_by(const MovingStudy& study) {
  std::vector<const MovingContact*> contacts;
  for (const MovingContact& contact : study.contacts) contacts.push_back(&contact);
  return bodies_dissipate_by(contacts);
}

Uncertain per_nanometre(const Uncertain& slope) { return slope * 1e-9; }

std::string with_roughness(Trend::Sign sign) {
  switch (sign) {
    case Trend::Sign::rises:
      return "rises with roughness";
    case Trend::Sign::falls:
      return "falls with roughness";
    case Trend::Sign::none:
      return "shows no significant trend with roughness";
    default:
      return "shows a trend of unknown significance with roughness";
  }
}

std::string trend_words(const Uncertain& relative) {
  const Uncertain percent = per_nanometre(relative) * per_cent;
  switch (sign_of(relative)) {
    case Trend::Sign::rises:
      return say("rises by {} % per nm of RMS", {number_text(percent)});
    case Trend::Sign::falls:
      return say("falls by {} % per nm of RMS", {number_text(percent * -1)});
    case Trend::Sign::none:
      return say("has no significant trend ({} % per nm of RMS)", {number_text(percent)});
    default:
      return "changes with RMS by an amount of unknown significance";
  }
}

std::string significance(const Uncertain& number) {
  const Trend::Sign sign = sign_of(number);
  return sign == Trend::Sign::none      ? " (not significant)"
         : sign == Trend::Sign::unknown ? " (of unknown significance)"
                                        : "";
}

}  // namespace asperity::report

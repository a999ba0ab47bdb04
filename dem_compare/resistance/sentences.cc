#include "dem_compare/resistance/sentences.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>

namespace asperity {
namespace {

constexpr double nm = 1e-9, per_cent = 100;

std::string with_decimals(double value, int decimals) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*f", std::max(0, decimals), value);
  const std::string text = buffer;
  return text.find_first_of("123456789") == std::string::npos && text.front() == '-' ? text.substr(1)
                                                                                     : text;  // no -0.0
}

/// As many decimals as two digits of the sd ask for.
std::string value_and_sd(double value, double sd) {
  const int decimals = 1 - static_cast<int>(std::floor(std::log10(sd)));
  return with_decimals(value, decimals) + " +- " + with_decimals(sd, decimals);
}

}  // namespace

std::string motion_name(const MotionMode& mode, bool capital) {
  std::string name = name_of(mode.motion);
  if (capital) name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

std::string number_text(const Uncertain& number) {
  if (!std::isfinite(number.value)) return "unknown";
  const bool has_sd = number.has_sd() && number.sd > 0;
  if (!has_sd) {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, "%.3g", number.value == 0 ? 0 : number.value);
    return buffer;
  }
  constexpr double large = 1e5, small = 1e-3;
  const double size = std::max(std::abs(number.value), number.sd);
  if (size >= small && size < large) return value_and_sd(number.value, number.sd);
  const int exponent = static_cast<int>(std::floor(std::log10(size)));
  const double unit = std::pow(10.0, exponent);
  return "(" + value_and_sd(number.value / unit, number.sd / unit) + ") 10^" + std::to_string(exponent);
}

std::string change_percent(const Uncertain& share) {
  return (share.value > 0 ? "+" : "") + number_text({per_cent * share.value, per_cent * share.sd}) + " %";
}

std::string moment_text(const Uncertain& moment) {
  constexpr double pico = 1e-12;
  return number_text({moment.value / pico, moment.sd / pico}) + " pN m";
}

std::string force_text(double force) { return format_quantity(force, Dimension::force); }

Trend::Sign sign_of(const Uncertain& number) {
  Trend trend;
  trend.slope = number;
  return trend.sign();
}

std::string trend_words(const Uncertain& relative) {
  const Uncertain per_nm{relative.value * nm * per_cent, relative.sd * nm * per_cent};
  switch (sign_of(relative)) {
    case Trend::Sign::rises:
      return "rises by " + number_text(per_nm) + " % per nm of RMS";
    case Trend::Sign::falls:
      return "falls by " + number_text({-per_nm.value, per_nm.sd}) + " % per nm of RMS";
    case Trend::Sign::none:
      return "has no trend within " + number_text({2 * per_nm.sd}) + " % per nm of RMS (" +
             number_text(per_nm) + ")";
    default:
      return "changes with RMS in a way that cannot be told: its uncertainty is not known";
  }
}

}  // namespace asperity

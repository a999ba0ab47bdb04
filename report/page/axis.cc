#include "report/page/axis.h"

#include <algorithm>
#include <cmath>

#include "core/printed.h"

namespace asperity::report {
namespace {

constexpr double rounding = 1e-9;

double round_step(double range, int about_ticks) {
  const double raw = range / about_ticks, power = std::pow(10, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (raw <= factor * power * (1 + rounding)) return factor * power;
  return 10 * power;
}

}  // namespace

Axis make_axis(double low, double high, double pixel_low, double pixel_high, bool widen, int about_ticks) {
  if (!(high > low)) {
    const double half = low == 0 ? 1 : std::abs(low) / 2;
    low -= half;
    high += half;
  }
  const double step = round_step(high - low, about_ticks);
  if (widen) {
    low = std::floor(low / step + rounding) * step;
    high = std::ceil(high / step - rounding) * step;
  }
  Axis axis{low, high, pixel_low, pixel_high, {}};
  for (double i = std::ceil(low / step - rounding); i * step <= high + rounding * step; ++i)
    axis.ticks.push_back(i * step);
  return axis;
}

std::string tick_label(double value, const Axis& axis) {
  const double step = axis.ticks.size() > 1 ? axis.ticks[1] - axis.ticks[0] : std::abs(value);
  const int decimals = step > 0 ? std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-6))) : 0;
  constexpr int most_decimals = 4;
  constexpr double largest_plain = 1e6;
  if (decimals > most_decimals || std::abs(value) >= largest_plain) return printed("%.3g", value);
  return printed("%.*f", decimals, std::abs(value) < step / 2 ? 0.0 : value);
}

std::string coordinate(double value) { return printed("%.2f", value); }

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else if (c == '&')
      safe += "&amp;";
    else if (c == '"')
      safe += "&quot;";
    else
      safe += c;
  }
  return safe;
}

}  // namespace asperity::report

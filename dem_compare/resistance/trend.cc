#include "dem_compare/resistance/trend.h"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

constexpr double two_sigma = 2;

}  // namespace

Trend::Sign sign_of(const Uncertain& number) {
  if (!number.has_sd()) return Trend::Sign::unknown;
  if (std::abs(number.value) <= two_sigma * number.sd) return Trend::Sign::none;
  return number.value > 0 ? Trend::Sign::rises : Trend::Sign::falls;
}

Trend::Sign Trend::sign() const { return sign_of(slope); }

Uncertain Trend::relative() const {
  const double share = slope.value / mean.value;
  return {share, std::hypot(slope.sd / mean.value, share * mean.sd / mean.value)};
}

Trend fit_trend(const std::vector<double>& all_x, const std::vector<Uncertain>& all_y) {
  std::vector<double> x;
  std::vector<Uncertain> y;
  for (std::size_t i = 0; i < all_x.size(); ++i)
    if (std::isfinite(all_x[i]) && std::isfinite(all_y[i].value))
      x.push_back(all_x[i]), y.push_back(all_y[i]);
  Trend trend;
  trend.points = static_cast<int>(x.size());
  if (x.empty()) return trend;
  const auto count = static_cast<double>(x.size());
  double mean_x = 0, variance = 0;
  trend.mean.value = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += x[i] / count, trend.mean.value += y[i].value / count;
    variance += y[i].sd * y[i].sd / (count * count);
  }
  trend.mean.sd = std::sqrt(variance);
  double xx = 0, xy = 0, of_points = 0, misfit = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double from_mean = x[i] - mean_x;
    xx += from_mean * from_mean, xy += from_mean * y[i].value;
    of_points += from_mean * from_mean * y[i].sd * y[i].sd;
  }
  if (x.size() < 2 || !(xx > 0)) return trend;
  trend.slope.value = xy / xx;
  for (std::size_t i = 0; i < x.size(); ++i)
    misfit += std::pow(y[i].value - trend.mean.value - trend.slope.value * (x[i] - mean_x), 2);
  const double of_misfit = x.size() > 2 ? std::sqrt(misfit / (count - 2) / xx) : 0;
  of_points = std::sqrt(of_points) / xx;
  trend.slope.sd = std::isfinite(of_points) ? std::max(of_points, of_misfit) : of_points;
  return trend;
}

Trend fit_exponent_of(const std::vector<double>& x, const std::vector<Uncertain>& y) {
  std::vector<double> log_x;
  std::vector<Uncertain> log_y;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(y[i].value)) continue;
    if (!(y[i].value > two_sigma * y[i].sd)) return {};
    log_x.push_back(std::log(x[i]));
    log_y.push_back({std::log(y[i].value), y[i].sd / y[i].value});
  }
  return fit_trend(log_x, log_y);
}

Uncertain cautious_mean(const std::vector<Uncertain>& values) {
  double weights = 0, sum = 0, sd = 0;
  for (const auto& value : values) {
    if (!std::isfinite(value.value) || !(value.sd > 0)) continue;
    const double w = 1 / (value.sd * value.sd);
    weights += w, sum += w * value.value, sd += w * value.sd;
  }
  if (weights == 0) return {std::nan(""), std::nan("")};
  return {sum / weights, sd / weights};
}

}  // namespace asperity

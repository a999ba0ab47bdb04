#include "dem_compare/resistance/trend.h"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

constexpr double two_sigma = 2;

struct Points {
  std::vector<double> x, y, sd;
  bool has_sds = true;
};

/// Where the sds are zero (nothing is dissipated, say), they are taken as a tiny share of the values.
Points usable(const std::vector<double>& x, const std::vector<Uncertain>& y) {
  constexpr double tiny = 1e-9;
  Points points;
  double largest = 0;
  for (const auto& value : y)
    if (std::isfinite(value.value)) largest = std::max(largest, std::abs(value.value));
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(x[i]) || !std::isfinite(y[i].value)) continue;
    points.x.push_back(x[i]), points.y.push_back(y[i].value);
    points.sd.push_back(std::max(y[i].sd, std::max(tiny * largest, std::numeric_limits<double>::min())));
    points.has_sds = points.has_sds && y[i].has_sd();
  }
  if (!points.has_sds) points.sd.assign(points.x.size(), 1);
  // Weights matter by their ratios alone: no underflow of energies in joule.
  return points;
}

}  // namespace

Trend::Sign Trend::sign() const {
  if (!slope.has_sd()) return Sign::unknown;
  if (std::abs(slope.value) <= two_sigma * slope.sd) return Sign::none;
  return slope.value > 0 ? Sign::rises : Sign::falls;
}

Uncertain Trend::relative() const {
  const double share = slope.value / mean.value;
  return {share, std::hypot(slope.sd / mean.value, share * mean.sd / mean.value)};
}

Trend fit_trend(const std::vector<double>& x, const std::vector<Uncertain>& y) {
  const Points p = usable(x, y);
  Trend trend;
  trend.points = static_cast<int>(p.x.size());
  if (p.x.empty()) return trend;
  const double unit = *std::min_element(p.sd.begin(), p.sd.end());
  double weights = 0, mean_x = 0, mean_y = 0;
  for (std::size_t i = 0; i < p.x.size(); ++i) {
    const double w = std::pow(unit / p.sd[i], 2);
    weights += w, mean_x += w * p.x[i], mean_y += w * p.y[i];
  }
  mean_x /= weights, mean_y /= weights;
  trend.mean = {mean_y, p.has_sds ? unit / std::sqrt(weights) : std::nan("")};
  double xx = 0, xy = 0;
  for (std::size_t i = 0; i < p.x.size(); ++i) {
    const double w = std::pow(unit / p.sd[i], 2);
    xx += w * (p.x[i] - mean_x) * (p.x[i] - mean_x), xy += w * (p.x[i] - mean_x) * (p.y[i] - mean_y);
  }
  if (p.x.size() < 2 || !(xx > 0)) return trend;
  trend.slope.value = xy / xx;
  double misfit = 0;
  for (std::size_t i = 0; i < p.x.size(); ++i)
    misfit += std::pow((p.y[i] - mean_y - trend.slope.value * (p.x[i] - mean_x)) / p.sd[i], 2);
  const double freedom = static_cast<double>(p.x.size()) - 2, excess = freedom > 0 ? std::max(1.0, misfit / freedom) : 1;
  if (p.has_sds) trend.slope.sd = unit * std::sqrt(excess / xx);
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

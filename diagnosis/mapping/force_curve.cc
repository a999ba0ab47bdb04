#include "diagnosis/mapping/force_curve.h"

#include <algorithm>
#include <boost/math/interpolators/makima.hpp>
#include <cmath>

namespace asperity {

double ForceCurve::scaled(double force) { return std::copysign(std::cbrt(force * force), force); }

void ForceCurve::finish() {
  std::stable_sort(points_.begin(), points_.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  constexpr std::size_t fewest = 4;
  std::vector<double> y;
  for (const auto& [x, value] : points_)
    if (x_.empty() || x > x_.back()) x_.push_back(x), y.push_back(value);
  if (x_.size() < fewest) return;
  std::vector<double> at = x_, values = y;
  const boost::math::interpolators::makima<std::vector<double>> akima(std::move(at), std::move(values));
  for (const double x : x_) slopes_.push_back(akima.prime(x));
  smooth_ = std::make_shared<Smooth>(std::vector<double>(x_), std::move(y), std::vector<double>(slopes_));
}

double ForceCurve::at(double force) const {
  const double x = scaled(force);
  if (points_.empty()) return 0;
  if (x <= points_.front().first) return points_.front().second;
  if (x >= points_.back().first) return points_.back().second;
  if (smooth_) return (*smooth_)(x);
  const auto after = std::upper_bound(points_.begin(), points_.end(), x,
                                      [](double value, const auto& point) { return value < point.first; });
  const auto before = after - 1;
  const double width = after->first - before->first;
  return before->second + (width > 0 ? (x - before->first) / width * (after->second - before->second) : 0.0);
}

/// Cubics with the same ends add up to the cubic with the sum of their values and slopes there.
ForceCurve ForceCurve::sum(const std::vector<ForceCurve>& curves, const std::vector<double>& factors) {
  ForceCurve sum;
  if (curves.empty()) return sum;
  sum.points_ = curves.front().points_;
  sum.x_ = curves.front().x_;
  for (auto& point : sum.points_) point.second = 0;
  sum.slopes_.assign(curves.front().slopes_.size(), 0.0);
  std::vector<double> values(sum.slopes_.size(), 0.0);
  for (std::size_t k = 0; k < curves.size(); ++k) {
    if (factors[k] == 0) continue;
    const ForceCurve& curve = curves[k];
    for (std::size_t i = 0; i < sum.points_.size(); ++i)
      sum.points_[i].second += factors[k] * curve.points_[i].second;
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] += factors[k] * (*curve.smooth_)(curve.x_[i]);
      sum.slopes_[i] += factors[k] * curve.slopes_[i];
    }
  }
  if (!values.empty())
    sum.smooth_ = std::make_shared<Smooth>(std::vector<double>(sum.x_), std::move(values),
                                           std::vector<double>(sum.slopes_));
  return sum;
}

}  // namespace asperity

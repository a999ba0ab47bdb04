#include "dem_compare/derive/rolling_stiffness.h"

#include <boost/math/interpolators/makima.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace asperity {
namespace {

/// Moment of the path out as a function of the angle.
class PathOut {
 public:
  PathOut(const std::vector<double>& angle, const std::vector<double>& moment, const MotionLeg& leg)
      : direction_(leg.direction) {
    std::vector<double> x, y;
    for (std::size_t i = leg.first; i <= leg.last; ++i) {
      if (!x.empty() && direction_ * angle[i] <= x.back()) continue;  // rests on the path
      x.push_back(direction_ * angle[i]);
      y.push_back(moment[i]);
    }
    if (x.size() < fewest_points) return;
    low_ = x.front(), high_ = x.back();
    spline_.emplace(std::move(x), std::move(y));
  }
  bool covers(double angle) const {
    return spline_ && direction_ * angle >= low_ && direction_ * angle <= high_;
  }
  double operator()(double angle) const { return (*spline_)(direction_ * angle); }

 private:
  static constexpr std::size_t fewest_points = 4;
  int direction_;
  double low_ = 0, high_ = 0;
  std::optional<boost::math::interpolators::makima<std::vector<double>>> spline_;
};

}  // namespace

ReversalStiffness rolling_stiffness(const std::vector<double>& angle, const std::vector<double>& moment,
                                    double resistance) {
  constexpr int fewest_rows = 3;
  const auto legs = motion_legs(angle);
  if (legs.size() < 2) return {};
  const MotionLeg &out = legs[0], &back = legs[1];
  const PathOut moment_out(angle, moment, out);
  std::vector<double> path, lack;
  for (std::size_t i = back.first + 1; i <= back.last && moment_out.covers(angle[i]); ++i) {
    path.push_back(std::abs(angle[i] - angle[back.first]));
    lack.push_back(out.direction * (moment_out(angle[i]) - moment[i]));
    if (lack.back() >= resistance && path.size() >= fewest_rows) break;
  }
  if (path.size() < fewest_rows) return {};
  double square = 0, product = 0;
  for (std::size_t i = 0; i < path.size(); ++i) square += path[i] * path[i], product += path[i] * lack[i];
  const double slope = product / square;
  double misfit = 0;
  for (std::size_t i = 0; i < path.size(); ++i) misfit += std::pow(lack[i] - slope * path[i], 2);
  return {slope, std::sqrt(misfit / static_cast<double>(path.size() - 1) / square)};
}

}  // namespace asperity

#include "dem_compare/cases/reversal_stiffness.h"

#include <boost/math/interpolators/makima.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/steady_motion.h"
#include "dem_compare/laws/lubkin_torsion.h"

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

double sliding_partial_slip(double share) {
  if (share < std::sqrt(std::numeric_limits<double>::epsilon())) return 1;
  return 1.5 / share * (1 - std::pow(1 - share, 2.0 / 3.0));
}

double torsion_partial_slip(double share) {
  // Of a contact with K = (16/3) Gt a^3 = 1.
  const LubkinTorsion unit{3.0 / 16.0, 1, 1, 1};
  const double moment = share * unit.full_slip_moment();
  return moment > 0 ? unit.angle(moment) / moment : 1;
}

PartialSlip partial_slip_of(Motion motion) {
  if (motion == Motion::sliding) return sliding_partial_slip;
  if (motion == Motion::torsion) return torsion_partial_slip;
  return [](double) { return 1.0; };
}

ReversalStiffness reversal_stiffness(const std::vector<double>& x, const std::vector<double>& y,
                                     double full_slip, const PartialSlip& partial_slip) {
  constexpr double most_of_full_slip = 0.95;
  double sum = 0, error = 0;
  int count = 0;
  const auto legs = motion_legs(x);
  for (std::size_t l = 1; l < legs.size(); ++l) {
    const std::size_t turn = legs[l].first;
    if (steady_onset({x, y, {}, {}, 0}, legs[l - 1]) > legs[l - 1].last || legs[l].last < turn + 2) continue;
    double change[2], stiffness[2];
    for (std::size_t i = 0; i < 2; ++i) {
      change[i] = std::abs(y[turn + 1 + i] - y[turn]);
      const double share = change[i] / (2 * full_slip);
      stiffness[i] = share < most_of_full_slip
                         ? change[i] / std::abs(x[turn + 1 + i] - x[turn]) * partial_slip(share)
                         : std::numeric_limits<double>::quiet_NaN();
    }
    const double at_turn = stiffness[0] + (stiffness[0] - stiffness[1]) * change[0] / (change[1] - change[0]);
    if (!std::isfinite(at_turn)) continue;
    sum += at_turn;
    error = std::max(error, std::abs(at_turn - stiffness[0]));
    ++count;
  }
  if (count == 0) return {};
  return {sum / count, error};
}

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

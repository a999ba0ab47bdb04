#include "dem_compare/laws/maugis_branch.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

namespace asperity {
namespace {

/// Radii [Maugis' unit] from a million, where attraction is nothing beside the load, down to 1e-4; the step
/// is that of ln u.
constexpr double largest_radius = 1e6, smallest_radius = 1e-4, step = 0.1;
/// Pull-off force of DMT over pi w R.
constexpr double of_dmt = 2;

/// Radius of the disc of attraction below which surfaces that do not touch part, in Maugis' unit.
double smallest_disc(double lambda) { return 8 * lambda / (3 * M_PI); }
/// Of the attraction, h0 = w/s0, over Maugis' unit of approach.
double range_over_approach(double lambda) { return 2 / (M_PI * lambda); }
/// Radius of the disc of surfaces that just touch: c^2/2 + (4 lambda/3)(1 - 2/pi) c = h0, where a falls to 0.
double disc_of_last_touch(double lambda) {
  const double q = 4.0 / 3 * lambda * (1 - 2 / M_PI);
  return std::sqrt(q * q + 2 * range_over_approach(lambda)) - q;
}
/// Radius of the disc over which surfaces that do not touch attract each other, down to where they part.
double disc_at(double lambda, double approach) {
  const double edge = smallest_disc(lambda),
               square = edge * edge + 2 * (range_over_approach(lambda) + approach);
  return edge + std::sqrt(std::max(0.0, square));
}

}  // namespace

MaugisBranch::State MaugisBranch::at(double place) const {
  const double l = lambda_, u = std::exp(place), t = std::atan(u), m2 = 1 + u * u, m = std::sqrt(m2);
  const double q = l / 2 * (u + (m2 - 2) * t), line = 4.0 / 3 * l * l * (u * t - m + 1);
  const double a = 2 / (line + std::sqrt(line * line + 4 * q));
  // By t, and then by ln u: dt = u/m^2 d(ln u).
  const double by_place = u / m2;
  const double q_slope = l * (u * u + m2 * u * t), line_slope = 4.0 / 3 * l * l * (m2 * t + u - m * u);
  const double a_slope = -(a * a * q_slope + a * line_slope) / (2 * a * q + line);
  return {place, a * a * a - l * a * a * (u + m2 * t), a * a - 4.0 / 3 * l * a * u,
          by_place * (2 * a * a_slope - 4.0 / 3 * l * (a_slope * u + a * m2))};
}

MaugisBranch::MaugisBranch(double lambda) : lambda_(lambda) {
  if (lambda == 0) {
    pull_off_ = of_dmt;
    return;
  }
  // Under large loads lambda a^2 (2/3) u^3 = 1.
  const double first = std::log(1.5 / (lambda * largest_radius * largest_radius)) / 3;
  // Small contacts have u = (4/(pi lambda))^(1/2)/a.
  const double last = std::log(std::sqrt(4 / (M_PI * lambda)) / smallest_radius);
  for (double place = first; place < last; place += step) {
    states_.push_back(at(place));
    if (states_.back().approach_slope > 0) break;
  }
  const auto least = [&](double from, double to, auto value) {
    return boost::math::tools::brent_find_minima([&](double x) { return value(at(x)); }, from, to, 40).first;
  };
  if (states_.back().approach_slope > 0) {
    const double to = states_.back().place;
    states_.pop_back();
    states_.push_back(at(least(states_.back().place, to, [](const State& s) { return s.approach; })));
  }
  release_ = parting_ = states_.back().approach;
  if (const double edge = smallest_disc(lambda); disc_of_last_touch(lambda) > edge)
    parting_ = std::min(release_, -0.5 * edge * edge - range_over_approach(lambda));
  const auto lowest = std::min_element(states_.begin(), states_.end(),
                                       [](const State& a, const State& b) { return a.force < b.force; });
  tensest_ = static_cast<std::size_t>(lowest - states_.begin());
  const auto before = lowest == states_.begin() ? lowest : lowest - 1,
             after = lowest + 1 == states_.end() ? lowest : lowest + 1;
  const State tensest = at(least(before->place, after->place, [](const State& s) { return s.force; }));
  if (tensest.force < lowest->force) {
    if (tensest.place > lowest->place) ++tensest_;
    states_.insert(states_.begin() + static_cast<long>(tensest_), tensest);
  }
  pull_off_ = -states_[tensest_].force;
}

template <class Value>
double MaugisBranch::place_of(double target, std::size_t last, const Value& value) const {
  const auto end = states_.begin() + static_cast<long>(last) + 1;
  const auto below =
      std::partition_point(states_.begin(), end, [&](const State& s) { return value(s) > target; });
  if (below == end) return states_[last].place;
  if (below == states_.begin()) return states_.front().place;
  const State &high = *(below - 1), &low = *below;
  if (value(low) == target) return low.place;
  constexpr int bits = 45;
  std::uintmax_t iterations = 60;
  const auto bracket = boost::math::tools::toms748_solve(
      [&](double place) { return value(at(place)) - target; }, high.place, low.place, value(high) - target,
      value(low) - target, boost::math::tools::eps_tolerance<double>(bits), iterations);
  return 0.5 * (bracket.first + bracket.second);
}

double MaugisBranch::force(double approach) const {
  if (states_.empty()) return approach * std::sqrt(approach) - of_dmt;
  if (approach > states_.front().approach) return approach * std::sqrt(approach);
  return at(place_of(approach, states_.size() - 1, [](const State& s) { return s.approach; })).force;
}

double MaugisBranch::force_apart(double approach) const {
  if (lambda_ == 0) return -of_dmt;
  const double c = disc_at(lambda_, approach);
  return -0.5 * M_PI * lambda_ * c * c;
}

double MaugisBranch::approach(double force) const {
  if (states_.empty()) return std::cbrt(std::pow(force + of_dmt, 2));
  if (force > states_.front().force) return std::cbrt(force * force);
  return at(place_of(force, tensest_, [](const State& s) { return s.force; })).approach;
}

}  // namespace asperity

#include "dem_compare/laws/maugis_branch.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>

#include "core/root.h"

namespace asperity {
namespace {

/// Radii [Maugis' unit] from a million, where attraction is nothing beside the load, down to 1e-4.
constexpr double largest_radius = 1e6, smallest_radius = 1e-4;
/// Step of ln u to the next state: the cubics between are within 1e-9 of the force, or of pi w R. What
/// attraction adds to a^3 grows as a^(3/2), and the least forces are smooth in a^(1/2).
double step_after(double radius) {
  constexpr double step = 0.0125, longest = 0.5;
  const double longer = radius > 1 ? std::pow(radius, 0.375) : 1 / std::sqrt(radius);
  return std::min(longest, step * longer);
}
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

/// Part of an interval, 0 to 1, at which the cubic of these values and slopes at its ends has a value between
/// them; the slopes are those over the whole interval.
double part_of_cubic(double from, double slope_from, double to, double slope_to, double value) {
  const double secant = to - from, square = 3 * secant - 2 * slope_from - slope_to,
               cube = slope_from + slope_to - 2 * secant;
  double t = (value - from) / secant;
  constexpr int steps = 3;
  for (int i = 0; i < steps; ++i) {
    const double off = from + t * (slope_from + t * (square + t * cube)) - value,
                 slope = slope_from + t * (2 * square + t * 3 * cube);
    if (slope * secant > 0) t = std::clamp(t - off / slope, 0.0, 1.0);
  }
  return t;
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
  const double tension = u + m2 * t, tension_slope = 2 * m2 * (1 + u * t);
  State s{};
  s.place = place, s.radius = a, s.edge = a * m;
  s.force = a * a * a - l * a * a * tension;
  s.approach = a * a - 4.0 / 3 * l * a * u;
  s.force_slope = by_place * a * (3 * a * a_slope - l * (2 * a_slope * tension + a * tension_slope));
  s.approach_slope = by_place * (2 * a * a_slope - 4.0 / 3 * l * (a_slope * u + a * m2));
  s.radius_slope = by_place * a_slope;
  s.edge_slope = m * s.radius_slope + a * u * u / m;
  return s;
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
  for (double place = first; place < last; place += step_after(states_.back().radius)) {
    states_.push_back(at(place));
    if (states_.back().approach_slope > 0) break;
  }
  const auto least = [&](double from, double to, auto value) {
    return boost::math::tools::brent_find_minima([&](double x) { return value(at(x)); }, from, to, 40).first;
  };
  const bool jumps = states_.back().approach_slope > 0;
  if (jumps) {
    const double to = states_.back().place;
    states_.pop_back();
    const auto slope_at = [&](double place) { return at(place).approach_slope; };
    states_.push_back(at(root_between(slope_at, states_.back().place, to)));
  }
  release_ = parting_ = states_.back().approach;
  list_nodes(jumps);
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

void MaugisBranch::list_nodes(bool jumps) {
  for (auto s = states_.rbegin(); s != states_.rend(); ++s) {
    const double root = std::sqrt(std::max(0.0, s->approach - release_));
    double by_root = 2 * root / s->approach_slope;  // d(ln u)/d(root)
    // Where the contact breaks the approach is at its least: there d(ln u)/d(root) comes from its curvature.
    if (s == states_.rbegin()) {
      constexpr double off = 1e-4;  // of ln u
      const double rise = at(s->place + off).approach_slope - at(s->place - off).approach_slope;
      by_root = jumps ? -std::sqrt(2 / (rise / (2 * off))) : 0;
    }
    roots_.push_back(root);
    nodes_.push_back({s->force, s->radius, s->edge, by_root * s->force_slope, by_root * s->radius_slope,
                      by_root * s->edge_slope});
  }
}

MaugisBranch::Cubic MaugisBranch::cubic_at(double approach) const {
  const double root = std::sqrt(std::max(0.0, approach - release_));
  const auto after = std::upper_bound(roots_.begin() + 1, roots_.end() - 1, root);
  const auto low = static_cast<std::size_t>(after - roots_.begin()) - 1;
  const double width = roots_[low + 1] - roots_[low];
  return {nodes_[low], nodes_[low + 1], width, width > 0 ? (root - roots_[low]) / width : 0};
}

double MaugisBranch::Cubic::of(double Node::*value, double Node::*slope) const {
  const double rise = high.*value - low.*value, from = width * low.*slope, to = width * high.*slope;
  return low.*value + part * (from + part * (3 * rise - 2 * from - to + part * (from + to - 2 * rise)));
}

MaugisBranch::State MaugisBranch::where(double State::*value, double State::*slope, double target,
                                        std::size_t last) const {
  const auto end = states_.begin() + static_cast<long>(last) + 1;
  const auto below =
      std::partition_point(states_.begin(), end, [&](const State& s) { return s.*value > target; });
  if (below == end) return states_[last];
  const State& low = *below;
  if (below == states_.begin() || low.*value == target) return low;
  const State& high = *(below - 1);
  double left = high.place, right = low.place;
  const double width = right - left;
  double place =
      left + width * part_of_cubic(high.*value, width * high.*slope, low.*value, width * low.*slope, target);
  // The cubic is within some 1e-7 of the state but where the contact breaks: there Newton's method goes on.
  constexpr double near = 1e-7;
  constexpr int most_iterations = 60;
  for (int i = 0;; ++i) {
    State s = at(place);
    (s.*value > target ? left : right) = place;
    double move = (target - s.*value) / s.*slope;
    if (std::abs(move) <= near || i == most_iterations) {
      s.place += move, s.force += move * s.force_slope, s.approach += move * s.approach_slope;
      s.radius += move * s.radius_slope, s.edge += move * s.edge_slope;
      return s;
    }
    if (!(place + move > left && place + move < right)) move = 0.5 * (left + right) - place;
    place += move;
  }
}

MaugisBranch::Contact MaugisBranch::contact(double approach) const {
  const double a = std::sqrt(std::max(0.0, approach));
  if (approach > states_.front().approach) return {approach, a * a * a, a, a};
  const Cubic c = cubic_at(approach);
  return {approach, c.of(&Node::force, &Node::force_slope), c.of(&Node::radius, &Node::radius_slope),
          c.of(&Node::edge, &Node::edge_slope)};
}

MaugisBranch::Contact MaugisBranch::contact_under(double force) const {
  const double a = std::cbrt(std::max(0.0, force));
  if (force > states_.front().force) return {a * a, force, a, a};
  const State s = where(&State::force, &State::force_slope, force, tensest_);
  return {s.approach, s.force, s.radius, s.edge};
}

double MaugisBranch::edge_apart(double approach) const { return disc_at(lambda_, approach); }

double MaugisBranch::force(double approach) const {
  if (states_.empty()) return approach * std::sqrt(approach) - of_dmt;
  if (approach > states_.front().approach) return approach * std::sqrt(approach);
  return cubic_at(approach).of(&Node::force, &Node::force_slope);
}

double MaugisBranch::force_apart(double approach) const {
  if (lambda_ == 0) return -of_dmt;
  const double c = disc_at(lambda_, approach);
  return -0.5 * M_PI * lambda_ * c * c;
}

double MaugisBranch::approach(double force) const {
  if (states_.empty()) return std::cbrt(std::pow(force + of_dmt, 2));
  if (force > states_.front().force) return std::cbrt(force * force);
  return where(&State::force, &State::force_slope, force, tensest_).approach;
}

}  // namespace asperity

#include "dem_compare/laws/held_dugdale.h"

#include <algorithm>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <cmath>
#include <limits>

#include "core/root.h"

namespace asperity {
namespace {

/// Elliptic integrals of the modulus b/c from the angle arcsin(a/b) to a quarter turn: of the first kind F
/// and the second E. Both are those from 0 to the angle whose sine is (s/b)/(S(c)/c), by Carlson's forms
/// (1979).
struct EllipticParts {
  double second, difference;  ///< E, F - E
  double first() const { return second + difference; }
};
EllipticParts elliptic_parts(double a, double b, double c, double s, double S) {
  using InDouble = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
  constexpr double least = 1e-30;  // F has no limit at c = b
  const double y = std::max((c - b) * (c + b) / (S * S), least), x = y * (a / b) * (a / b),
               sine = s * c / (b * S), k_squared = (b / c) * (b / c),
               first = sine * boost::math::ellint_rf(x, y, 1.0, InDouble()),
               difference = k_squared * sine *
                            (sine * sine / 3 * boost::math::ellint_rd(x, y, 1.0, InDouble()) + a / b);
  return {first - difference, difference};
}

/// int_a^b ((b^2 - x^2)/(c^2 - x^2))^(1/2) dx.
double zone_integral(double b, double c, const EllipticParts& parts) {
  return c * parts.second - (c - b) * (c + b) / c * parts.first();
}

/// Twice a length, or twice that, and so on, where a function is positive.
template <class Function>
double where_positive(const Function& f, double length) {
  double high = 2 * length;
  while (!(f(high) > 0)) high *= 2;
  return high;
}

}  // namespace

bool HeldDugdale::solve(double target, bool is_force, const DugdaleContact& near,
                        DugdaleContact& found) const {
  double s = std::sqrt(std::max(0.0, (b_ - near.radius) * (b_ + near.radius))),
         c = std::max(near.attraction_edge, (1 + 1e-5) * b_);
  // With both works alike nothing moves at s = 0: it begins a little off, by what the zone is wide.
  constexpr double little = 0.1, most = 0.99;
  s = std::min(std::max(s, little * std::sqrt((c - b_) * (c + b_))), most * b_);
  constexpr int most_iterations = 40;
  constexpr double tolerance = 1e-6;  // of b; the step that ends the search leaves its square
  for (int i = 0; i < most_iterations; ++i) {
    constexpr double nearly_all = 1 - 1e-9;  // of a has gone, or of what lies between b and c
    if (s > nearly_all * b_ || b_ > nearly_all * c) return false;
    const Terms v = terms(s, c);
    const double off = (is_force ? v.force : v.approach) - target, by_s = is_force ? v.force_s : v.approach_s,
                 by_c = is_force ? v.force_c : v.approach_c, determinant = by_s * v.gap_c - by_c * v.gap_s;
    const double step_s = -(off * v.gap_c - by_c * v.gap) / determinant,
                 step_c = -(by_s * v.gap - off * v.gap_s) / determinant;
    if (!std::isfinite(step_s) || !std::isfinite(step_c)) return false;
    const double next_s = s + step_s, next_c = c + step_c;
    s = next_s <= 0 ? 0.1 * s : next_s >= b_ ? 0.1 * s + 0.9 * b_ : next_s;
    c = next_c <= b_ ? 0.3 * c + 0.7 * b_ : next_c;
    if (std::abs(step_s) + std::abs(step_c) < tolerance * b_) {
      found = {v.approach + v.approach_s * step_s + v.approach_c * step_c,
               v.force + v.force_s * step_s + v.force_c * step_c, radius(s), b_, c};
      (is_force ? found.force : found.approach) = target;
      return true;
    }
  }
  return false;
}

bool HeldDugdale::search(double approach, DugdaleContact& found) const {
  const auto above = [&](double s) { return terms(s, edge(s)).approach - approach; };
  const double end = last();
  if (above(0) <= 0 || above(end) >= 0) return false;
  const double s = root_between(above, 0.0, end), c = edge(s);
  found = {approach, terms(s, c).force, radius(s), b_, c};
  return true;
}

bool HeldDugdale::is_apart(const DugdaleContact& c) const {
  return c.approach <= -4.0 / 3 * l_ * (k_ * c.attraction_edge + (1 - k_) * b_);
}

DugdaleContact HeldDugdale::apart(double approach) const {
  const auto beyond = [&](double c) {
    const EllipticParts whole = elliptic_parts(0, b_, c, b_, c);
    return M_PI * (0.5 * c * c - approach) - 2 / l_ -
           8.0 / 3 * l_ * (k_ * c + (1 - k_) * zone_integral(b_, c, whole));
  };
  const double c = beyond(b_) >= 0 ? b_ : root_between(beyond, b_, where_positive(beyond, b_));
  return {approach, -0.5 * M_PI * l_ * (k_ * c * c + (1 - k_) * b_ * b_), 0, b_, c};
}

HeldDugdale::Terms HeldDugdale::terms(double s, double c) const {
  const double a = radius(s), S = std::sqrt((c - a) * (c + a)), t = std::atan2(S, a);
  const EllipticParts parts = elliptic_parts(a, b_, c, s, S);
  const double inner = 1 - k_, s_over_S = s > 0 ? s / S : 0, third = 4.0 / 3 * l_;
  Terms v;
  v.approach = a * a - third * (k_ * S + inner * s);
  v.approach_s = -2 * s - third * (k_ * s_over_S + inner);
  v.approach_c = -third * k_ * c / S;
  v.force = a * a * a - l_ * (k_ * (a * S + c * c * t) + inner * (a * s + b_ * b_ * std::atan2(s, a)));
  v.force_s = 1.5 * a * v.approach_s;
  v.force_c = -2 * l_ * k_ * c * (a / S + t);
  v.gap = a * S + (c * c - 2 * a * a) * t - 2 / l_ +
          2 * third * (k_ * (S * t - c + a) + inner * (s * t - zone_integral(b_, c, parts)));
  v.gap_s = -2 * t * v.approach_s;
  v.gap_c = 2 * (c * t + a * S / c) + 2 * third * (k_ * (c * t / S + a / c - 1) + inner * parts.difference);
  return v;
}

double HeldDugdale::radius(double s) const { return std::sqrt((b_ - s) * (b_ + s)); }

double HeldDugdale::edge(double s) const {
  const auto beyond = [&](double c) { return terms(s, c).gap; };
  const double least = b_ * (1 + std::numeric_limits<double>::epsilon());
  return beyond(least) >= 0 ? least : root_between(beyond, least, where_positive(beyond, b_));
}

double HeldDugdale::edge(double s, double near) const {
  double c = near;
  constexpr int most_iterations = 12;
  for (int i = 0; i < most_iterations; ++i) {
    const Terms v = terms(s, c);
    const double step = -v.gap / v.gap_c;
    c = c + step > b_ ? c + step : 0.5 * (c + b_);
    constexpr double tolerance = 1e-4;  // of c - b, by which gap_c varies; the last step leaves its square
    if (std::abs(step) < tolerance * (c - b_)) return c;
  }
  return edge(s);
}

double HeldDugdale::last() const {
  const double least = b_ * (1 + std::numeric_limits<double>::epsilon());
  const auto left_behind = [&](double s) { return terms(s, least).gap; };
  if (left_behind(b_) <= 0) return b_;
  if (left_behind(0) >= 0) return 0;
  return root_between(left_behind, 0.0, b_);
}

HeldCurve::HeldCurve(double lambda, double ratio, double held_edge) : b_(held_edge) {
  const HeldDugdale held(lambda, ratio, held_edge);
  constexpr int intervals = 32;
  const double end = held.last();
  ends_loose_ = end < b_;
  double c = held.edge(0), s_before = 0, by_s = 0;  // by_s: dc/ds, along which the next edge is looked for
  for (int i = 0; i <= intervals; ++i) {
    // Denser to the end, where c comes down to b as x ln x does or a goes as a root, and somewhat where it
    // begins, by the width of the zone.
    const double part = static_cast<double>(i) / intervals, left = 1 - part * std::sqrt(part),
                 s = end * (1 - left * left * left);
    if (i > 0) {
      const double ahead = c + by_s * (s - s_before);
      c = held.edge(s, ahead > b_ ? ahead : 0.5 * (c + b_));
    }
    const HeldDugdale::Terms v = held.terms(s, c);
    // d(approach)/ds vanishes at s = 0 where both works are alike, but not its ratio to d(force)/ds.
    const double a = held.radius(s), S = std::sqrt((c - a) * (c + a)), moved = 2 * std::atan2(S, a) / v.gap_c;
    nodes_.push_back({v.approach, v.force, (1.5 * a + v.force_c * moved) / (1 + v.approach_c * moved), a, c});
    s_before = s, by_s = -v.gap_s / v.gap_c;
  }
}

bool HeldCurve::is_beyond(double approach) const { return ends_loose_ && approach < nodes_.back().approach; }

bool HeldCurve::holds(double approach) const {
  return approach <= nodes_.front().approach && approach >= nodes_.back().approach;
}

DugdaleContact HeldCurve::at(double approach) const {
  const auto after = std::partition_point(nodes_.begin() + 1, nodes_.end() - 1,
                                          [&](const Node& n) { return n.approach > approach; });
  const Node &high = *(after - 1), &low = *after;
  const double width = high.approach - low.approach, t = width > 0 ? (approach - low.approach) / width : 0,
               rise = high.force - low.force, from = width * low.slope, to = width * high.slope;
  const double force = low.force + t * (from + t * (3 * rise - 2 * from - to + t * (from + to - 2 * rise)));
  return {approach, force, low.radius + t * (high.radius - low.radius), b_,
          low.edge + t * (high.edge - low.edge)};
}

}  // namespace asperity

#include "dem_compare/laws/mindlin_deresiewicz.h"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

using Eigen::Vector3d;
using Profile = std::vector<StripNode>;

/// Distance from a straight line below which a node is dropped, over the shift at gross slip: rounding, not
/// physics.
constexpr double straightness = 1e-13;
/// Largest angle [rad] between the slip of neighbouring nodes: between them the limit is followed along the
/// chord, which lies below the arc by the angle squared over eight.
constexpr double largest_turn = 0.02;
/// Shear that keeps turning adds a node in each step; above this many the straightest ones are dropped.
constexpr std::size_t most_nodes = 200;

Vector3d between(const StripNode& one, const StripNode& other, double depth) {
  return one.shift + (other.shift - one.shift) * ((depth - one.depth) / (other.depth - one.depth));
}

/// The old strips move by the increment; those that come into contact at s on the way have moved for the rest
/// of it.
Profile moved(const Profile& before, double approach, const Vector3d& increment) {
  Profile now;
  now.reserve(before.size() + 4);
  for (const auto& node : before) {
    if (node.depth >= approach) {
      if (node.depth > approach && !now.empty()) {  // the contact shrinks: cut
        const StripNode inside{now.back().depth, now.back().shift - increment};
        now.push_back({approach, between(inside, node, approach) + increment});
      } else {
        now.push_back({approach, node.shift + increment});
      }
      return now;
    }
    now.push_back({node.depth, node.shift + increment});
  }
  if (now.empty()) now.push_back({0, increment});
  now.push_back({approach, Vector3d::Zero()});
  return now;
}

/// Places in (0, 1) between two nodes where |u| meets the limit kappa (delta - s), ascending.
std::vector<double> crossings(const StripNode& one, const StripNode& other, double kappa, double approach) {
  const Vector3d change = other.shift - one.shift;
  const double limit = kappa * (approach - one.depth), limit_change = -kappa * (other.depth - one.depth);
  const double a = change.squaredNorm() - limit_change * limit_change,
               b = 2 * (one.shift.dot(change) - limit * limit_change),
               c = one.shift.squaredNorm() - limit * limit;
  // The squares lose half the digits of a thin slip zone; Newton's method on |u| - limit itself brings them
  // back.
  const auto polished = [&](double place) {
    for (int i = 0; i < 2; ++i) {
      const Vector3d shift = one.shift + place * change;
      const double size = shift.norm(), slope = size > 0 ? shift.dot(change) / size - limit_change : 0.0;
      if (slope != 0) place -= (size - (limit + place * limit_change)) / slope;
    }
    return std::clamp(place, 0.0, 1.0);
  };
  std::vector<double> places;
  const double discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return places;
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  for (const double root : {a != 0 ? q / a : -1.0, q != 0 ? c / q : -1.0})
    if (root > 0 && root < 1) places.push_back(polished(root));
  std::sort(places.begin(), places.end());
  return places;
}

/// Nodes where slip begins or ends, and where the direction of slip turns.
Profile refined(const Profile& profile, double kappa, double approach) {
  Profile now;
  now.reserve(2 * profile.size() + 4);
  // Places where slip begins lie on the limit up to rounding, and count as slipping.
  constexpr double on_the_limit = 1 - 1e-9;
  const auto slips = [&](const StripNode& node) {
    return node.shift.norm() >= on_the_limit * kappa * (approach - node.depth);
  };
  const auto append = [&](const StripNode& next) {  // with the nodes that a turn of the slip needs
    if (!now.empty() && slips(now.back()) && slips(next)) {
      const StripNode last = now.back();
      const double across = last.shift.cross(next.shift).norm(), along = last.shift.dot(next.shift);
      const double angle = std::atan2(across, along), from = last.shift.norm(), to = next.shift.norm();
      const int pieces = static_cast<int>(std::ceil(angle / largest_turn));
      for (int i = 1; i < pieces;
           ++i) {  // of equal angle: the law of sines on the straight line from u to u'
        const double turned = angle * i / pieces, one = from * std::sin(turned),
                     other = to * std::sin(angle - turned);
        const double depth = last.depth + (next.depth - last.depth) * one / (one + other);
        now.push_back({depth, between(last, next, depth)});
      }
    }
    now.push_back(next);
  };
  for (std::size_t i = 0; i < profile.size(); ++i) {
    if (i > 0)
      for (const double place : crossings(profile[i - 1], profile[i], kappa, approach)) {
        const double depth = profile[i - 1].depth + place * (profile[i].depth - profile[i - 1].depth);
        append({depth, between(profile[i - 1], profile[i], depth)});
      }
    append(profile[i]);
  }
  return now;
}

void cut_to_limit(Profile& profile, double kappa, double approach) {
  for (auto& node : profile) {
    const double limit = std::max(0.0, kappa * (approach - node.depth)), size = node.shift.norm();
    if (size > limit) node.shift *= limit > 0 ? limit / size : 0.0;
  }
}

/// Without the nodes that lie within `tolerance` of the line between their neighbours.
Profile without_straight_nodes(const Profile& profile, double tolerance) {
  Profile now;
  now.reserve(profile.size());
  for (std::size_t i = 0; i < profile.size(); ++i) {
    if (!now.empty() && profile[i].depth <= now.back().depth) continue;
    if (!now.empty() && i + 1 < profile.size() && profile[i + 1].depth > profile[i].depth &&
        (between(now.back(), profile[i + 1], profile[i].depth) - profile[i].shift).norm() <= tolerance)
      continue;
    now.push_back(profile[i]);
  }
  return now;
}

/// 8 G* int u dx with u linear in s = x^2/R between the nodes.
Vector3d resistance_of(const Profile& profile, double sliding_modulus, double radius) {
  Vector3d sum = Vector3d::Zero();
  double x = std::sqrt(radius * profile.front().depth);
  for (std::size_t i = 1; i < profile.size(); ++i) {
    const double next = std::sqrt(radius * profile[i].depth), weight = (next - x) / (3 * (next + x));
    sum += weight * ((2 * next + x) * profile[i - 1].shift + (next + 2 * x) * profile[i].shift);
    x = next;
  }
  return 8 * sliding_modulus * sum;
}

}  // namespace

SlidingHistory MindlinDeresiewicz::advance(const SlidingHistory& before, const NormalState& normal,
                                           const Vector3d& increment) const {
  const double a = normal.contact_radius, limit = friction.limit(normal.force);
  if (!normal.touching || a <= 0) return {};
  const double approach = a * a / radius;  // of the Hertzian contact with this area
  const double kappa = 3 * limit * radius / (16 * sliding_modulus * a * a * a), scale = kappa * approach;

  SlidingHistory now;
  now.profile = refined(moved(before.profile, approach, increment), kappa, approach);
  cut_to_limit(now.profile, kappa, approach);
  now.profile = without_straight_nodes(now.profile, straightness * scale);
  for (double tolerance = straightness * scale; now.profile.size() > most_nodes; tolerance *= 4)
    now.profile = without_straight_nodes(now.profile, tolerance);
  now.spring.resistance = resistance_of(now.profile, sliding_modulus, radius);
  now.spring.stiffness = 8 * sliding_modulus * a;
  now.spring.yields = now.spring.resistance.norm() >= limit * (1 - 1e3 * straightness);
  return now;
}

}  // namespace asperity

// Rigid motion of the particle's frame in that of the substrate: x = Q (X + u - C) + C + s, C the particle's
// centre.
//
// It strains nothing by itself. Q turns about y by `roll` through the particle's centre, then about the
// approach axis z by `spin`. A particle that rolls by a positive angle without sliding moves by radius * roll
// along x.
#pragma once

#include <array>
#include <cmath>

namespace asperity::fem {

struct RigidMotion {
  double x = 0, y = 0;  ///< shift [m]
  double spin = 0;      ///< about the approach axis [rad]
  double roll = 0;      ///< about the y axis [rad]
};

inline bool operator==(const RigidMotion& a, const RigidMotion& b) {
  return a.x == b.x && a.y == b.y && a.spin == b.spin && a.roll == b.roll;
}

/// The motion interpolated between two, at a fraction from the first to the second.
inline RigidMotion between(const RigidMotion& a, const RigidMotion& b, double fraction) {
  const auto mix = [&](double one, double other) { return one + fraction * (other - one); };
  return {mix(a.x, b.x), mix(a.y, b.y), mix(a.spin, b.spin), mix(a.roll, b.roll)};
}

/// Rows: axes of the substrate's frame seen in the particle's.
using Rotation = std::array<std::array<double, 3>, 3>;

/// Q of a motion: roll about y, then spin about z.
inline Rotation rotation(const RigidMotion& m) {
  const double c = std::cos(m.roll), s = std::sin(m.roll), cz = std::cos(m.spin), sz = std::sin(m.spin);
  return {{{cz * c, -sz, cz * s}, {sz * c, cz, sz * s}, {-s, 0, c}}};
}

/// Q (X - C) + C of a point X of the particle: where the turn alone takes it, C = (0, 0, radius).
/// point and radius [m].
inline std::array<double, 3> turned(const Rotation& q, const std::array<double, 3>& point, double radius) {
  std::array<double, 3> place{0, 0, radius};
  for (int c = 0; c < 3; ++c)
    place[c] += q[c][0] * point[0] + q[c][1] * point[1] + q[c][2] * (point[2] - radius);
  return place;
}

}  // namespace asperity::fem

// Two elastic half-spaces that stick together where they touch and are shifted or twisted along their plane:
// uniform shear tractions on each cell (Cerruti 1882; Johnson 1985, section 3.6), of both bodies together.
//
// With A the sum of (1 - nu)/G and B that of nu/G over both bodies, the shift along x by a traction q along x
// is the integral of q/(2 pi) (A/r + B x^2/r^3), along y that of q/(2 pi) B x y/r^3. What shear does to the
// gap, and pressure to the shift, is left out: it vanishes for alike bodies (Johnson 1985, section 5.4).
#pragma once

#include "half_space/convolution.h"

namespace asperity::half_space {

/// Shear compliances of both bodies together.
struct ShearCompliance {
  double across = 0;  ///< sum of (1 - nu)/G [1/Pa]
  double along = 0;   ///< sum of nu/G [1/Pa]
};

/// Of each cell, along x and along y.
struct Shears {
  Field x, y;
};

class StuckContact {
 public:
  /// Throws InputError for compliances that are not finite or not above 0 (along: not negative).
  StuckContact(const Grid& grid, const ShearCompliance& compliance);

  /// Lateral force along x over the shift of what touches, the cells with a pressure above 0 [N/m]. 0 where
  /// nothing touches.
  double lateral_stiffness(const Field& pressure) const;
  /// Moment over the angle of twist about the axis through the grid's middle [N m].
  double torsion_stiffness(const Field& pressure) const;

  /// Shift [m] of each cell by the tractions [Pa] of all.
  void apply(const Shears& traction, Shears& shift) const;
  const Grid& grid() const { return xx_.grid(); }

 private:
  Shears solve(const Field& pressure, const Shears& shift) const;

  Convolution xx_, yy_, xy_;
};

}  // namespace asperity::half_space

// Shape measures of hexahedra and tetrahedra. All are scale-free: 1 is best, 0 or less is inverted or flat.
#pragma once

#include <array>

#include "meshing/triangles/triangle_surface.h"

namespace asperity::meshing {

/// Smallest Jacobian determinant at the eight corners, each divided by the lengths of its three edges
/// (P. M. Knupp, Int. J. Numer. Meth. Engng 48, 2000, 1165). Corners in VTK order: bottom counter-clockwise
/// seen from above, then top. A box has 1.
/// A pure number [-].
double scaled_jacobian(const std::array<Point, 8>& hexahedron);

/// sqrt(2) J / largest product of the three edge lengths at a corner: 1 for the regular tetrahedron
/// (Verdict library, SAND2007-1751, Stimpson et al. 2007).
/// A pure number [-].
double scaled_jacobian(const std::array<Point, 4>& tetrahedron);

/// 3 r / R of the inscribed and circumscribed spheres, signed by orientation: 1 for the regular tetrahedron
/// (J. C. Cavendish et al., Int. J. Numer. Meth. Engng 21, 1985).
/// A pure number [-].
double radius_ratio(const std::array<Point, 4>& tetrahedron);

/// Smallest of the six angles between faces [rad]: acos(1/3) for the regular tetrahedron, pi at most.
double smallest_dihedral_angle(const std::array<Point, 4>& tetrahedron);

/// [m^3], positive if points 0, 1, 2 turn counter-clockwise seen from point 3 (VTK order).
double volume(const std::array<Point, 4>& tetrahedron);

}  // namespace asperity::meshing

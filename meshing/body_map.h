// The smooth shapes of the two bodies as logical boxes ("trees" of the octree forest) with analytic maps.
//
// Particle: a hemisphere, apex at the origin, its equator plane at z = R. Six trees: the cap below
// (projected, a square |x|, |y| <= cap R, so that its nodes are a Cartesian lattice in x and y), four sides
// up to the equator, a core. A full sphere has a second hemisphere, the mirror image of the first. An edge
// that trees share has the same direction in all of them: p4est takes that for granted when deal.II describes
// a coarse mesh to it (deal.II issue 16272); otherwise neighbours across such edges are missed, and meshes
// tear between ranks. Substrate: a cube [-L, L]^2 x [-2L, 0], one tree. The cap and the substrate's tree
// carry the interface.
#pragma once

#include <array>

#include "meshing/stretch.h"

namespace asperity::meshing {

using Point3 = std::array<double, 3>;

/// The two bodies, by their index in arrays.
enum class Body { particle = 0, substrate = 1 };

/// Trees in the order of the coarse mesh.
enum Tree { cap = 0, side_first = 1, core = 5, block = 6, upper_first = 7, upper_last = 12 };

/// Geometry that fixes both smooth bodies; lengths in m.
struct BodySizes {
  double radius = 0;             ///< of the particle [m]
  bool full_sphere = false;      ///< instead of a hemisphere
  double block_half_width = 0;   ///< L of the substrate's cube [m]
  double spacing_particle = 0;   ///< node spacing at the interface [m]
  double spacing_substrate = 0;  ///< the same of the substrate [m]
  double region_particle = 0;    ///< half width of the uniformly spaced square around the axis [m]
  double region_substrate = 0;   ///< the same of the substrate [m]
  /// In [m].
  double reach_particle =
      0;  ///< by which the particle's fine region is longer on both sides along x (rolling)
  /// In [m].
  double reach_substrate =
      0;  ///< by which the substrate's fine region is longer on both sides along x (sliding)
  double offset_substrate_x = 0, offset_substrate_y = 0;  ///< place of the substrate's centre [m]
};

class BodyMap {
 public:
  explicit BodyMap(const BodySizes& sizes);

  /// Position of a point of a tree, logical coordinates in [0, 1]^3.
  Point3 position(int tree, const Point3& logical) const;
  /// Depth below the contact surface [m] along the grading, 0 at the surface; only for the trees cap and
  /// block.
  double depth(int tree, const Point3& logical) const;
  /// Place along x and y [m] of a line of the surface's lattice, from the middle of its body's; only for the
  /// trees cap and block.
  std::array<double, 2> aside(int tree, const Point3& logical) const;
  /// Refinement level at which the spacing at the interface is the requested one.
  int finest_level(Body body) const { return body == Body::particle ? level_particle_ : level_substrate_; }
  const BodySizes& sizes() const { return sizes_; }

  int tree_count() const { return sizes_.full_sphere ? upper_last + 1 : block + 1; }
  static Body body_of(int tree) { return tree == block ? Body::substrate : Body::particle; }
  /// Logical z of a tree's contact surface: 0 for the cap, 1 for the block.
  /// A pure number [-].
  static double surface_coordinate(int tree) { return tree == block ? 1.0 : 0.0; }

  /// deal.II's number of a tree's face in the equator plane; -1 where the lower hemisphere's tree has none.
  static int equator_face(int tree);

  /// Half width of the cap's square, of the core's, and the core's height, as fractions of R.
  /// Each a fraction [-].
  static constexpr double cap_fraction = 0.45, core_fraction = 0.25, core_height_fraction = 0.25;

 private:
  Point3 cap_surface(double x, double y) const;
  Point3 in_side_tree(int quarter, const Point3& logical) const;

  BodySizes sizes_;
  int level_particle_ = 0, level_substrate_ = 0;
  Stretch cap_lateral_, cap_depth_, block_lateral_, block_depth_;
};

}  // namespace asperity::meshing

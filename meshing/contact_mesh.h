// The hexahedral meshes of both bodies as one p4est forest: graded towards the contact region, real rough
// geometry.
#pragma once

#include <deal.II/distributed/tria.h>

#include <functional>
#include <memory>

#include "meshing/body_map.h"
#include "meshing/fine_part.h"

namespace asperity::meshing {

/// Roughness height [m] at (x, y) [m] relative to the contact axis, growing out of the material.
using HeightFunction = std::function<double(double, double)>;

/// Sizes, grading and roughness of both meshes.
struct ContactMeshOptions {
  BodySizes sizes;
  double layers =
      4;  ///< a cell is no wider than its distance to the contact region divided by layers / 2 [-]
  HeightFunction particle_height, substrate_height;  ///< empty: smooth
  /// In [m].
  double largest_height_particle = 0,
         largest_height_substrate = 0;  ///< max |height|, sets how deep the roughness fades
  /// What of each body's fine region along x is meshed finely at present; by default all.
  std::array<FinePart, 2> fine;
  std::shared_ptr<const KeptCells> kept;  ///< null: none

  /// The same, no longer than the region's reach.
  FinePart fine_part(Body body) const;
};

/// Boundary indicators of the forest.
enum Boundary : unsigned {
  free_boundary = 0,
  driven_boundary = 1,
  fixed_boundary = 2,
  interface_particle = 3,
  interface_substrate = 4
};

/// Places points of the forest in space: smooth shape plus roughness that fades with depth and beyond the
/// region.
class RoughGeometry {
 public:
  explicit RoughGeometry(const ContactMeshOptions& options);
  /// Place [m] of a point of a tree, roughness included.
  Point3 position(int tree, const Point3& logical) const;
  const BodyMap& map() const { return map_; }
  /// Share of a cell's depth that lies in a film of this thickness [m] on its body's contact surface [-]. The
  /// film follows the roughness, which fades with depth.
  double film_share(const LogicalBox& box, double thickness) const;
  /// Depth [m] over which the roughness of a body fades to zero.
  double fade_depth(Body body) const { return body == Body::particle ? fade_particle_ : fade_substrate_; }

 private:
  double faded_height(Body body, double x, double y, double depth) const;
  BodyMap map_;
  HeightFunction particle_height_, substrate_height_;
  double fade_particle_, fade_substrate_;
};

using Triangulation = dealii::parallel::distributed::Triangulation<3>;

/// Forest in logical space (each tree a box; positions come from RoughGeometry), refined for `options`.
/// material_id of a cell is its Body. Cells of each body stop `coarsenings` levels
/// above its finest: such forests are nested, which makes them the levels of a multigrid method.
std::unique_ptr<Triangulation> make_forest(MPI_Comm communicator, const ContactMeshOptions& options,
                                           int coarsenings = 0);

/// The logical box of a cell.
LogicalBox logical_box(const dealii::Triangulation<3>& forest, const dealii::CellId& id);
template <typename Cell>
LogicalBox logical_box(const Cell& cell) {
  return logical_box(cell->get_triangulation(), cell->id());
}

}  // namespace asperity::meshing

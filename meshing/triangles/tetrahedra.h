// A tetrahedral mesh of a body bounded by triangles, for other programs (CGAL 3D mesh generation: Delaunay
// refinement, Jamin et al., ACM Trans. Math. Softw. 41, 2015). The surface is sampled anew with a size that
// grows away from the contact; sharp edges (rim of a hemisphere, edges of a block) are kept.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "meshing/triangles/triangle_surface.h"

namespace asperity::meshing {

/// Size(x) = min(coarse_size, fine_size + growth * distance from the fine region). The fine region is a flat
/// upright cylinder about the contact, as high as the surface within it is: both bodies of a contact face
/// each other along z.
struct TetrahedraOptions {
  Point contact{};         ///< centre of the finely meshed region [m]
  double fine_radius = 0;  ///< of that region [m]
  double fine_size = 0;    ///< circumradius of facets and tetrahedra there [m]
  double coarse_size = 0;  ///< largest circumradius [m]; 0: a twelfth of the body's smallest extent
  double growth = 0.3;     ///< of the size per distance from the fine region [-]
  /// Largest distance of a facet's circumcentre from the surface it stands for, over the local size [-]: how
  /// closely roughness is followed.
  double distance_per_size = 0.05;
  double feature_angle = M_PI / 3;       ///< between normals of triangles at an edge that is kept sharp [rad]
  double facet_angle = M_PI * 25 / 180;  ///< smallest angle of a facet [rad]; more than 30 deg may not end
  double radius_edge_ratio = 2;    ///< largest circumradius over shortest edge [-]; less than 2 may not end
  double volume_tolerance = 0.01;  ///< allowed |V / V_surface - 1|
};

/// Points and tetrahedra.
struct TetrahedralMesh {
  std::vector<Point> points;                             ///< [m]
  std::vector<std::array<std::uint32_t, 4>> tetrahedra;  ///< positive volume, VTK order
  std::vector<TriangleIndices> boundary;                 ///< outward
  std::vector<int> patch;  ///< of each boundary triangle: sharp edges part the surface into patches 1, 2, ...

  TriangleSurface surface() const;                              ///< its boundary
  std::array<Point, 4> corners(std::size_t tetrahedron) const;  ///< points of one tetrahedron
};

/// Volume and shapes of a mesh.
struct TetrahedraQuality {
  double volume = 0;                    ///< [m^3]
  double smallest_dihedral_angle = 0;   ///< [rad]
  double smallest_radius_ratio = 0;     ///< [-]
  double smallest_scaled_jacobian = 0;  ///< [-]
  double mean_radius_ratio = 0;         ///< [-]
};

/// Throws InputError if the surface does not bound a body or an option is out of range, and WorkError if the
/// mesh's volume misses the tolerance. The same input gives the same mesh.
TetrahedralMesh tetrahedra(const TriangleSurface& surface, const TetrahedraOptions& options);

/// Over all of a mesh's tetrahedra.
TetrahedraQuality quality(const TetrahedralMesh& mesh);

}  // namespace asperity::meshing

// The boundary of one body's hexahedra as triangles, for what works on surfaces: CGAL's checks, export, gap
// queries.
#pragma once

#include "fem/levels/mesh_level.h"
#include "meshing/triangles/triangle_surface.h"

namespace asperity::fem {

/// Closed and outward, hanging nodes included; of the cells this rank owns. `positions`:
/// MeshLevel::node_positions.
meshing::TriangleSurface boundary_surface(const MeshLevel& level, const Vector<double>& positions,
                                          meshing::Body body);

}  // namespace asperity::fem

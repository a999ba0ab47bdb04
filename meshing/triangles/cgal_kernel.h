// CGAL's types for meshing/triangles (internal: include from .cc files only). CGAL works in nm here: with
// metres, squared and cubed lengths come near where its filters and absolute guards misjudge.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "meshing/triangles/triangle_surface.h"

namespace asperity::meshing {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr double metre_in_nm = 1e9;

/// Points in m as CGAL's in nm, and back.
inline Kernel::Point_3 to_nm(const Point& point) {
  return {point[0] * metre_in_nm, point[1] * metre_in_nm, point[2] * metre_in_nm};
}
/// From CGAL's nm to m.
inline Point from_nm(const Kernel::Point_3& point) {
  return {point.x() / metre_in_nm, point.y() / metre_in_nm, point.z() / metre_in_nm};
}

}  // namespace asperity::meshing

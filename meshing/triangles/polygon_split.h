// From quads, with hanging nodes where the mesh is locally refined, to triangles (internal).
#pragma once

#include <vector>

#include "meshing/triangles/triangle_surface.h"

namespace asperity::meshing {

/// The quads with every hanging node inserted into the edge it hangs on.
std::vector<std::vector<std::uint32_t>> polygons_with_hanging_nodes(const std::vector<Point>& points,
                                                                    const std::vector<QuadIndices>& quads);

/// Appends the triangulation of a polygon whose worst triangle is best, by dynamic programming over its
/// sub-polygons (G. T. Klincsek, Ann. Discrete Math. 9, 1980). The measure of a triangle is
/// 4 sqrt(3) A / (sum of squared edges), with A signed by the polygon's mean normal: 1 if equilateral.
void split_polygon(const std::vector<Point>& points, const std::vector<std::uint32_t>& polygon,
                   std::vector<TriangleIndices>& triangles);

}  // namespace asperity::meshing

// What `asperity mesh` hands to other programs and prints about it.
#pragma once

#include <filesystem>
#include <string>

#include "meshing/triangles/length_unit.h"
#include "meshing/triangles/surface_check.h"
#include "meshing/triangles/tetrahedra.h"
#include "meshing/triangles/triangle_surface.h"

namespace asperity::meshing {

/// By the path's extension: .stl, .ply or .off. Throws InputError for another one.
void write_surface(const TriangleSurface& surface, const std::filesystem::path& path,
                   LengthUnit unit = LengthUnit::micrometre);

/// By the path's extension: .vtu or .msh. Throws InputError for another one.
void write_tetrahedra(const TetrahedralMesh& mesh, const std::filesystem::path& path,
                      LengthUnit unit = LengthUnit::micrometre);

/// Lines for people, each ended by a newline: counts, area, volume, and whether it bounds a body.
std::string summary(const std::string& name, const TriangleSurface& surface, const SurfaceCheck& check);

/// Counts, volume against the surface's [m^3], and the worst elements.
std::string summary(const std::string& name, const TetrahedralMesh& mesh, const TetrahedraQuality& quality,
                    double surface_volume);

}  // namespace asperity::meshing

// Tetrahedral meshes for other programs: VTU (VTK XML, unstructured grid) and Gmsh's MSH 2.2 text.
// Coordinates are written in `unit`, which a comment in the file names. Files are whole or absent.
#pragma once

#include <filesystem>

#include "meshing/triangles/length_unit.h"
#include "meshing/triangles/tetrahedra.h"

namespace asperity::meshing {

/// The tetrahedra with their radius ratio as a cell field; inline base64 arrays.
void write_vtu(const TetrahedralMesh& mesh, const std::filesystem::path& path,
               LengthUnit unit = LengthUnit::micrometre);

/// The tetrahedra as physical volume "body" and the boundary triangles as physical surfaces "patch_1",
/// "patch_2", ...
void write_msh(const TetrahedralMesh& mesh, const std::filesystem::path& path,
               LengthUnit unit = LengthUnit::micrometre);

}  // namespace asperity::meshing

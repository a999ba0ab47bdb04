// Triangle surfaces for other programs: binary STL, binary PLY, OFF. Coordinates are written in `unit`, which
// the file names in its header: STL's 80 bytes, PLY's "comment", OFF's "#". Files are whole or absent.
#pragma once

#include <filesystem>

#include "meshing/triangles/length_unit.h"
#include "meshing/triangles/triangle_surface.h"

namespace asperity::meshing {

/// Single precision and no shared points, as the format has it: 24 bits, 5e-4 nm in a body of 8.5 um.
void write_stl(const TriangleSurface& surface, const std::filesystem::path& path,
               LengthUnit unit = LengthUnit::micrometre);

/// Double precision, little endian.
void write_ply(const TriangleSurface& surface, const std::filesystem::path& path,
               LengthUnit unit = LengthUnit::micrometre);

/// Text with as many digits as double precision holds.
void write_off(const TriangleSurface& surface, const std::filesystem::path& path,
               LengthUnit unit = LengthUnit::micrometre);

}  // namespace asperity::meshing

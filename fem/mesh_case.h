// Writes the meshes of a case for people and other programs, and says what they are worth.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/case.h"

namespace asperity {

/// Hexahedral meshes (VTU), both surfaces as triangles (STL, PLY, OFF) and a tetrahedral mesh of each body
/// (VTU, MSH); prints counts, quality, the fidelity of the roughness and the memory a solution needs. Throws
/// InputError where the mesh does not reach its quality.
void mesh_case(const CaseInput& input, const std::filesystem::path& output,
               const std::function<void(const std::string&)>& say);

}  // namespace asperity

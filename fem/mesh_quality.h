// What a mesh of both bodies is worth before anything is solved on it: shape of its hexahedra, and how closely the nodes
// of its interfaces follow the topographies.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "fem/solver/mesh_level.h"

namespace asperity::fem {

/// Heights are over the smooth shape, within the contact region of a body.
struct RoughnessFidelity {
  double sq_topography = 0;  ///< Sq of the topography, sampled finer than the mesh [m]
  double sq_nodes = 0;       ///< Sq of the interface nodes' heights [m]
  double sq_deviation = 0;   ///< rms of node height minus topography at the nodes [m]
  double sq_between = 0;     ///< rms of bilinear facets minus topography, nodes and what lies between them [m]

  bool smooth() const { return sq_topography == 0; }
  double sq_ratio() const { return smooth() ? 1 : sq_nodes / sq_topography; }
};

struct HexMeshQuality {
  std::array<double, 2> smallest_scaled_jacobian{1, 1};  ///< particle, substrate [-]; 1: a box, 0: flat or inverted
  std::array<RoughnessFidelity, 2> roughness;            ///< particle, substrate
};

/// Limits of a mesh that is solved on: scaled Jacobian above the first, Sq and nodes within the second of the topography.
constexpr double smallest_allowed_scaled_jacobian = 0.2, allowed_roughness_error = 0.01;

/// Of each cell this rank owns, in the order of the level's batches.
std::vector<double> scaled_jacobians(const MeshLevel& level, const Vector<double>& positions);

/// The same on every rank. `positions`: of the level's nodes, with ghosts (MeshLevel::node_positions).
HexMeshQuality hex_mesh_quality(const MeshLevel& level, const Vector<double>& positions, const meshing::ContactMeshOptions& options);

/// Throws InputError with reason and remedy where the mesh does not reach the limits; `file` starts the message.
void require_quality(const HexMeshQuality& quality, const meshing::ContactMeshOptions& options, const std::string& file);

}  // namespace asperity::fem

// Quality of the mesh of both bodies before a solution: shape of its hexahedra, and how closely its
// interfaces follow the topographies.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "fem/levels/mesh_level.h"

namespace asperity::fem {

/// Heights are over the smooth shape, within the contact region of a body.
struct RoughnessFidelity {
  double sq_topography = 0;  ///< Sq of the topography, sampled finer than the mesh [m]
  double sq_nodes = 0;       ///< Sq of the interface nodes' heights [m]
  double sq_deviation = 0;   ///< rms of node height minus topography at the nodes [m]
  double sq_between = 0;    ///< rms of bilinear facets minus topography, nodes and what lies between them [m]
  double rms_slope = 0;     ///< of the topography, <|grad h|^2>^(1/2) [-]
  double missed_slope = 0;  ///< rms of the topography's slope minus that of the facets [-]

  /// Shares of Sq and of the slope variance that facets do not represent [-].
  double missed_height_share() const { return smooth() ? 0 : sq_between / sq_topography; }
  double missed_slope_share() const {
    return rms_slope > 0 ? missed_slope * missed_slope / (rms_slope * rms_slope) : 0;
  }

  bool smooth() const { return sq_topography == 0; }
  /// Sq of the nodes over that of the topography [-]; 1 where smooth.
  double sq_ratio() const { return smooth() ? 1 : sq_nodes / sq_topography; }
};

/// Shapes of the cells of both bodies.
struct HexMeshQuality {
  std::array<double, 2> smallest_scaled_jacobian{
      1, 1};  ///< particle, substrate [-]; 1: a box, 0: flat or inverted
  std::array<double, 2> without_roughness{
      1, 1};  ///< the same of the smooth bodies, known where the first is too small
  std::array<RoughnessFidelity, 2> roughness;  ///< particle, substrate
};

/// Limits of a mesh that is solved on: scaled Jacobian above the first, Sq and nodes within the second of the
/// topography.
constexpr double smallest_allowed_scaled_jacobian = 0.2, allowed_roughness_error = 0.01;
/// Most that facets may leave out of Sq and of the slope variance: some two cells over the shortest wave of a
/// self-affine surface, where the largest pressure reads 25 to 60 % too small. (Four cells miss some 5 %.)
/// From the smaller share on it is said.
constexpr double allowed_missed_height = 0.25, allowed_missed_slopes = 0.25, worth_saying_of_slopes = 0.06;

/// Of each cell this rank owns, in the order of the level's batches.
std::vector<double> scaled_jacobians(const MeshLevel& level, const Vector<double>& positions);

/// The same on every rank. `positions`: of the level's nodes, with ghosts (MeshLevel::node_positions).
HexMeshQuality hex_mesh_quality(const MeshLevel& level, const Vector<double>& positions,
                                const meshing::ContactMeshOptions& options);

/// Throws InputError with reason and remedy where the mesh does not reach the limits; `file` starts the
/// message.
void require_quality(const HexMeshQuality& quality, const meshing::ContactMeshOptions& options,
                     const std::string& file);

/// One line on the roughness that a body's facets do not represent, where it is significant; else empty.
std::string missed_roughness_text(const RoughnessFidelity& roughness, const std::string& body);

}  // namespace asperity::fem

// Dual mortar coupling of two non-matching interfaces: the weighted gap at each node of the particle's
// surface.
//
// The interfaces are compared along the approach direction z (small slopes; the error is of order slope^2).
// With the dual basis psi (Wohlmuth 2000: integral of psi_a N_b = delta_ab D_a; made face by face, so that it
// holds under the quadrature that is used, on turned and distorted faces too) the gap at node a of the
// particle's side is
//   g_a = z_a - sum_b (M_ab / D_a) z_b,   M_ab = integral of psi_a N_b over the overlap,
// and a pressure p_a there loads both sides with p_a D_a G_a. Forces and moments balance exactly because the
// weights reproduce linear functions; a uniform pressure passes the patch test on any pair of meshes. When
// the particle slides by s the weights change: dg_a/ds = - (1/D_a) sum_b z_b integral of psi_a grad N_b,
// minus the mean slope of the substrate. To first order in slopes the pressure then also acts along x and y,
// by that much.
#pragma once

#include <array>
#include <vector>

namespace asperity::fem {

/// A rectangle of an interface mesh in the plane of the contact; nodes lexicographic.
struct PlaneFace {
  double x0, x1, y0, y1;  ///< [m]
  std::array<int, 4> node;
};

/// A face of the particle's interface as seen along z: a convex quadrilateral with bilinear coordinates;
/// corners lexicographic.
struct PlaneQuad {
  std::array<std::array<double, 2>, 4> corner;  ///< [m]
  std::array<int, 4> node;
};
std::vector<PlaneQuad> quads(const std::vector<PlaneFace>& faces);

/// One row of the gap operator: its node, area and normal.
struct GapRow {
  int node = -1;                                ///< interface node of the particle's side
  double area = 0;                              ///< D_a [m^2]
  std::vector<std::pair<int, double>> entries;  ///< interface node, weight; the node itself has weight 1
  /// Nodes of the substrate with the weights that make the mean slope of its surface of their heights [1/m].
  std::vector<std::pair<int, std::array<double, 2>>> slope_entries;
  std::array<double, 2>
      slope{};  ///< change of the gap by a shift of the particle along x and y; 0: pressure acts along z
};

/// Rows for all nodes of `particle` faces, with their slope_entries or without. Throws WorkError where the
/// substrate's faces do not cover the particle's.
std::vector<GapRow> couple_interfaces(const std::vector<PlaneQuad>& particle,
                                      const std::vector<PlaneFace>& substrate, bool with_slopes = true);

}  // namespace asperity::fem

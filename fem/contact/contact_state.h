// A state of the contact and what is read from it.
#pragma once

#include <array>
#include <vector>

#include "fem/solver/mesh_level.h"

namespace asperity::fem {

/// Rigid motion of the particle's frame in the plane of contact. It strains nothing by itself: each body is meshed in a frame
/// of its own, and the interface sees the frames' relative motion plus the displacements in them.
struct RigidMotion {
  double x = 0, y = 0;  ///< shift [m]
  double spin = 0;      ///< about the approach axis [rad], small
};

/// One state of the contact; the bodies' history lives in ContactSystem::bodies().
struct ContactState {
  Vector<double> displacement;
  std::vector<double> multiplier;  ///< lambda of each row [Pa], also the pressure of an accepted state
  std::array<std::vector<double>, 2> shear;  ///< shear traction on the particle of each row along x and y [Pa]
  double approach = 0;             ///< displacement of the driven plane towards the substrate [m], from first touch
  RigidMotion motion;
};

struct SolveReport {
  int newton = 0, updates = 0, linear = 0;  ///< iterations
  double residual = 0, penetration = 0;     ///< reached, relative
  double friction_work = 0;                 ///< dissipated by slip in this step [J]
  bool converged = false;
};

/// Resultants of an equilibrium.
struct ContactResultants {
  double force = 0;           ///< from tractions [N]
  std::array<double, 2> lateral_force{};  ///< that moves the particle, against the shear tractions [N]
  double torsion_moment = 0;  ///< that turns the particle about the approach axis [N m]
  double reaction_driven = 0; ///< from reactions of the driven plane [N]
  double reaction_fixed = 0;  ///< from reactions of the fixed plane [N]
  std::array<double, 2> lateral_reaction{};  ///< of the fixed plane [N]
  double moment_error = 0;    ///< |moment of tractions about the axes - moment of the same forces on the substrate| / (force spacing)
  double area = 0;            ///< real contact area [m^2]
  double largest_pressure = 0;
  int active = 0, sticking = 0;  ///< rows in contact, and those of them that stick
  bool reaches_rim = false;
};

}  // namespace asperity::fem

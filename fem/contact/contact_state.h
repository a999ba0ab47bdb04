// A state of the contact and what is read from it.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "fem/levels/mesh_level.h"
#include "fem/mortar/coupling.h"

namespace asperity::fem {

/// What a state of the contact is beside its displacement; each member also stands in
/// fem/output/checkpoint.cc.
struct InterfaceState {
  std::vector<double> multiplier;  ///< lambda of each row [Pa], also the pressure of an accepted state
  std::array<std::vector<double>, 2>
      shear;  ///< shear traction on the particle of each row along x and y [Pa]
  /// Of each row, one after the other: slip path [m], shear limit [Pa] and the internal
  /// variables of the friction law; empty: no friction.
  std::vector<double> friction_history;
  double time = 0;           ///< see InterfacePoint
  std::vector<char> bonded;  ///< rows that were in contact and have not left the range of attraction since;
                             ///< empty: no adhesion
  double approach = 0;       ///< displacement of the driven plane towards the substrate [m], from first touch
  RigidMotion motion;
  Coupling coupling;  ///< of the interfaces
};

/// One state of the contact; the bodies' history lives in ContactSystem::bodies().
struct ContactState : InterfaceState {
  Vector<double> displacement;

  /// Becomes the other, which is not to be used any more.
  void take(ContactState& other) {
    displacement.swap(other.displacement);
    static_cast<InterfaceState&>(*this) = std::move(static_cast<InterfaceState&>(other));
  }
};

/// What a solve took, and how well it ended.
struct SolveReport {
  int newton = 0, updates = 0, linear = 0;  ///< iterations
  double residual = 0, penetration = 0;     ///< reached, relative
  double friction_work = 0;                 ///< dissipated by slip in this step [J]
  double adhesion_energy = 0;               ///< potential energy of attraction, negative [J]
  double adhesion_loss = 0;                 ///< dissipated as bonds formed and broke in this step [J]
  int restarts = 0;  ///< times that the quick iteration failed and the cautious one began anew
  bool converged = false;
};

/// Resultants of an equilibrium.
struct ContactResultants {
  double force = 0;                       ///< from tractions [N]
  double attraction = 0;                  ///< part of it that attracts [N]
  std::array<double, 2> lateral_force{};  ///< that moves the particle, against the shear tractions [N]
  double torsion_moment = 0;              ///< that turns the particle about the approach axis [N m]
  double rolling_moment = 0;   ///< that turns it about its rolling axis, y turned by the spin, through the
                               ///< lowest point of its smooth shape [N m]
  double reaction_driven = 0;  ///< from reactions of the driven plane [N]
  double reaction_fixed = 0;   ///< from reactions of the fixed plane [N]
  std::array<double, 2> lateral_reaction{};  ///< of the fixed plane [N]
  double moment_error = 0;         ///< |moment of tractions about the axes - moment of the same forces on the
                                   ///< substrate| / (force, radius of the area) [-]
  double area = 0;                 ///< real contact area [m^2]
  double perimeter = 0;            ///< of its edge [m]
  int spots = 0;                   ///< contacts apart from each other
  std::array<double, 2> centre{};  ///< of the contact pressure, in the substrate's frame [m]
  double pressure_radius = 0;      ///< of the Hertzian pressure with the same second moment [m]
  double largest_pressure = 0;     ///< of a row [Pa]
  int active = 0, sticking = 0;    ///< rows in contact, and those of them that stick
  bool reaches_rim = false;
};

}  // namespace asperity::fem

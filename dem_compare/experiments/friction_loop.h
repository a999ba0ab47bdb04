// What an experiment with one particle gives: the history of the indenter's and the particle's motion with
// all contact forces, and the numbers that are read off a friction loop. SI units. Axes: x along the motion
// of the indenter, z up, y across.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "dem_compare/motion/contact_model.h"

namespace asperity {

/// One contact at one step.
struct ContactRecord {
  double approach = 0, normal_force = 0;              ///< [m], [N]
  Eigen::Vector3d lateral = Eigen::Vector3d::Zero();  ///< force on the particle in the contact plane [N]
  Eigen::Vector3d rolling_moment = Eigen::Vector3d::Zero();  ///< on the particle [N m]
  double torsion_moment = 0;                           ///< on the particle, about the contact's normal [N m]
  bool slides = false, rolls = false, twists = false;  ///< the mode's limit is reached
};

/// One step of the loop.
struct LoopRow {
  int leg = 0;                                             ///< between two reversals; 0: the first way out
  double indenter_displacement = 0;                        ///< [m]
  double lateral_force = 0;                                ///< of the indenter on the particle along x [N]
  double normal_force = 0;                                 ///< that the indenter carries [N]
  Eigen::Vector3d displacement = Eigen::Vector3d::Zero();  ///< of the particle's centre [m]
  Eigen::Vector3d rotation = Eigen::Vector3d::Zero();  ///< of the particle: axis times angle, up to pi [rad]
  std::vector<ContactRecord> contacts;
};

struct FrictionLoop {
  std::vector<std::string> contact_names;  ///< "substrate", "indenter", ...
  std::vector<LoopRow> rows;               ///< starts with the state at rest under load
  double speed = 0;                        ///< of the indenter in a dynamic run [m/s]; 0: quasi-static
};

/// Numbers of a loop with at least one reversal. Throws InputError for one without.
struct LoopNumbers {
  double initial_slope = 0;   ///< d(lateral force)/dx at the first motion [N/m]
  double reversal_slope = 0;  ///< the same after the last reversal
  double plateau = 0;         ///< half the difference of the forces at the ends of the last two legs [N]
  double offset = 0;          ///< their mean [N]
  double reversal_travel =
      0;                      ///< 2 plateau/reversal slope: way of an elastic contact to the next plateau [m]
  double plateau_travel = 0;  ///< way after the last reversal until 99.9 % of the change of force is done [m]
  double dissipation = 0;     ///< work of the last full cycle [J]; NaN without a full cycle
};
LoopNumbers measure(const FrictionLoop& loop);

/// One row per accepted step, per-contact columns named after the contact.
std::string to_csv(const FrictionLoop& loop);

/// What the loop keeps of a contact's state.
ContactRecord record_of(const ContactModelState& state);

}  // namespace asperity

// The path of an experiment through loads and positions, in stations that are solved one after the other.
#pragma once

#include <vector>

#include "core/case.h"
#include "fem/contact/contact_state.h"

namespace asperity::fem {

/// One place of the path.
struct Station {
  double load = 0;     ///< fraction of the largest load (force control) or approach (displacement control)
  RigidMotion motion;  ///< of the particle's frame
  bool rolls_freely = false;  ///< the shift relieves lateral force
  double duration = 1;        ///< from the station before to this one [s]
};

/// Lengths and angles that the steps of a motion follow from.
struct MotionScales {
  double full_slip_shift = 0;  ///< at which a smooth contact slips as a whole [m]; 0: frictionless
  double full_slip_angle = 0;  ///< nearly the same of torsion [rad]
  double largest_shift = 0;    ///< of one step [m]
  double largest_roll = 0;     ///< path rolled in one step [m]
  double largest_angle = 0;    ///< of one step [rad]
  double rolling_radius = 0;   ///< of the particle [m]
  double contact_radius = 0;   ///< of the smooth contact, whose rim has the speed of torsion [m]
};

/// Loading and unloading advance evenly in the approach of a Hertzian contact; the motion lies between them,
/// at the largest load. A particle that rolls does so half of its path on either side of the axis of the
/// meshes. The last unloading step keeps a thousandth of the load: without any contact nothing holds the
/// particle. To retract is to go on evenly beyond first touch. Steps last as long as the experiment's times
/// and speed say, and a second where it has none.
std::vector<Station> make_program(const ExperimentInput& experiment, const MotionScales& scales);

/// Positions from 0 to `length`, without 0: steps grow from a tenth of `onset` to `largest`.
/// In the unit of `length`.
std::vector<double> graded_path(double length, double onset, double largest);

}  // namespace asperity::fem

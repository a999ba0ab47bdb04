// One contact of a particle: a law for each mode of motion, and what they exert together. Pure: advance()
// maps the state that was accepted last and a motion to the next state; nothing is remembered elsewhere. The
// modes do not know of each other but through the normal force and the contact radius (torsion takes nothing
// from sliding: sliding_with_spin.h is left out). Nor does rolling renew the contact: a lateral force stays
// in its spring, where a real one gives way over some 2 a (creep_force.h). Signs: every law gives a
// resistance in the direction of its displacement, and the particle feels it against that direction,
//   f = f_n n - q,   M = (-r n) x (-q) - M_ro - M_to n    (moment about the particle's centre). SI units.
#pragma once

#include "dem_compare/laws/hertz_offset.h"
#include "dem_compare/laws/mindlin.h"
#include "dem_compare/laws/rolling_resistance.h"
#include "dem_compare/laws/torsion_resistance.h"
#include "dem_compare/laws/viscous.h"
#include "dem_compare/motion/contact_motion.h"
#include "dem_compare/motion/relative_velocity.h"

namespace asperity {

struct ContactModel {
  NormalLaw normal = HertzOffset{};
  SlidingLaw sliding = Mindlin{};
  RollingLaw rolling = RollingResistance{};  ///< none by default
  TorsionLaw torsion = TorsionResistance{};  ///< none by default
  ViscousLaw damping = ViscousDamping{};     ///< acts in dynamic runs only; none by default
  LeverArm lever = LeverArm::distance_to_contact;
  HistorySpin history_spin = HistorySpin::mean_of_bodies;
};

/// History and resistances of all modes.
struct ContactModelState {
  NormalState normal;
  SlidingHistory sliding;
  RollingHistory rolling;
  TorsionHistory torsion;
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< n, from the contact to the particle
  double lever = 0;                                      ///< [m]
  Eigen::Vector3d lateral = Eigen::Vector3d::Zero();     ///< -q, the lateral force on the particle [N]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();       ///< on the particle [N]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();      ///< on the particle, about its centre [N m]
};

/// Without rates: quasi-static.
ContactModelState advance(const ContactModel& model, const ContactModelState& before,
                          const ContactMotion& motion);
/// With the viscous parts for the relative velocity of a particle of this mass [kg].
ContactModelState advance(const ContactModel& model, const ContactModelState& before,
                          const ContactMotion& motion, const RelativeVelocity& rate, double mass);

}  // namespace asperity

// One particle moved as in the paper's experiments, as an engine is asked to do it, and what the law of
// parameters.json says about it in closed form. Mindlin springs k_l, springs of rolling and torsion K, yield
// limits; quasi-static; SI units.
#pragma once

#include <string>
#include <vector>

#include "core/motion.h"
#include "engines/parameters/contact_parameters.h"

namespace asperity {

/// What is moved how far, under which load.
struct EngineExperiment {
  /// sliding: the sphere is glued to the indenter, load control; rolling: free between substrate and moving
  /// plate; rail: free in a V-rail under a moving plate; torsion: spun about the normal.
  Motion type = Motion::sliding;
  ContactParameters substrate;
  ContactParameters indenter;  ///< of rolling and rail
  double load = 1e-4;          ///< normal load on the substrate, in a rail on each of its slopes [N]
  double amplitude = 1e-6;     ///< of the loop of glued and rolling; way of the plate in a rail [m]
  double rail_angle = 0;       ///< inclination of the slopes [rad]
  double haste = 1;            ///< factor on the speeds that the plan would choose

  /// Of the slopes' inclination [-].
  double rail_cosine() const;
  double indenter_load() const;  ///< 2 cos(theta) f in a rail (force balance), f elsewhere [N]
  double mass() const { return substrate.particle_mass(); }  ///< [kg]
};

/// "glued", ...; throws InputError naming what was meant.
Motion engine_experiment_type(const std::string& name);
std::string engine_experiment_name(Motion type);

/// What the law says.
struct ClosedForm {
  double slope = 0;  ///< of response over drive, from rest and after each reversal [N/m], twisting: [N m/rad]
  double first_yield = 0;  ///< drive at which the first limit is reached [m], twisting: [rad]
  double full_yield = 0;   ///< drive at which the last limit is reached
  double plateau = 0;      ///< response when all limits are reached [N], twisting: [N m]
  double approach = 0;     ///< at the substrate [m]
  double rotation = 0;     ///< rolling angle per drive beyond yield [rad/m]
  double rolling_stiffness =
      0;  ///< K of substrate and plate together [N m/rad]; of a rail what resists the rotation
};
ClosedForm closed_form(const EngineExperiment& experiment);

/// A stretch of constant speed.
struct Leg {
  enum class Purpose { settle, start, travel, before_reversal, reversal } purpose = Purpose::settle;
  double distance = 0;  ///< of the drive, with its sign [m or rad]
  long steps = 0;
  long every = 1;  ///< steps between rows of the trace
};

/// The legs of an experiment, and the time integration that suits its contacts.
struct MotionPlan {
  double time_step = 0;  ///< a thirtieth of the shortest period of the sphere on its contacts [s]
  double damping = 0;    ///< rate of a half-critically damped normal spring: dashpot over (mass) [1/s]
  std::vector<Leg> legs;

  /// Signed speed of a leg [m/s or rad/s].
  double speed(const Leg& leg) const { return leg.distance / (static_cast<double>(leg.steps) * time_step); }
};
/// Slow where stiffness is measured, so that inertia stays below half a percent; faster between. All laws are
/// rate-independent.
/// Throws InputError for a load or haste not above zero and an amplitude that reaches not all limits.
MotionPlan plan_motion(const EngineExperiment& experiment);

}  // namespace asperity

// One concealed friction loop of a sphere under one load, driven in small steps between samples.
#pragma once

#include <vector>

#include "diagnosis/conceal/masing_contact.h"
#include "diagnosis/conceal/world.h"

namespace asperity::hidden {

/// What the concealed experiment does: loads and speeds, and the strokes under each.
struct SlidingProgram {
  std::vector<double> loads;     ///< [N]
  std::vector<double> speeds;    ///< of each load's runs [m/s]
  double amplitude = 250e-9;     ///< [m]
  int cycles = 2, samples = 60;  ///< of one direction
  bool steps_speed = false;      ///< one long stroke with steps of speed
};

/// One run at one load. The world and the program must outlive it.
class SlidingRun {
 public:
  /// At rest under `load` [N], with `friction` its coefficient [-]; `seed` of the events of stick-slip.
  SlidingRun(const World& world, const SlidingProgram& program, double friction, double load,
             bool with_effects, unsigned seed);

  /// Of the contact, by Hertz [m].
  double contact_radius() const { return radius_; }

  /// Moves on to a position [m], reached at a time [s] with a speed [m/s], in a cycle counted from 0; the
  /// lateral force [N] recorded there.
  double force_at(double position, double time, double speed, double cycle);

 private:
  bool has(const char* id) const { return with_effects_ && world_.hides(id); }
  double of(const char* id, const char* parameter) const {
    return with_effects_ ? world_.value(id, parameter) : 0;
  }
  void next_event();
  /// dtheta/dt = -(v theta/L) ln(v theta/L)
  void advance_state(double speed, double dt);
  double limit(double position, double speed, double cycle, double slipped) const;
  double recorded(double time) const;

  const World& world_;
  const SlidingProgram& program_;
  bool with_effects_;
  double friction_, load_, radius_ = 0, stiffness_ = 0;
  Random events_;
  MasingContact masing_;
  double force_ = 0, position_ = 0, time_ = 0, slip_ = 0, theta_ = 0;
  double period_ = 0, drop_ = 0, sawtooth_ = 0;  ///< of stick-slip
  int direction_ = 1;
};

}  // namespace asperity::hidden

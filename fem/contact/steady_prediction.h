// First guess of a step of a motion or a load that goes on: what the last step changed, once more.
//
// Linear extrapolation of displacement, pressure and shear along the path of the particle, or over the load
// or the approach, each per node in its body's own frame. It is a start of the iteration and no more:
// history, slip and work are counted from the accepted state. Source: Bathe (1996), Finite Element
// Procedures, ch. 8.4 (a solution starts from what is known of the path).
#pragma once

#include <limits>

#include "fem/contact/contact_state.h"

namespace asperity::fem {

/// What a prediction needs of the state before the last step, for a checkpoint. Lists are empty where that
/// step does not lead to the accepted state.
struct PathMemory {
  double target = 0;  ///< of the last step [N] or [m]
  /// Of the one before [N] or [m]; NaN: there was none.
  double target_before = std::numeric_limits<double>::quiet_NaN();
  RigidMotion motion;
  std::vector<double> displacement;          ///< locally owned [m]
  std::vector<double> multiplier;            ///< [Pa]
  std::array<std::vector<double>, 2> shear;  ///< [Pa]
};

class SteadyPrediction {
 public:
  /// reach: of the contact region about the axis of spin; radius: of the particle [m].
  SteadyPrediction(double radius, double reach) : radius_(radius), reach_(reach) {}

  /// To be called with each step that was solved: both its states, and its target ([N] or [m]).
  void remember(ContactState& before, const ContactState& after, double target);

  /// What is remembered of the way to `accepted`.
  PathMemory memory(const ContactState& accepted) const;
  /// Remembers what memory() said, at the same accepted state.
  void restore(const PathMemory& memory, const ContactState& accepted);

  /// By how much of the last step `accepted` is to move on to `motion` at the same target, or to another
  /// target without motion; 0 where the last step has not led there, turned back or to another direction, or
  /// was not of the same kind, or where nothing is pressed [-].
  double share_of_last_step(const ContactState& accepted, const RigidMotion& motion, double target) const;

  /// Moves displacement and multipliers of `state` on, pressures not below zero. share: as above [-].
  void move_on(ContactState& state, double share);

 private:
  double radius_, reach_;
  ContactState before_;
  std::vector<double> reached_;  ///< pressures after the last step [Pa]; empty: none is remembered
  RigidMotion motion_;           ///< after the last step
  double target_ = std::numeric_limits<double>::quiet_NaN(), target_before_ = target_;
};

}  // namespace asperity::fem

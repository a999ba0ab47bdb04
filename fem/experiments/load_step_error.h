// What finite load steps leave in the approach of bodies that yield.
//
// Radial return flows in the direction n at the end of a step. Along the path it turns from n0, where yielding sets in, so the increment
// of plastic strain is off by e = |de_p| (n - n0) / 2. By reciprocity that eigenstrain moves the approach by the integral of S : e, with S
// the change of stress per unit of load of the bodies as they yield: the change in the step over its change of force (Betti's theorem with
// the tangent operator, which is symmetric in associated flow; Simo & Hughes 1998, box 3.2). For perfect plasticity this is half of
// d(sigma) : d(e_p), which Drucker's postulate makes zero along the path, positive in a step: the approach comes out too large. It adds
// up over the steps and falls with their number.
//
// A step whose share of that is larger than asked is divided: n parts leave an n-th.
#pragma once

#include <algorithm>
#include <cmath>

namespace asperity::fem {

/// Sums the error over the steps of one record, each as wide as it was.
class LoadStepError {
 public:
  /// Of the stated error itself, relative: it is of first order and holds within a factor two (tests/fem/plastic_contact_test.cc).
  static constexpr double doubt = 0.5;
  /// flow_turn: BodyEnergies of an accepted step [J]; change: of its load (force [N] or approach [m]).
  void add(double flow_turn, double change) {
    if (change == 0) return;  // nothing pressed: the error belongs to another motion
    turned_ += flow_turn / change;
    change_ += change;
  }
  /// Of the approach [m], from the change of force [N] in all of them; 0 where the force did not change.
  double of_approach(double force_change) const { return force_change == 0 ? 0.0 : turned_ * change_ / force_change; }

 private:
  double turned_ = 0, change_ = 0;
};

/// Into how many parts a step is divided so that finite steps leave at most `share` of the approach it makes; 1 where it may stay, or is no
/// load step. flow_turn: of the step in one [J]; its changes of approach [m] and force [N], and the force it reaches [N].
inline int parts_of_step(double flow_turn, double approach_change, double force_change, double force, double share) {
  constexpr int most = 16;               // what is left then is stated
  constexpr double at_a_turn = 0.01;     // of the force: its change vanishes where attraction gives way, an error does not grow there
  const double size = std::abs(approach_change) * std::max(std::abs(force_change), at_a_turn * std::abs(force));
  if (share <= 0 || size == 0 || flow_turn == 0) return 1;
  return static_cast<int>(std::clamp(std::ceil(std::abs(flow_turn) / (share * size)), 1.0, static_cast<double>(most)));
}

}  // namespace asperity::fem

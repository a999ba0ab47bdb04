// Error of the approach of yielding bodies from finite load steps.
//
// Radial return flows in the direction n at the end of a step. Along the path it turns from n0, where
// yielding sets in, so the increment of plastic strain is off by e = |de_p| (n - n0) / 2. By reciprocity that
// eigenstrain moves the approach by the integral of S : e, with S the change of stress per unit of load of
// the bodies as they yield: the change in the step over its change of force (Betti's theorem with the tangent
// operator, which is symmetric in associated flow; Simo & Hughes 1998, box 3.2). For perfect plasticity this
// is half of d(sigma) : d(e_p), which Drucker's postulate makes zero along the path, positive in a step: the
// approach comes out too large.
//
// The errors of all steps are kept as a strain, and weighed by the S of the present step: stress at a point
// within a contact that has grown beyond it hardly answers to the load any more, so that an old error there
// moves the approach much less than when it arose.
//
// A step whose share is larger than asked is divided: n parts leave an n-th.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "fem/cells/hex_kernel.h"

namespace asperity::fem {

/// Of the stated error itself, relative: it is of first order, and was 0.98 to 1.92 times the true one, alike
/// for few and many steps (tests/fem/plastic_contact_test.cc).
constexpr double uncertainty_of_load_step_error = 0.5;

/// How far the direction of flow turns at one point within a step.
struct FlowTurn {
  std::array<double, 6> strain{};  ///< e = |de_p| (n at the step's end - n where yielding sets in) / 2
  double energy = 0;               ///< e : change of stress in the step [J/m^3]
};

/// Of one lane. start, trial: deviators relative to the back stress [Pa], before the step and as if it were
/// elastic; limit: of their norm [Pa]; increment: of plastic strain; change_of_stress [Pa].
inline FlowTurn flow_turn(const SymmetricTensor<Simd<double>>& start,
                          const SymmetricTensor<Simd<double>>& trial, double limit,
                          const SymmetricTensor<Simd<double>>& increment,
                          const SymmetricTensor<Simd<double>>& change_of_stress, int lane) {
  double flow = 0, step_square = 0, along = 0, start_square = 0;
  for (int c = 0; c < 6; ++c) {
    const double count = c < 3 ? 1 : 2, a = start[c][lane], d = trial[c][lane] - a;
    flow += count * increment[c][lane] * increment[c][lane];
    step_square += count * d * d, along += count * a * d, start_square += count * a * a;
  }
  flow = std::sqrt(flow);
  if (flow == 0) return {};
  // The straight path in stress space comes to the yield surface, from inside or along it, at this share of
  // itself.
  const double inside = start_square - limit * limit;
  const double share =
      step_square > 0 ? std::clamp((-along + std::sqrt(std::max(0.0, along * along - step_square * inside))) /
                                       step_square,
                                   0.0, 1.0)
                      : 0.0;
  FlowTurn turn;
  for (int c = 0; c < 6; ++c) {
    const double onset = start[c][lane] + share * (trial[c][lane] - start[c][lane]);
    turn.strain[c] = 0.5 * (increment[c][lane] - flow * onset / limit);
    turn.energy += (c < 3 ? 1 : 2) * turn.strain[c] * change_of_stress[c][lane];
  }
  return turn;
}

/// A change of force [N] too small beside the force reached to give the tangent compliance: at turning
/// points.
constexpr double change_at_a_turn = 0.01;

/// The change of force that gives the tangent compliance of a step; 0 where it is too small for that.
/// All in [N].
inline double telling_change(double force_change, double force) {
  return std::abs(force_change) > change_at_a_turn * std::abs(force) ? force_change : 0.0;
}

/// Into how many parts a step is divided so that finite steps leave at most `share` of the approach it makes;
/// 1 where it may stay, or is no load step. flow_turn: of the step in one [J]; its changes of approach [m]
/// and force [N], and the force it reaches [N].
inline int parts_of_step(double flow_turn, double approach_change, double force_change, double force,
                         double share) {
  constexpr int most = 16;  // the remaining error is stated
  // The change of force vanishes where attraction softens; an error does not grow there.
  const double size =
      std::abs(approach_change) * std::max(std::abs(force_change), change_at_a_turn * std::abs(force));
  if (share <= 0 || size == 0 || flow_turn == 0) return 1;
  return static_cast<int>(
      std::clamp(std::ceil(std::abs(flow_turn) / (share * size)), 1.0, static_cast<double>(most)));
}

}  // namespace asperity::fem

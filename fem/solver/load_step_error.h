// What finite load steps leave in the approach of bodies that yield.
//
// Radial return flows in the direction n at the end of a step. Along the path it turns from n0, where yielding sets in, so the increment
// of plastic strain is off by e = |de_p| (n - n0) / 2. By reciprocity that eigenstrain moves the approach by the integral of S : e, with S
// the change of stress per unit of load of the bodies as they yield: the change in the step over its change of force (Betti's theorem with
// the tangent operator, which is symmetric in associated flow; Simo & Hughes 1998, box 3.2). For perfect plasticity this is half of
// d(sigma) : d(e_p), which Drucker's postulate makes zero along the path, positive in a step: the approach comes out too large.
//
// A point that flows on forgets: its stress is drawn to its place on the yield surface, and what it is off by falls by exp(-x), with
// x = 2 G (1 - beta) |de_p| / |s|, the flow over the elastic strain (the rate equation of Krieg & Krieg 1977, linear about its steady state).
// beta = 6 (K + 2 G) / (5 (3 K + 4 G)) is the share of an eigenstrain to which the material around gives way (Eshelby 1957, a sphere).
// Without that the sum over many steps comes out several times too large.
//
// A step whose share is larger than asked is divided: n parts leave an n-th.
#pragma once

#include <algorithm>
#include <cmath>

#include "fem/solver/hex_kernel.h"

namespace asperity::fem {

/// Of the stated error itself, relative: it is of first order, and was 0.9 to 2.7 times the true one (tests/fem/plastic_contact_test.cc).
constexpr double load_step_doubt = 0.5;

/// 2 G (1 - beta) [Pa] of shear modulus G and bulk modulus K.
inline double constrained_stiffness(double G, double K) { return 2 * G * (1 - 6 * (K + 2 * G) / (5 * (3 * K + 4 * G))); }

struct FlowTurn {
  double energy = 0;  ///< (n at the step's end - n where yielding sets in) : change of stress |de_p| / 2 [J/m^3]
  double kept = 1;    ///< share of earlier steps' errors that this one leaves
};

/// Of one lane. start, trial: deviators relative to the back stress [Pa], before the step and as if it were elastic; limit: of their norm
/// [Pa]; stiffness: 2 G (1 - beta) [Pa]; increment: of plastic strain; change_of_stress [Pa].
inline FlowTurn flow_turn(const SymmetricTensor<Simd<double>>& start, const SymmetricTensor<Simd<double>>& trial, double limit, double stiffness,
                          const SymmetricTensor<Simd<double>>& increment, const SymmetricTensor<Simd<double>>& change_of_stress, int lane) {
  double flow = 0, way_square = 0, along = 0, start_square = 0;
  for (int c = 0; c < 6; ++c) {
    const double count = c < 3 ? 1 : 2, a = start[c][lane], d = trial[c][lane] - a;
    flow += count * increment[c][lane] * increment[c][lane];
    way_square += count * d * d, along += count * a * d, start_square += count * a * a;
  }
  flow = std::sqrt(flow);
  if (flow == 0) return {};
  // The straight way comes to the yield surface, from inside or along it, at this share of itself.
  const double inside = start_square - limit * limit;
  const double share =
      way_square > 0 ? std::clamp((-along + std::sqrt(std::max(0.0, along * along - way_square * inside))) / way_square, 0.0, 1.0) : 0.0;
  double sum = 0;
  for (int c = 0; c < 6; ++c) {
    const double onset = start[c][lane] + share * (trial[c][lane] - start[c][lane]);
    sum += (c < 3 ? 1 : 2) * (increment[c][lane] / flow - onset / limit) * change_of_stress[c][lane];
  }
  const double x = stiffness * flow / limit;
  return {0.5 * flow * sum, std::exp(-x)};
}

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

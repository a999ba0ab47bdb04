// Delayed elasticity: the deviatoric stress of a strain that is held relaxes, G(t) = G [1 - g (1 -
// exp(-t/tau))], one term of a Prony series, the standard linear solid (Zener 1948); the bulk modulus stays.
// G is that of fast strain, (1 - g) G that of slow.
//
// The same in series: a spring G and a Kelvin element of a spring G (1 - g)/g and a viscosity G tau/g, whose
// strain is the viscous strain z: s = 2 G (e - z), tau dz/dt = g e - z (from 2 G tau/g dz/dt = s - 2 G (1 -
// g)/g z). A step in which e changes evenly is solved exactly (Taylor, Pister & Goudreau 1970; Simo & Hughes
// 1998, ch. 10).
#pragma once

#include <cmath>

#include "fem/cells/hex_kernel.h"

namespace asperity::fem {

struct Relaxation {
  double share = 0;  ///< g, of the shear modulus that relaxes [-]; 0: nothing does
  double time = 0;   ///< tau [s]

  bool is_there() const { return share > 0; }
  /// Of the spring of the Kelvin element, for the modulus of fast strain [Pa].
  double delayed_modulus(double shear_modulus) const { return shear_modulus * (1 - share) / share; }
};

/// What a step makes of strains at its beginning and in its course.
struct RelaxationStep {
  double share = 0;  ///< of the shear modulus that relaxes [-]
  double decay = 1;  ///< exp(-dt/tau), of what was there at the beginning [-]
  double mean = 1;   ///< the mean of exp(-t/tau) over the step [-]

  RelaxationStep() = default;
  /// duration [s].
  RelaxationStep(const Relaxation& law, double duration) : share(law.share) {
    if (!law.is_there() || !(duration > 0)) return;
    const double x = duration / law.time;
    decay = std::exp(-x);
    mean = -std::expm1(-x) / x;
  }
  /// Of the shear modulus, for a change of strain in this step [-].
  double tangent() const { return 1 - share * (1 - mean); }
};

/// The viscous strain of one lane at the end of a step, from deviators of strain at its ends.
inline void relax(const RelaxationStep& step, const SymmetricTensor<Simd<double>>& before,
                  const SymmetricTensor<Simd<double>>& now, int lane,
                  SymmetricTensor<Simd<double>>& viscous) {
  for (int c = 0; c < 6; ++c) {
    // What is left of the strain in a Maxwell element, e - z/g.
    const double left = step.decay * (before[c][lane] - viscous[c][lane] / step.share) +
                        step.mean * (now[c][lane] - before[c][lane]);
    viscous[c][lane] = step.share * (now[c][lane] - left);
  }
}

}  // namespace asperity::fem

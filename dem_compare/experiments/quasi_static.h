// An experiment with one particle as a sequence of equilibria: in each increment of the indenter the
// particle's place and rotation and the indenter's height are found such that all forces and moments vanish
// and the indenter carries its load (Newton's method on seven unknowns; one, if the particle is glued). Rates
// and inertia do not enter. The indenter goes on only from an accepted equilibrium; an increment that finds
// none is halved. SI units.
#pragma once

#include "dem_compare/experiments/loop_program.h"
#include "dem_compare/experiments/single_particle.h"

namespace asperity {

/// When a step counts as equilibrium.
struct QuasiStaticOptions {
  double tolerance = 1e-11;  ///< of the imbalance over the normal force or the limit of the lateral one
  int most_halvings = 20;
};

/// Throws WorkError where no equilibrium is found.
FrictionLoop simulate_quasi_static(const SingleParticle& particle, const LoopProgram& program,
                                   const QuasiStaticOptions& options = {});

}  // namespace asperity

// The same experiments with inertia: velocity-Verlet (Verlet 1967; Swope et al. 1982) for the particle and
// for the height of the indenter, which carries the load; the indenter's x is prescribed at constant speed.
// Viscous terms after viscous.h. Scaling of speed: at the laboratory's 1 um/s a loop takes seconds and a time
// step nanoseconds, so the indenter is moved faster. The laws know no rate; what the speed adds are forces of
// inertia, about v (k m)^(1/2) (3 uN at 10 mm/s, 0.3 uN at 1 mm/s), and the viscous part. So the indenter is
// slow around each reversal, where stiffness is read off, and fast between; choose the fast speed so that its
// forces are small against the plateau that is looked for. SI units.
#pragma once

#include "dem_compare/experiments/loop_program.h"
#include "dem_compare/experiments/single_particle.h"

namespace asperity {

/// Speed, masses and time step.
struct DynamicOptions {
  double speed = 1e-3;  ///< of the indenter between reversals [m/s]
  double reversal_share =
      1e-4;  ///< of the way to the first limit that the indenter goes in (m/k)^(1/2) around a reversal
  double density = 2230;         ///< of the particle [kg/m^3]; borosilicate
  double indenter_mass = 0;      ///< [kg]; 0: the particle's
  double time_step_ratio = 0.1;  ///< time step over (m/k)^(1/2) with the stiffest normal contact
};

constexpr double laboratory_speed = 1e-6;  ///< of the paper's experiments [m/s]

/// Same stations as the quasi-static run; each row is the first time step that reaches its station.
/// Throws WorkError if a contact opens or the run diverges.
FrictionLoop simulate_dynamic(const SingleParticle& particle, const LoopProgram& program,
                              const DynamicOptions& options);

}  // namespace asperity

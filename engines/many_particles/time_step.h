// Time step of explicit integration that a matrix of materials asks for: the smaller of a share of the
// Rayleigh time (Thornton & Randall 1988: the wave along the surface of the smallest particle) and of the
// shortest period of a particle on its contact springs (normal, lateral, rolling, torsion) at the highest
// load.
#pragma once

#include <string>

#include "engines/many_particles/material_matrix.h"

namespace asperity {

/// What decides a time step.
struct TimeStep {
  double rayleigh = 0;         ///< pi R (rho/G)^(1/2)/(0.1631 nu + 0.8766) [s]
  double shortest_period = 0;  ///< [s]
  std::string spring;          ///< the one of the shortest period: "rolling of 'a' on 'b'"
  double advised = 0;          ///< [s]
};

/// Throws InputError where no material has density, Young's modulus and Poisson's ratio.
TimeStep time_step_of(const MaterialMatrix& matrix);

}  // namespace asperity

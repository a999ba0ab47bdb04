// What a case takes to solve, roughly, before it is meshed.
#pragma once

#include <string>

#include "fem/case/case_setup.h"

namespace asperity::fem {

/// Unknowns of a mesh with these fine regions, roughly: layers of cells that double in size away from both
/// interfaces.
/// layers [-].
double estimated_unknowns(const meshing::BodySizes& sizes, double layers);

/// Peak memory of `asperity solve` on one process [byte]; all_keep_history: all cells of the bodies.
double estimated_memory(double unknowns, bool all_keep_history = false);

/// What to say where a mesh needs more memory than `available` [byte]; empty: it fits. Throws InputError
/// where it needs more than twice as much, which no doubt of the estimate explains: the system would end the
/// program halfway.
std::string memory_warning(const CaseInput& input, const CaseSetup& setup, double unknowns, double available);

struct SolveCost {
  double unknowns = 0;  ///< [-]
  double memory = 0;    ///< [byte]
  int steps = 0;        ///< of the experiment
  double seconds = 0;   ///< on one core, to a factor of two [s]

  /// The same on two cores, of which the serial parts leave 1.3 (benchmarks/README.md) [s].
  double seconds_on_two_cores() const { return seconds / 1.3; }
};
/// Of a case that is set up; yields: whether a body of it can.
SolveCost estimated_cost(const CaseInput& input, const CaseSetup& setup, bool yields);

}  // namespace asperity::fem

// The friction loop of the paper's experiments: the indenter is pressed with a constant load and moved to +A,
// -A, +A, ... (Fuchs, Weinhart et al. 2014: A = 1 um, 1 um/s). SI units.
#pragma once

#include <vector>

namespace asperity {

struct LoopProgram {
  double normal_load = 1e-4;     ///< at the indenter [N]
  double amplitude = 1e-6;       ///< A [m]
  int cycles = 1;                ///< returns to +A after the first way there
  double first_increment = 0;    ///< after a reversal [m]; 0: a twentieth of what the softest mode yields at
  double growth = 1.15;          ///< of the increments along a leg
  double largest_increment = 0;  ///< [m]; 0: a fiftieth of the amplitude
};

/// One way of the indenter between two reversals.
struct LoopStation {
  int leg = 0;          ///< 0: first loading, then numbered
  double position = 0;  ///< [m]
};

/// Where the loop is evaluated: dense after each reversal, where contacts stick, and wide where they slide.
/// Throws InputError for a program that is no loop.
std::vector<LoopStation> loop_stations(const LoopProgram& program, double first_increment);

}  // namespace asperity

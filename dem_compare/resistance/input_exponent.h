// How a resistance goes with an input that is a choice: contacts that differ in local friction, works of
// adhesion or yield stresses alone, by a common factor, on the same surfaces. SI units.
#pragma once

#include <string>
#include <vector>

#include "dem_compare/resistance/moving_study.h"

namespace asperity {

/// M ~ x^exponent between two values of an input x: 1 where the resistance is proportional to it, 0 where it
/// does not matter.
struct InputExponent {
  std::string input;  ///< "local friction", "works of adhesion", "yield stresses"
  const MovingContact *larger = nullptr, *smaller = nullptr;
  const MotionMode* mode = nullptr;
  double load = 0;       ///< [N]
  double factor = 1;     ///< of the input, above 1
  int realisations = 0;  ///< compared, each with itself
  Uncertain exponent;    ///< ln(M_larger/M_smaller)/ln(factor)
};

/// One for each pair, motion and load.
std::vector<InputExponent> input_exponents(const MovingStudy& study);

}  // namespace asperity

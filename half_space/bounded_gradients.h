// Conjugate gradients for pressures between 0 and a hardness, at a given load or approach: Polonsky & Keer
// (1999), with an upper bound beside the lower one.
#pragma once

#include "half_space/normal_contact.h"

namespace asperity::half_space {

/// What is given.
struct NormalLoad {
  bool by_force = true;
  double value = 0;  ///< [N], or the approach [m]
};

/// Goes on from the pressures of `solution` until its error is below options.tolerance. Throws WorkError
/// where that takes more than options.most_iterations.
void iterate(const Compliance& compliance, const Field& gap, const NormalLoad& load,
             const NormalContactOptions& options, NormalContactSolution& solution);

}  // namespace asperity::half_space

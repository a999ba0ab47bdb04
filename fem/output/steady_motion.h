// The steady resistance of a motion that has slipped as a whole, and its fluctuation.
#pragma once

#include <optional>
#include <vector>

#include "fem/output/step_record.h"

namespace asperity::fem {

struct SteadyResistance {
  double mean, sd;  ///< over the way, each step weighted with its length; the sd is the fluctuation about the mean
  double way;       ///< [m] or [rad]
};

/// Lateral over normal force where at most 2 % of the closed nodes stick and the particle moves forward; none if it never slides.
std::optional<SteadyResistance> steady_sliding(const std::vector<StepRecord>& records);
/// Torsion moment [N m] in the same sense.
std::optional<SteadyResistance> steady_torsion(const std::vector<StepRecord>& records);

}  // namespace asperity::fem

// The RMS height of a substrate that stands for what was found of asperities, from realisations of it.
#pragma once

#include <optional>

#include "diagnosis/catalogue/effect.h"

namespace asperity {

/// Entry with the height at which the approach grows as much as was found, on the average over realisations,
/// and the heights of single ones as its 95 % interval. Empty where no roughness stands for the parameters,
/// or the model does not know. `parameters`: of the effect.
std::optional<CorrectedEntry> height_of_roughness(ForwardModel& model, const Experiment& experiment,
                                                  const Effect& effect,
                                                  const std::vector<DiagnosedParameter>& parameters);

}  // namespace asperity

// Noise on a clean recording, and what the concealed effect amounts to beside it.
#pragma once

#include "diagnosis/conceal/concealed_recording.h"

namespace asperity::hidden {

/// `without_effects`: response of each table without the effects; empty where it is not known. Lateral ones
/// are scaled first, as a coefficient of friction that is calibrated would be.
void add_noise(ConcealedRecording& concealed, const std::vector<std::vector<double>>& without_effects,
               const ConcealOptions& options);

}  // namespace asperity::hidden

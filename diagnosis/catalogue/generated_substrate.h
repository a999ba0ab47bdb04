// A generated substrate as an entry of a corrected case.
#pragma once

#include "core/printed.h"
#include "diagnosis/forward/forward_model.h"
#include "diagnosis/outcome/diagnosis.h"

namespace asperity {

/// low, high: 95 % interval of its RMS height [m].
inline CorrectedEntry generated_substrate(const RoughSubstrate& substrate, double low, double high) {
  return {"Substrate/Topography",
          "m",
          substrate.rms,
          low,
          high,
          printed("generated(rms=%.4g nm, hurst=0.8, rolloff=%.4g nm, cutoff=%.4g nm, seed=1)",
                  1e9 * substrate.rms, 1e9 * substrate.longest, 1e9 * substrate.shortest)};
}

}  // namespace asperity

// A recording and the simulation that it was set against, taken apart: where they part, and which physics was
// left out.
#pragma once

#include <functional>
#include <string>

#include "diagnosis/forward/forward_model.h"
#include "diagnosis/outcome/diagnosis.h"
#include "diagnosis/recording/recording.h"

namespace asperity {

/// What a caller may choose.
struct DiagnoseOptions {
  std::function<void(const std::string&)> progress;  ///< called with what is being done; may be empty
  ForwardModel* simulation = nullptr;  ///< a case to diagnose in place of reduced laws; null: these
  unsigned seed = 1;                   ///< of the simulated noise that calibrates p-values
};

/// The whole: simulate, locate, name, model, show, admit. Throws InputError or WorkError.
Diagnosis diagnose(const Recording& recording, const DiagnoseOptions& options = {});

}  // namespace asperity

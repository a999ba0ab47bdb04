// What the program says of a step while it works.
#pragma once

#include <string>

#include "fem/output/step_record.h"

namespace asperity::fem {

/// "  load 300 uN  shift ...  approach ...": what moves, forces, area, pressure and iterations.
std::string progress_of(const StepRecord& record);

}  // namespace asperity::fem

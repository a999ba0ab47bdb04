// The progress line of an accepted step.
#pragma once

#include <string>

#include "results/history.h"

namespace asperity::fem {

/// "  load 300 uN  shift ...  approach ...": what moves, forces, area, pressure and iterations.
std::string progress_of(const HistoryRow& record);

}  // namespace asperity::fem

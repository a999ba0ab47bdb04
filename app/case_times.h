// Entries of a case file that say how long the experiment takes.
#pragma once

#include <vector>

#include "app/case_declaration.h"

namespace asperity {

/// Adds speed and times of the Experiment section.
void add_times(std::vector<CaseEntry>& entries);

}  // namespace asperity

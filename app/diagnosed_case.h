// What a diagnosis of a case leaves beside diagnosis.json: the case with what was missing, and what both say.
#pragma once

#include <filesystem>

#include "core/parameter_file.h"
#include "diagnosis/outcome/diagnosis.h"

namespace asperity {

/// history_before.csv and, where entries of the case were corrected, corrected.prm and history_after.csv.
/// Former ones are removed; `settings`: null where reduced laws were the simulation, and nothing else is
/// done.
void write_diagnosed_case(const Settings* settings, const Diagnosis& diagnosis,
                          const std::filesystem::path& output);

}  // namespace asperity

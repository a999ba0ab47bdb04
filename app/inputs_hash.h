// One number for what a case computes: equal for the same case, another one for any other.
#pragma once

#include <filesystem>
#include <string>

#include "core/parameter_file.h"

namespace asperity {

/// SHA-256 of everything that decides a case's answer: each entry that is not at its default (quantities in
/// SI, so that 1 mN and 1000 uN are the same), and the content of each scan that it names, wherever the scan
/// lies. Left out: Title, Output and Solver/Threads, which change cost and files alone. An entry that a later
/// version adds does not change it while it is at its default. Expects settings that case_from_settings
/// accepts; `file` is where they come from.
std::string inputs_sha256(const Settings& settings, const std::filesystem::path& file);

/// The same of the contact alone, however it is driven: without Experiment.
std::string contact_sha256(const Settings& settings, const std::filesystem::path& file);

/// Whether an entry changes cost and files alone.
bool is_about_the_run(const Setting& setting);

}  // namespace asperity

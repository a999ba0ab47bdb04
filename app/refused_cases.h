// Cases that are not set against a recording yet.
#pragma once

#include <filesystem>

#include "core/case.h"

namespace asperity {

/// Throws InputError for a case that relaxes and does what its law does not hold for, naming the file.
void refuse_what_relaxes_besides(const CaseInput& input, const std::filesystem::path& file);

/// Throws InputError for a case that is not solved under a recording of normal contact, naming the file.
void refuse_for_normal_recordings(const CaseInput& input, const std::filesystem::path& file);

}  // namespace asperity

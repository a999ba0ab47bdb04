// Entries of a case that a recording's protocol asks for.
#pragma once

#include <string>

#include "core/parameter_file.h"
#include "diagnosis/forward/forward_model.h"

namespace asperity {

/// Gives an entry "Section/Entry" another text.
void set_entry(Settings& settings, const std::string& path, const std::string& value);
/// The case pressed to another load, or approach, and back.
void drive(Settings& settings, const LoadingProtocol& protocol);
/// The case slid, rolled or spun at a constant load from rest, in one direction.
void drive(Settings& settings, const MotionProtocol& protocol);

}  // namespace asperity

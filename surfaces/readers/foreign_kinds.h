// Formats of height maps that are known and not read: their files are refused by name.
#pragma once

#include "surfaces/readers/format.h"

namespace asperity {

/// Throws InputError that names the format, and what to export from which program, if the file begins like
/// one of those; returns otherwise.
void refuse_foreign_kind(const SourceFile& file);

}  // namespace asperity

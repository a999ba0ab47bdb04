// Files packed by gzip: what is inside is read as if it lay there unpacked.
#pragma once

#include "surfaces/readers/format.h"

namespace asperity {

/// Whether the file begins like one that gzip packed.
bool is_gzip(const SourceFile& file);

/// The file inside, under the same path. Throws InputError for what is damaged or cut off, and as soon as
/// more comes out than read_limits::most_unpacked() allows.
SourceFile unpacked_gzip(const SourceFile& file);

}  // namespace asperity

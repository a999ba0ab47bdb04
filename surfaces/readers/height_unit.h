// The unit of heights of files that may name none.
#pragma once

#include <string>

#include "surfaces/readers/format.h"

namespace asperity {

/// Factor to metres [m]: the unit that the file names, else the user's, else metres with
/// `height_unit_assumed` set; says in the map which it was. Throws InputError for a unit that is no length.
double height_unit(const SourceFile& file, const std::string& named, const ReadOptions& options,
                   StoredMap& map);

}  // namespace asperity

// Numbers in rows under a header of "name: value" lines, as Gwyddion, SPIP and people write height maps as
// text.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "surfaces/readers/format.h"

namespace asperity {

/// A header of names and titles, and rows of numbers.
struct TextTable {
  std::map<std::string, std::string> header;  ///< names in lower case
  std::vector<std::string> titles;  ///< header lines that are no "name: value", such as "x [um] y [um]"
  std::size_t columns = 0, rows = 0;
  std::vector<double> values;  ///< [row * columns + column]; NaN for words such as "nan" and "bad"

  /// Value of the first of these names that the header has; empty if none.
  std::string find(const std::vector<std::string>& names) const;
};

/// The header and the number of columns of the first row of numbers (0 if there is none); reads no further.
TextTable text_beginning(const SourceFile& file);

/// The whole table. Throws InputError naming the line that is no row like the first.
TextTable text_table(const SourceFile& file);

/// Unit of heights: the header's, else the user's, else metres with `height_unit_assumed` set.
/// In [m]. Throws InputError for a unit that is no length.
double text_height_unit(const SourceFile& file, const TextTable& table, const ReadOptions& options,
                        StoredMap& map);

}  // namespace asperity

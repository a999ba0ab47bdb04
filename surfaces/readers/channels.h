// Choosing one channel of a file that holds several.
#pragma once

#include <string>
#include <vector>

#include "surfaces/readers/format.h"

namespace asperity {

/// One channel.
struct ChannelEntry {
  std::string name;
  std::string unit;        ///< of its values, as the file spells it
  bool is_height = false;  ///< its values are lengths
};

/// Index of the channel asked for by name or number; without a wish, the first named after height or
/// topography, else the first whose values are lengths. Throws InputError listing the channels there are.
std::size_t choose_channel(const SourceFile& file, const std::vector<ChannelEntry>& channels,
                           const ReadOptions& options);

}  // namespace asperity

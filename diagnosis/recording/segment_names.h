// What the names in a trace's column `segment` mean.
#pragma once

#include <optional>
#include <string>

namespace asperity {

struct Recording;

/// "load", "hold", "unload", "forward" or "backward", in whichever case it is written; none: the name means
/// nothing here, and what its samples are is read off the driven motion.
std::optional<std::string> segment_meant_by(const std::string& written);

/// Which names of segments mean nothing, and what was done; empty: all do.
std::string remark_on_segment_names(const Recording& recording);

}  // namespace asperity

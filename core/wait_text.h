// How long something takes, in words for a person who waits.
#pragma once

#include <string>

#include "core/printed.h"

namespace asperity {

/// "42 s", "3 min", "1.6 h". seconds: [s].
inline std::string wait_text(double seconds) {
  if (seconds < 90) return printed("%.0f s", seconds);
  return seconds < 5400 ? printed("%.0f min", seconds / 60) : printed("%.1f h", seconds / 3600);
}

}  // namespace asperity

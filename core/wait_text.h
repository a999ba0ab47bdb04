// How long something takes, in words for a person who waits.
#pragma once

#include <cstdio>
#include <string>

namespace asperity {

/// "42 s", "3 min", "1.6 h". seconds: [s].
inline std::string wait_text(double seconds) {
  char text[32];
  if (seconds < 90)
    std::snprintf(text, sizeof text, "%.0f s", seconds);
  else if (seconds < 5400)
    std::snprintf(text, sizeof text, "%.0f min", seconds / 60);
  else
    std::snprintf(text, sizeof text, "%.1f h", seconds / 3600);
  return text;
}

}  // namespace asperity

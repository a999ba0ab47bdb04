// Numbers in the inputs that are written for engines.
#pragma once

#include <cstdio>
#include <string>

namespace asperity {

/// To 12 significant digits.
inline std::string text_number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.12g", value);
  return text;
}

}  // namespace asperity

// Two numbers that differ, written with as many digits as it takes to see it: "1.132 um is more than 1.131
// um", not "1.13 um is more than 1.13 um".
// Numbers in SI units.
#pragma once

#include <string>
#include <utility>

#include "core/quantity.h"

namespace asperity {

/// `write(value, digits)` of both, in three digits or as many more as tell them apart.
template <class Write>
std::pair<std::string, std::string> written_apart(double one, double other, const Write& write) {
  constexpr int usual = 3, most = 17;
  for (int digits = usual;; ++digits) {
    std::pair<std::string, std::string> texts{write(one, digits), write(other, digits)};
    if (texts.first != texts.second || one == other || digits == most) return texts;
  }
}

/// "1.132 um" and "1.131 um".
inline std::pair<std::string, std::string> quantities_apart(double one, double other, Dimension dimension) {
  return written_apart(one, other, [dimension](double value, int digits) {
    return format_quantity(value, dimension, digits);
  });
}

/// "1.004 %" and "1 %" of shares.
inline std::pair<std::string, std::string> percents_apart(double one, double other) {
  return written_apart(one, other, [](double value, int digits) {
    return format_quantity(100 * value, Dimension::none, digits) + " %";
  });
}

}  // namespace asperity

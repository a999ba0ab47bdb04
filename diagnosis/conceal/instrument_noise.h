// What an instrument adds to a clean signal: white noise, a part that is correlated over a few samples, and
// now and then an outlier.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/conceal/world.h"

namespace asperity::hidden {

struct InstrumentNoise {
  double sd = 0;                                     ///< of one sample, of all parts together
  double correlated_share = 0;                       ///< of the variance
  double correlation_length = 3;                     ///< samples over which the correlated part fades by e
  double outlier_probability = 0, outlier_size = 8;  ///< size in sd

  std::string words() const;
  void add_to(std::vector<double>& signal, Random& random) const;
};

}  // namespace asperity::hidden

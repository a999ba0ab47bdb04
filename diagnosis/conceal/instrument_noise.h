// What an instrument adds to a clean signal: white noise, a part that is correlated over a few samples, and
// now and then an outlier.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/conceal/world.h"

namespace asperity::hidden {

struct InstrumentNoise {
  double sd = 0;                  ///< of one sample, of all parts together, in the unit of the signal
  double correlated_share = 0;    ///< of the variance [-]
  double correlation_length = 3;  ///< samples over which the correlated part fades by e [-]
  double outlier_probability = 0, outlier_size = 8;  ///< size in sd [-]

  /// The noise in words, for truth.json.
  std::string words() const;
  /// Adds a draw of it to each value.
  void add_to(std::vector<double>& signal, Random& random) const;
};

}  // namespace asperity::hidden

// Where a signal rises, rests and falls: the segments of a recording, from its driven channel.
#pragma once

#include <string>
#include <vector>

namespace asperity {

struct FoundSegments {
  std::vector<std::string> segment;  ///< of each sample: "load", "hold", "unload"
  std::vector<double> cycle;         ///< loops begun so far, from 0
};

/// Turning points are those from which the signal comes back by more than a part of its range (as in rainflow
/// counting); between them, intervals of at least two hundredths of the samples in which it moves by less
/// than a hundredth of the range are holds.
FoundSegments find_segments(const std::vector<double>& signal);

}  // namespace asperity

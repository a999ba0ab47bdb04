// Where a signal rises, rests and falls: the segments of a recording, from its driven channel.
#pragma once

#include <string>
#include <vector>

namespace asperity {

/// Segment and cycle of each sample.
struct FoundSegments {
  std::vector<std::string> segment;  ///< of each sample: "load", "hold", "unload"
  std::vector<double> cycle;         ///< loops begun so far, from 0
};

/// Turning points are those from which the signal comes back by more than a hundredth of its range and more
/// than its noise (as in rainflow counting). Holds are intervals in which it moves by less than that for
/// twice as many samples as a steady motion over the range in the whole record would.
FoundSegments find_segments(const std::vector<double>& signal);

}  // namespace asperity

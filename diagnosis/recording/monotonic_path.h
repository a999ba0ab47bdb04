// The path that a sensor's noise hides: a drive that is monotonic in a segment does not come back between
// samples, but its recorded displacement may, and a stiff contact would answer with a reversal of its force.
// In its place the nearest monotonic path (least squares), found by pooling adjacent violators
// (Ayer et al. 1955; Barlow et al. 1972).
#pragma once

#include <vector>

namespace asperity {

/// Nearest values that do not fall.
std::vector<double> nearest_rising(const std::vector<double>& values);

/// The nearest path in this direction (+1, -1); as it is where it comes back by more than noise does: a
/// hundredth of its length.
std::vector<double> monotonic_path(const std::vector<double>& path, int direction);

}  // namespace asperity

// Where a motion turned that was recorded at times of a clock of its own, mostly between two samples.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace asperity {

struct TurningPoint {
  double displacement = 0;  ///< [m]
  double time = 0;          ///< [s]
};

/// Between which samples a path turns, and where.
struct Turn {
  std::size_t next = 0;               ///< the first sample after it
  std::optional<TurningPoint> place;  ///< none: at the sample before, to a hundredth of a step
};

/// The turn of a path over time [m, s] that goes one way from the sample `begin` to about `turn`, and the
/// other to `end`: where the lines through its samples before and after meet. The samples at `turn` and
/// before it may lie on either. None where the motion is not steady about the turn (it slows down, or rests),
/// or where fewer than four samples lie on a side.
std::optional<Turn> turn_of(const std::vector<double>& path, const std::vector<double>& time,
                            std::size_t begin, std::size_t turn, std::size_t end);

}  // namespace asperity

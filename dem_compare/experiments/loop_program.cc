#include "dem_compare/experiments/loop_program.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace asperity {

std::vector<LoopStation> loop_stations(const LoopProgram& program, double first_increment) {
  if (!(program.amplitude > 0))
    throw InputError("the amplitude of a friction loop is not positive; give one such as 1 um");
  if (program.cycles < 0)
    throw InputError("a friction loop cannot have fewer than no cycles; give 1 or more");
  if (!(program.growth >= 1))
    throw InputError("the increments of a friction loop cannot shrink; give a growth of 1 or more");
  if (!(first_increment > 0))
    throw InputError("the first increment of a friction loop is not positive; give one such as 0.01 nm");
  constexpr double default_increments = 50;
  const double largest =
      program.largest_increment > 0 ? program.largest_increment : program.amplitude / default_increments;
  std::vector<LoopStation> stations;
  double at = 0;
  for (int leg = 0; leg <= 2 * program.cycles; ++leg) {
    const double end = leg % 2 == 0 ? program.amplitude : -program.amplitude, way = std::abs(end - at);
    double increment = std::min(first_increment, largest);
    for (double gone = increment; gone < way; gone += increment) {
      stations.push_back({leg, at + std::copysign(gone, end - at)});
      increment = std::min(increment * program.growth, largest);
    }
    stations.push_back({leg, end});
    at = end;
  }
  return stations;
}

}  // namespace asperity

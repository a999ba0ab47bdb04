// The data cut into bins along each variable that can order a mismatch: displacement, load, time in a hold,
// cycle, speed, radius, roughness, angle; one view for each table, segment and variable.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/recording/experiment.h"

namespace asperity {

/// One bin.
struct Bin {
  double from = 0, to = 0;           ///< of the variable, in its unit
  std::vector<std::size_t> samples;  ///< that count
};

/// The bins of one variable in one segment.
struct View {
  std::size_t table = 0;
  std::string segment;   ///< "" for all
  std::string variable;  ///< channel; "" for the whole table as one bin
  std::vector<Bin> bins;
};

/// All views that the samples allow.
std::vector<View> views_of(const Samples& samples, const Experiment& experiment);

}  // namespace asperity

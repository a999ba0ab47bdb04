// Luding's law as engines follow it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <string>

#include "dem_compare/laws/luding.h"
#include "tests/engines/engine_support.h"

namespace asperity::test {

/// Lines "at DELTA FORCE" of an engine that was driven to `deepest` and back.
/// `what` names it.
inline void expect_the_law(const std::string& output, const Luding& law, double deepest,
                           const std::string& what) {
  std::istringstream lines(output);
  std::string line;
  NormalState state;
  int compared = 0;
  double reached = 0;
  Largest error;
  while (std::getline(lines, line)) {
    double approach = 0, force = 0;
    if (std::sscanf(line.c_str(), "at %lf %lf", &approach, &force) != 2) continue;
    state = law.advance(state, approach);
    error.count((force - state.force) / (law.loading_stiffness * deepest));
    reached = std::max(reached, approach), ++compared;
  }
  EXPECT_GE(compared, 60) << output;
  EXPECT_NEAR(reached, deepest, 0.02 * deepest);
  EXPECT_LT(state.approach, 0.2 * deepest) << "it went back, through the pull";
  EXPECT_TRUE((Verified{"Engines", what + ", load and unload: force over the largest", "Luding 2008"}.below(
      100 * error, 1, " %")))
      << output;
}

}  // namespace asperity::test

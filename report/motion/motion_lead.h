// What leads the page of a case that slid, rolled, spun or followed a program: friction, moment, and what
// takes it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/page/page.h"
#include "results/solved_case.h"

namespace asperity::report {

struct MotionLead {
  std::string headline;                ///< HTML
  std::vector<std::string> sentences;  ///< HTML
  std::vector<Tile> tiles;
};

/// None for a case that was only pressed.
std::optional<MotionLead> motion_lead(const SolvedCase& solved);

}  // namespace asperity::report

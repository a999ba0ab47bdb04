// The contacts of a study as a report shows them: one curve each, over its loads, on the finest mesh.
#pragma once

#include <string>
#include <vector>

#include "dem_compare/compare/comparison.h"

namespace asperity::report {

/// Departure of stiffness or force that a report calls one.
constexpr double tolerance = 0.05;

/// Groups that are drawn as one curve: same contact, different largest load.
struct StudyCurve {
  std::string label;
  std::vector<const GroupComparison*> groups;  ///< by growing load
  const CaseGroup* largest = nullptr;          ///< cases of the group with the largest load
  const GroupComparison& last() const { return *groups.back(); }
};

/// In the study's order. Groups on coarser meshes, which judge the finest, are left out.
std::vector<StudyCurve> curves_of(const CaseCollection& collection, const Comparison& comparison);

}  // namespace asperity::report

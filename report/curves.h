// The charts of a report: load against approach, stiffness, contact area.
#pragma once

#include <string>
#include <vector>

#include "dem_compare/comparison.h"
#include "report/chart.h"

namespace asperity::report {

/// Units in which a set of cases reads well.
struct ForceUnit {
  double si = 1e-6;
  std::string name = "µN";
};
ForceUnit force_unit(double largest_force);

/// All branches of one case, and Hertz.
Chart load_approach_chart(const SolvedCase& solved);
Chart stiffness_chart(const SolvedCase& solved, const NormalNumbers& numbers);
Chart contact_area_chart(const SolvedCase& solved);

/// Groups that are drawn as one curve of a study: same contact, different largest load.
struct StudyCurve {
  std::string label;
  std::vector<const GroupComparison*> groups;  ///< by growing load
  const CaseGroup* largest = nullptr;          ///< cases of the group with the largest load
  const GroupComparison& last() const { return *groups.back(); }
};
Chart load_approach_chart(const std::vector<StudyCurve>& curves);
/// A ratio to Hertz against load: the mean of the group with the largest load, bars are its standard deviation.
Chart ratio_chart(const std::vector<StudyCurve>& curves, Scatter LoadComparison::*ratio, const std::string& label,
                  double tolerance);

}  // namespace asperity::report

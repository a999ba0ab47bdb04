// The charts of a report: load against approach, stiffness, contact area.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "dem_compare/compare/comparison.h"
#include "report/curves/study_curves.h"
#include "report/page/chart.h"

namespace asperity::report {

/// Units in which a set of cases reads well.
struct ForceUnit {
  double si = 1e-6;
  std::string name = "µN";
};
ForceUnit force_unit(double largest_force);

/// All branches of one case, and Hertz.
/// Load against approach of all contacts of a study.
Chart load_approach_chart(const SolvedCase& solved);
Chart stiffness_chart(const SolvedCase& solved, const NormalNumbers& numbers);
Chart contact_area_chart(const SolvedCase& solved);
/// A column that a file of its own adds, over the steps, in its own unit.
Chart added_column_chart(const SolvedCase& solved, const AddedValues& column);

/// The same of all contacts of a study.
Chart load_approach_chart(const std::vector<StudyCurve>& curves);
/// A number against load: means of the group with the largest load; bars are standard deviations over
/// realisations. The ratios have a band around 1; others are divided by `unit` [SI] and have Hertz' value as
/// a dashed line, if it is given.
Chart ratio_chart(const std::vector<StudyCurve>& curves, Estimate LoadComparison::*ratio,
                  const std::string& label);
Chart value_chart(const std::vector<StudyCurve>& curves, Estimate LoadComparison::*value, double unit,
                  const std::string& label, const std::function<double(const Hertz&, double force)>& hertz);

}  // namespace asperity::report

// What solved cases say: the first column of the comparison. Scatter over realisations where there are
// several, otherwise the standard deviation that the solver gives its own number. SI units.
#pragma once

#include <vector>

#include "dem_compare/compare/comparison.h"
#include "dem_compare/compare/row.h"

namespace asperity {

/// A quantity at one load, from the cases of a group.
struct FiniteElementPoint {
  std::size_t group = 0;  ///< in the collection
  Quantity quantity = Quantity::approach;
  double load = 0;  ///< [N]
  FiniteElementValue value;
};

/// Of the finest mesh of each contact. A case of sliding, rolling or torsion gives its normal numbers at its
/// largest load alone.
std::vector<FiniteElementPoint> finite_element_points(const CaseCollection& collection,
                                                      const Comparison& comparison);

/// Stiffness of the spring that, with a slider at the largest lateral force F, takes the same work on the
/// path to sliding: k = F^2/(2 int (F - f) dx), f the lateral force on the first path out [N/m]. For Mindlin
/// and Deresiewicz (5/6) 8 G* a. (F - f)^(2/3) is taken as linear between steps, as it is there: exact for
/// them however coarse the steps. NaN where the history does not reach sliding.
double stiffness_to_sliding(const History& history, double sliding_force);

}  // namespace asperity

// What a reduced law says as its contact is led one way: the curve a user looks at before choosing the law.
#pragma once

#include <string>
#include <vector>

#include "dem_compare/laws/law_registry.h"

namespace asperity {

/// Where a law is led from, and how far.
struct LawCurveOptions {
  NormalState normal;  ///< of the contact under its load; a normal law starts without contact instead
  double lever = 0;    ///< from the particle's centre to the contact [m]
  double mass = 0;     ///< of the particle [kg]
  double reach = 0;    ///< of the approach, shift [m], rotation [rad], velocity [m/s] or ratio of velocities
  int points = 50;     ///< behind the first
};

struct LawCurve {
  std::vector<std::string> names;  ///< with their units
  std::vector<std::vector<double>> columns;
};

/// Throws InputError for a reach or a number of points that is not positive.
LawCurve curve_of(const ReducedLaw& law, const LawCurveOptions& options);

}  // namespace asperity

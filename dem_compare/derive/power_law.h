// A stiffness that grows with a power of the contact radius, k = c a(f)^n, from cases at several loads. SI
// units.
#pragma once

#include <functional>
#include <vector>

#include "dem_compare/cases/case_numbers.h"
#include "engines/parameters/contact_parameters.h"

namespace asperity {

struct PowerLaw {
  double at_load = 0;  ///< geometric mean of the loads [N]
  double value = 0;    ///< k there
  double sd = 0;       ///< the larger of the scatter of the cases' mean and the mean of their own sds; NaN if
                       ///< neither is known
  double exponent = 0, exponent_sd = 0;  ///< n as fitted over the loads; NaN for one load
  LoadRange loads;
};

/// Mean of log(k/a^n) with n given; the exponent is fitted apart. Needs a number.
PowerLaw fit_power(const std::vector<CaseNumber>& numbers,
                   const std::function<double(double load)>& contact_radius, double exponent = 1);

}  // namespace asperity

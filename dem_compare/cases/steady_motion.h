// Means of correlated series along a path, and the stiffness after a reversal. SI units. Neighbouring places
// of a path feel the same asperities: N values count as N_eff = N/(1 + 2 sum (1 - k/N) rho_k) independent
// ones, rho_k the autocorrelation summed until it first vanishes (Bartlett 1946; Geyer 1992), and the mean is
// known to s/(N_eff - 1)^(1/2). Holds for a path of many correlation lengths. What is steady, and what
// resists, core/steady_motion.h defines.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "core/steady_motion.h"

namespace asperity {

/// Mean of a correlated series, and what is known about it.
struct CorrelatedMean {
  double mean = 0, sd = 0;    ///< sd of the values
  double standard_error = 0;  ///< of the mean
  double independent = 0;     ///< N_eff
};
/// Of values at equal distances; needs two or more.
CorrelatedMean correlated_mean(const std::vector<double>& values);

/// Values between two rows of a monotonic path, at equal distances of a median step. Rows may rest.
std::vector<double> resampled_along(const std::vector<double>& position, const std::vector<double>& values,
                                    std::size_t first, std::size_t last);

/// Value and error bound.
struct ReversalStiffness {
  double value = std::numeric_limits<double>::quiet_NaN(), error = std::numeric_limits<double>::quiet_NaN();
};

/// Ratio of the compliance of a contact with partial slip, at a share of full slip below one, to that without
/// slip.
using PartialSlip = std::function<double(double share)>;
/// Sliding (Mindlin & Deresiewicz 1953): delta/(Q/k) = 3/(2 q) (1 - (1 - q)^(2/3)), q the share.
double sliding_partial_slip(double share);
/// Torsion (Lubkin 1951).
double torsion_partial_slip(double share);
/// Nothing is known: the secant.
inline double no_partial_slip(double) { return 1; }

/// From the first two steps after each reversal, corrected for partial slip at half the size (Masing) and
/// extrapolated to the turning point; the error is what the extrapolation adds. NaN without a reversal after
/// full slip.
ReversalStiffness reversal_stiffness(const std::vector<double>& position,
                                     const std::vector<double>& resistance, double full_slip,
                                     const PartialSlip& partial_slip);

}  // namespace asperity

// What a motion with reversals (sliding, rolling or torsion) says about its contact: the steady resistance
// after full slip, how it fluctuates along the way, how well its mean is known, and the stiffness after a
// reversal. SI units. Neighbouring places of a way feel the same asperities: N values count as N_eff = N/(1 +
// 2 sum (1 - k/N) rho_k) independent ones, rho_k the autocorrelation summed until it first vanishes (Bartlett
// 1946; Geyer 1992), and the mean is known to s/(N_eff - 1)^(1/2). Holds for a way of many correlation
// lengths; `drift` tells if the resistance still changes.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace asperity {

/// Rows between two reversals; the first is the turning point.
struct MotionLeg {
  std::size_t first = 0, last = 0;
  int direction = 1;
};
/// Rows that do not move belong to no leg or stay inside of one.
std::vector<MotionLeg> motion_legs(const std::vector<double>& position);

/// Mean of a correlated series, and what is known about it.
struct CorrelatedMean {
  double mean = 0, sd = 0;    ///< sd of the values
  double standard_error = 0;  ///< of the mean
  double independent = 0;     ///< N_eff
};
/// Of values at equal distances; needs two or more.
CorrelatedMean correlated_mean(const std::vector<double>& values);

struct SteadyResistance {
  double mean = 0;            ///< against the motion [N] or [N m]
  double fluctuation = 0;     ///< standard deviation along the way
  double standard_error = 0;  ///< of the mean
  double independent = 0;     ///< stretches that count as independent
  double way = 0;             ///< after full slip, of all legs [m] or [rad]
  double drift = 0;  ///< relative: mean of the second half of the way less that of the first, over the mean
  double drift_error = 0;  ///< of drift
  double load = 0;         ///< mean normal force there [N]
  bool reached = false;    ///< full slip was reached and followed by a stretch long enough

  bool still_changes() const;
};

/// Full slip begins where the resistance has stopped to grow: its slope fell below a fiftieth of the first.
/// Legs count as independent: there and back the slopes of asperities push in opposite directions.
SteadyResistance steady_resistance(const std::vector<double>& position, const std::vector<double>& resistance,
                                   const std::vector<double>& normal_force);

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

// From a series of lateral against normal forces to a friction coefficient and its offset, and the mean over
// two contacts. Fuchs, Weinhart et al. (2014), eq:fs1 to eq:barhro: a sphere that rolls between substrate s
// and indenter i needs
//   f_l = mu_bar (lambda_bar/r_bar) (f + h_bar),   mu_bar = (mu_s lambda_s + mu_i lambda_i)/(2 lambda_bar),
//   h_bar = (mu_s lambda_s h_s + mu_i lambda_i h_i)/(mu_s lambda_s + mu_i lambda_i).
// (eq:barhro is printed with mu_s in front of the fraction in place of inside: for equal contacts (1 + mu)/2
// of the offset.)
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "dem_compare/numbers/uncertain.h"

namespace asperity {

/// One measurement; sd NaN: not known.
struct FrictionPoint {
  double normal_force = 0;  ///< [N]
  Uncertain lateral_force;  ///< [N]
};

/// Columns normal_force, lateral_force and, where it is known, lateral_force_sd, with their units in
/// brackets. Throws InputError.
std::vector<FrictionPoint> read_friction_series(const std::filesystem::path& file);

/// Straight line through the limits of a series.
struct FrictionFit {
  Uncertain coefficient;   ///< mu
  Uncertain offset;        ///< h [N]
  double correlation = 0;  ///< of both [-]
  double chi2_reduced =
      0;  ///< 1 where the points have no sd of their own: then the residuals say what it is [-]
};

/// Weighted least squares of f_l = mu s(f) (f + h); s = lambda/r of the load, 1 for lambda = r. Linear in mu
/// and mu h. Throws InputError for fewer than three points.
FrictionFit fit_friction(const std::vector<FrictionPoint>& series,
                         const std::function<double(double)>& scale);

/// mu lambda [m] and h [N] of one contact.
struct RollingContact {
  double factor = 0, offset = 0;
};
/// Mean factor (mu_s lambda_s + mu_i lambda_i)/2 and offset h_bar.
RollingContact mean_rolling(const RollingContact& substrate, const RollingContact& indenter);

}  // namespace asperity

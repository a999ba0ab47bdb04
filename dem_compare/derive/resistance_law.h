// The yield limit of a mode of motion, R = mu lambda(f) (f + h) (Luding 2008; Fuchs, Weinhart et al. 2014,
// sec. 3.2), fitted to the steady resistances of solved cases, and how well they tell two lengths lambda
// apart. Linear in (mu, mu h). SI units. Variance of a case: what the path leaves open, plus a relative
// scatter from case to case, plus one that all cases of a realisation share; both are estimated by restricted
// maximum likelihood (Patterson & Thompson 1971), the first to be a thousandth (what a solved case is good
// for) at least. Where paths tell more than that, the uncertainty is on the large side.
#pragma once

#include <Eigen/Dense>
#include <limits>
#include <string>
#include <vector>

#include "engines/parameters/contact_parameters.h"

namespace asperity {

/// Steady resistance of one case.
struct ResistancePoint {
  double load = 0;             ///< f [N]
  double value = 0;            ///< [N] or [N m]
  double sd = 0;               ///< of the mean over the path
  std::string realisation;     ///< the same for the same surfaces
  double particle_radius = 0;  ///< r [m]
  double contact_radius = 0;   ///< a(f) [m]

  /// lambda; 1 for sliding (LengthScale::none).
  double length(LengthScale scale) const;
};

struct ResistanceLaw {
  double coefficient = 0;                                ///< mu
  double offset = 0;                                     ///< h [N]; 0 where it cannot be told
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< of (mu, h)
  bool has_offset = false;                               ///< two loads or more
  double case_scatter = 0;                               ///< relative, beyond what the path leaves open
  double realisation_scatter = 0;  ///< relative, common to all cases of a realisation; 0 for a single one
  double misfit = 0;               ///< root mean square, relative
  int degrees_of_freedom = 0;      ///< cases less fitted numbers; 0: the law passes through them untested
  LoadRange loads;

  /// Standard deviations of mu [-] and h [N].
  double coefficient_sd() const { return std::sqrt(covariance(0, 0)); }
  double offset_sd() const { return std::sqrt(covariance(1, 1)); }
  /// The limit at a point's load, in the unit of the resistance.
  double at(const ResistancePoint& point, LengthScale scale) const {
    return coefficient * point.length(scale) * (point.load + offset);
  }
};

/// Different loads, ascending; closer than a thousandth counts as one.
std::vector<double> distinct_loads(const std::vector<ResistancePoint>& points);

/// Throws InputError without a point.
ResistanceLaw fit_resistance(const std::vector<ResistancePoint>& points, LengthScale scale);

/// Natural logarithm of the marginal likelihood of the law with that length. Priors, the same for every
/// length: at the geometric mean load f0, mu lambda f0 and mu lambda h are normal about zero with the sd of
/// the mean resistance (so h is of the order of f0 or less); both relative scatters are log-uniform between a
/// thousandth and one.
double log_evidence(const std::vector<ResistancePoint>& points, LengthScale scale);

/// Root mean square relative error when each contact (load and radius) in turn is predicted from the others;
/// NaN for fewer than three loads.
double leave_one_out(const std::vector<ResistancePoint>& points, LengthScale scale);

}  // namespace asperity

// Exponential decay with roughness, y = b + c exp(-Delta/d) (Fuchs, Weinhart et al. 2014, eq:murofit;
// eq:frofit with c < 0). Units: those of y for b and c, of Delta for d. Through three points it is exact;
// beyond them it only extrapolates.
// Pure numbers: b and c have the unit of y, d that of Delta.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "dem_compare/numbers/uncertain.h"

namespace asperity {

struct ExponentialLaw {
  double b = 0, c = 0, d = 1;

  double operator()(double x) const { return b + c * std::exp(-x / d); }
};

/// Parameters with their uncertainties.
struct ExponentialFit {
  ExponentialLaw law;
  Uncertain b, c, d;
  Eigen::Matrix3d covariance;  ///< of b, c, d, from the sds of x and y to first order
  double chi2 = 0;             ///< of y alone; zero for three points

  /// The law at a place with its own uncertainty, both propagated.
  Uncertain at(const Uncertain& x) const;
};

/// Least squares weighted by the sd of y. Throws InputError for fewer than three points, and WorkError where
/// no decaying exponential goes through them.
ExponentialFit fit_exponential(const std::vector<Uncertain>& x, const std::vector<Uncertain>& y);

}  // namespace asperity

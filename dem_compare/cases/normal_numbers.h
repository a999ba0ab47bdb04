// From a history of normal loading and unloading to the numbers an experimenter compares: stiffness, what a
// Hertz fit would report, imprint, and the ratio to Hertz at each load.
#pragma once

#include <vector>

#include "core/hertz.h"
#include "results/history.h"

namespace asperity {

/// dF/d(delta) at a step.
struct TangentStiffness {
  double force = 0;      ///< [N]
  double approach = 0;   ///< [m]
  double stiffness = 0;  ///< [N/m]
  double error = 0;      ///< bound from a stencil of twice the width [N/m]; NaN with too few steps
};

/// Along one branch, in its order. Differentiates F^(2/3) by parabolas through three steps, so that a
/// Hertzian branch (with any offset) comes out exact however coarse its steps. Empty for fewer than three
/// steps under load.
std::vector<TangentStiffness> tangent_stiffness(const std::vector<double>& approach,
                                                const std::vector<double>& force);

/// Stiffness at a load, interpolated over F^(1/3) (a straight line for Hertz); NaN outside of the branch.
/// force [N]; the result in [N/m].
double stiffness_at(const std::vector<TangentStiffness>& branch, double force);

/// A fitted number with its standard error, both in its unit.
struct FittedNumber {
  double value = 0, standard_error = 0;
};

/// F = (4/3) E* R_fit^(1/2) (delta - offset)^(3/2): what the paper's "simple Hertzian fit" reports (9 um for
/// a sphere of 8.5). Least squares in force over the first loading, as on a load-displacement plot.
struct RadiusFit {
  FittedNumber radius;      ///< R_fit [m]
  FittedNumber offset;      ///< [m]; 0 if not fitted
  double relative_rms = 0;  ///< root mean square misfit over the largest force [-]
};
/// F = F_max ((delta - offset)/(delta_max - offset))^exponent c.
struct ExponentFit {
  FittedNumber exponent;    ///< 3/2 for Hertz
  FittedNumber offset;      ///< [m]; 0 if not fitted
  double relative_rms = 0;  ///< as above [-]
};
/// approach [m], force [N], E* [Pa].
RadiusFit fit_radius(const std::vector<double>& approach, const std::vector<double>& force,
                     double reduced_modulus, bool with_offset);
ExponentFit fit_exponent(const std::vector<double>& approach, const std::vector<double>& force,
                         bool with_offset);

/// A step of the first loading, and its ratios to Hertz for the same bodies, smooth and elastic.
struct LoadPoint {
  double force = 0;                ///< [N]
  double approach = 0;             ///< [m]
  double stiffness = 0;            ///< tangent of loading [N/m]
  double step_error = 0;           ///< bound on it from the finite load steps [N/m]
  double unloading_stiffness = 0;  ///< tangent of the first unloading at the same load [N/m]
  double contact_area = 0;         ///< real [m^2]
  double mean_pressure = 0;        ///< load over real area [Pa]
  double largest_pressure = 0;     ///< [Pa]
  double plastic_volume = 0;       ///< [m^3]
  /// Ratios [-].
  double force_ratio =
      0;  ///< F over Hertz's at the same approach; depends on where the approach is counted from
  double stiffness_ratio = 0;  ///< k over Hertz's at the same force [-]
  double unloading_ratio = 0;  ///< that of unloading [-]
  double area_ratio = 0;       ///< real contact area over Hertz's at the same force [-]
  double pressure_ratio = 0;   ///< largest pressure over Hertz's at the same force [-]
};

struct NormalNumbers {
  double largest_force = 0;                                     ///< [N]
  double approach_there = 0;                                    ///< [m]
  std::vector<TangentStiffness> loading, unloading, reloading;  ///< first of each; those not there are empty
  /// Approach that has not come back at the end of the first unloading: beyond that of the first loading at
  /// the same, last force [m]; NaN without unloading.
  double residual_imprint = 0;
  double imprint_force = 0;      ///< that force [N]
  double plastic_volume = 0;     ///< at the end [m^3]
  double dissipated_energy = 0;  ///< at the end [J]
  bool has_fits = false;
  RadiusFit radius, radius_with_offset;
  ExponentFit exponent, exponent_with_offset;
  std::vector<LoadPoint> loads;  ///< steps of the first loading

  /// Start of unloading; NaN without one.
  /// In [N/m].
  double unloading_stiffness() const;
  double loading_stiffness() const;
  /// A number of LoadPoint at a load, linear between the steps; NaN outside of them.
  /// force [N]; the result in the number's unit.
  double at_load(double force, double LoadPoint::*member) const;
};

/// The contact bears the load and `attraction` [N], a force that does not change (Derjaguin, Muller & Toporov
/// 1975): fits and ratios are of their sum; the forces named above are loads.
NormalNumbers normal_numbers(const History& history, const Hertz& hertz, double attraction = 0);

}  // namespace asperity

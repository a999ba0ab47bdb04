// What a profiler reports of a height map (names of ISO 25178-2), and whether its heights are Gaussian.
#pragma once

#include <string>

#include "surfaces/topography.h"

namespace asperity {

/// Heights z are counted from the mean of the known points; the map is taken as it is (level it first).
struct HeightMoments {
  double Sq = 0;   ///< root mean square height [m]
  double Sa = 0;   ///< mean absolute height [m]
  double Sz = 0;   ///< highest minus lowest point (peak to valley) [m]
  double Ssk = 0;  ///< skewness <z^3>/Sq^3 [-]
  double Sku = 0;  ///< kurtosis <z^4>/Sq^4 [-], 3 for Gaussian heights
};

/// Throws InputError if no point is known.
HeightMoments height_moments(const Topography& map);

/// Moments of the heights, slope and correlation length.
struct HeightStatistics : HeightMoments {
  /// (<(dz/dx)^2> + <(dz/dy)^2>)^(1/2), from differences of neighbouring pixels [-]
  double rms_slope = 0;
  /// root mean square of the mean curvature (d2z/dx2 + d2z/dy2)/2, from second differences [1/m]
  double rms_curvature = 0;
  /// distance at which the radially averaged autocorrelation falls to 1/e [m]; NaN if it does not within half
  /// the map
  double correlation_length = 0;
};

struct Autocorrelation;

/// Of all known points; with the map's autocorrelation where it is at hand.
HeightStatistics height_statistics(const Topography& map);
HeightStatistics height_statistics(const Topography& map, const Autocorrelation& correlation);

/// Jarque and Bera's test (1987) with the variances that skewness and kurtosis have for a *correlated*
/// Gaussian field: var(Ssk) = 6 <rho^3>, var(Sku) = 24 <rho^4>, means of powers of the autocorrelation over
/// all pairs of points (leading order, from the orthogonality of Hermite polynomials of correlated normal
/// variables; Lomnicki 1961, Metrika 4, 37).
struct GaussianTest {
  double skewness_error = 0;  ///< standard error of Ssk if heights are Gaussian [-]
  double kurtosis_error = 0;  ///< standard error of Sku if heights are Gaussian [-]
  double independent_samples =
      0;  ///< 1/<rho^2>: as many independent heights would determine Sq^2 as well [-]
  double p_value =
      0;  ///< chance that a Gaussian surface departs as far (chi squared, 2 degrees of freedom) [-]
  enum class Verdict { consistent, not_gaussian, too_few_samples } verdict = Verdict::consistent;
  std::string sentence;  ///< the verdict in words
};

/// The test of a map's heights; with its autocorrelation where it is at hand.
GaussianTest gaussian_test(const Topography& map);
GaussianTest gaussian_test(const Topography& map, const Autocorrelation& correlation);

}  // namespace asperity

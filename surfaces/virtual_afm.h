// The roughness of a model surface as a microscope would report it: windows of the scan's size and pixels out
// of a larger surface, linear tilt removed from each, mean over the windows. The tilt takes the long waves
// with it, so that the reported Sq lies below that of the surface.
#pragma once

#include <cstdint>
#include <vector>

#include "surfaces/levelling.h"
#include "surfaces/spectrum_model.h"
#include "surfaces/tip.h"
#include "surfaces/topography.h"

namespace asperity {

/// How roughness was measured. The default is that of the paper's silicon surfaces: five scans of 2.5 um and
/// 512 x 512 pixels, "simple linear tilt correction".
struct AfmSettings {
  double size = 2.5e-6;  ///< side of a scan [m]
  int pixels = 512;      ///< along a side
  int windows = 5;       ///< scans whose values are averaged
  Tip tip;               ///< sharp unless it has a radius
};

/// A number measured in several windows.
struct WindowMean {
  double mean = 0,
         sd = 0;  ///< mean over the windows, standard deviation of one window; in the unit of the number
};

/// What the microscope reports.
struct AfmMeasurement {
  WindowMean Sq, Sz;      ///< [m]
  WindowMean Ssk, Sku;    ///< [-]
  WindowMean profile_Sz;  ///< peak to valley of single rows of the levelled windows, mean over rows [m]
};

/// The periodic grid the windows are cut from. Period: at least four scans and four roll-offs; pixels: the
/// scan's, or that divided by `stride` where the cut-off or the tip needs finer ones.
struct AfmGrid {
  int pixels = 0, stride = 1;
  double period = 0;
};
/// Pixels and period of the larger surface. Throws InputError where it needs too many pixels.
AfmGrid afm_grid(const SelfAffineSpectrum& spectrum, const AfmSettings& afm);

/// One realisation of the larger surface, expected Sq = spectrum.rms over its period.
Topography afm_surface(const SelfAffineSpectrum& spectrum, const AfmSettings& afm, std::uint64_t seed);

/// The levelled windows of such a surface: afm.windows of them, spread over the period.
std::vector<Topography> afm_windows(const Topography& surface, const AfmSettings& afm);
/// As many as fit side by side.
std::vector<Topography> all_afm_windows(const Topography& surface, const AfmSettings& afm);

/// Statistics over such windows.
AfmMeasurement measure(const std::vector<Topography>& windows);

/// Expectation of the measured Sq of one window without tip, from the spectrum alone: a wave of the surface
/// contributes its mean square less the share that its projection onto the plane {1, x, y} of the window has;
/// Sq itself lies below the root of the mean square by its scatter, which is that of a gamma variable with
/// var(Sq^2) = 2 <R^2> over all pairs of points of the window, R the autocovariance.
struct ExpectedSq {
  double mean = 0;         ///< <Sq> [m]
  double sd = 0;           ///< standard deviation of one window's Sq [m]
  double mean_square = 0;  ///< <Sq^2> [m^2]
};
/// Throws InputError where no wave of the spectrum fits into the scan.
ExpectedSq expected_measured_Sq(const SelfAffineSpectrum& spectrum, const AfmSettings& afm);

/// The spectrum scaled so that the expected measured Sq is `target` [m]. With a tip, by iteration on
/// `realisations` surfaces (dilation is not linear in height).
/// Throws InputError for a target not above 0, WorkError where no amplitude reaches it.
SelfAffineSpectrum calibrated(SelfAffineSpectrum spectrum, double target, const AfmSettings& afm,
                              int realisations = 4);

/// Distance at which the autocorrelation of the unbounded surface falls to 1/e [m] (Wiener-Khinchin, Hankel
/// transform).
double correlation_length(const SelfAffineSpectrum& spectrum);

}  // namespace asperity

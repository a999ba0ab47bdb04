// Which Gaussian surfaces could have given a published pair of roughness numbers, RMS and peak to valley,
// both measured by the same scans. Their ratio falls as the correlation length grows (fewer independent
// heights, fewer extremes), whatever the amplitude: it bounds the correlation length, and some ratios no
// Gaussian surface can have.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "surfaces/virtual_afm.h"

namespace asperity {

/// What virtual scans of surfaces with one roll-off give; ratios hold for any amplitude (sharp tip).
struct RatioPoint {
  double rolloff = 0;             ///< wavelength [m]
  double correlation_length = 0;  ///< of the unbounded surface, 1/e [m]
  double ratio = 0;               ///< mean peak to valley of a window / mean Sq [-]
  double ratio_sd = 0;            ///< standard deviation of that ratio for the mean of afm.windows windows
  double profile_ratio = 0;       ///< the same with the peak to valley of single rows [-]
};

/// Points of increasing roll-off for one Hurst exponent.
struct RatioCurve {
  double hurst = 0, cutoff = 0;  ///< exponent [-], short cut-off wavelength [m]
  std::vector<RatioPoint> points;
  /// Interpolated linearly in ln(rolloff) between the points.
  /// rolloff [m].
  RatioPoint at(double rolloff) const;
};

/// Which spectra are tried.
struct RatioOptions {
  std::vector<double> hursts{0.6, 0.8, 1.0};
  double cutoff = 20e-9;        ///< short cut-off wavelength [m]
  double shortest_rolloff = 0;  ///< [m]; 0: 2.5 cut-offs
  double longest_rolloff = 0;   ///< [m]; 0: two scans, beyond which a scan sees no roll-off
  int points = 7;               ///< roll-offs per Hurst exponent
  int windows = 32;             ///< fewest windows averaged per point
  std::uint64_t seed = 1;
};

/// Monte Carlo over virtual scans.
/// Throws InputError for fewer than two points or windows, or no range of roll-offs.
std::vector<RatioCurve> ratio_curves(const AfmSettings& afm, const RatioOptions& options);

/// Published numbers with their uncertainties [m].
struct PublishedRoughness {
  double rms = 0, rms_error = 0;
  double peak_to_valley = 0, peak_to_valley_error = 0;
};

/// Lengths between which spectra fit; empty if lower > upper. open: the end is that of the roll-offs tried,
/// not a bound.
struct LengthRange {
  /// Both in [m].
  double lower = 1, upper = 0;
  bool open_below = false, open_above = false;
  bool empty() const { return lower > upper; }
};

/// One spectrum that fits, scaled so that scans show `measured_rms` [m]: the published RMS or, where only the
/// uncertainties allow it, the nearest to it.
struct PossibleSpectrum {
  SelfAffineSpectrum spectrum;
  double measured_rms = 0;
};

/// What fits, and the sentence that says so.
struct PossibleSpectra {
  PublishedRoughness published;
  /// Pure numbers [-].
  double ratio = 0, lowest_ratio = 0,
         highest_ratio = 0;  ///< peak to valley over RMS, and its limits by the uncertainties
  double least_possible = 0, most_possible = 0;  ///< ratios of all curves, two standard deviations included
  /// roll-off and correlation length for which the published means themselves can hold (95 % of sets of
  /// windows), and for which they can within their uncertainties
  LengthRange rolloff_of_means, correlation_of_means, rolloff_within_errors, correlation_within_errors;
  /// the same within the uncertainties if peak to valley was read from a single profile instead of the whole
  /// scan
  LengthRange correlation_of_profiles;
  /// for each Hurst exponent that fits, the shortest, a middle and the longest roll-off (of the means; within
  /// errors if they cannot hold)
  std::vector<PossibleSpectrum> examples;
  std::string sentence;
};

/// The curves read at the published ratio. Throws InputError for published numbers not above 0, and without
/// curves.
PossibleSpectra possible_spectra(const PublishedRoughness& published, const AfmSettings& afm,
                                 const std::vector<RatioCurve>& curves);

}  // namespace asperity

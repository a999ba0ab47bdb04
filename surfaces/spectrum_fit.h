// The self-affine model fitted to a measured radial spectrum: Hurst exponent, roll-off and cut-off with
// uncertainties.
//
// ln C(q) is level below the roll-off q_r and falls with slope -2 - 2H in ln q up to the cut-off q_s. Each
// ring's mean of n periodograms is gamma distributed around the model M, so the line is the maximum of
// Whittle's likelihood,
// - sum n (C/M + ln M) (Whittle 1953, Ark. Mat. 2, 423), found by Fisher scoring. The knees are searched for
// the least cost D/phi + N ln phi of the line's N rings, with deviance D = 2 sum n (C/M - 1 - ln C/M) and
// misfit phi = max(1, D/N) (extended quasi-likelihood, Nelder and Pregibon 1987, Biometrika 74, 221). Rings
// beyond q_s follow a straight line of their own (noise), or are left out one by one (leakage of the window).
// Each freedom so taken must pay for itself by the Bayesian information criterion, ln(number of rings)
// (Schwarz 1978, Ann. Stat. 6, 461).
#pragma once

#include <string>

#include "surfaces/spectrum.h"

namespace asperity {

/// Parameters of the model, and the wavelengths that gave them.
struct SpectrumFit {
  /// With its standard error.
  struct Number {
    double value = 0, error = 0;  ///< in the unit of the number
  };
  Number hurst;  ///< Hurst exponent [-]; not forced into (0, 1)
  bool has_rolloff = false;
  Number rolloff;  ///< wavelength 2 pi / q_r [m] if seen
  bool has_cutoff = false;
  Number cutoff;  ///< wavelength 2 pi / q_s [m] below which C lies under the self-affine line, if seen
  bool has_noise = false;
  Number noise;    ///< wavelength [m] below which C lies above the self-affine line (noise), if seen
  double rms = 0;  ///< Sq of the rings [m]
  /// phi of the self-affine line: 1 for an isotropic self-affine surface; errors are already widened by its
  /// square root
  /// [-].
  double misfit = 0;
  double shortest = 0, longest = 0;  ///< wavelengths fitted [m]

  /// One or two sentences with the numbers, or what the scan is too small to show.
  std::string sentence() const;
};

/// Fits the rings from twice the fundamental wave number (levelling takes from the first) to the Nyquist wave
/// number. Throws InputError if there are fewer than 16 rings.
SpectrumFit fit_spectrum(const RadialSpectrum& spectrum);

}  // namespace asperity

// The power spectral density of self-affine roughness; conventions: surfaces/spectrum_model.h.
#pragma once

namespace asperity {

/// Self-affine roughness with a flat roll-off: C = C0 for q < q_r, C0 (q/q_r)^(-2-2H) for q_r <= q <= q_s, 0
/// beyond. (Persson et al. 2005, J. Phys.: Condens. Matter 17, R1.)
struct SelfAffineSpectrum {
  double rms = 0;      ///< Sq of the unbounded surface [m]
  double hurst = 0.8;  ///< Hurst exponent H [-], 0 < H <= 1
  double rolloff = 0;  ///< roll-off wavelength 2 pi / q_r [m]
  double cutoff = 0;   ///< short cut-off wavelength 2 pi / q_s [m]

  /// C(q) [m^4]
  double operator()(double q) const;
  /// C0 [m^4] for `rms`; the roll-off's share is kept: leaving it out would overshoot Sq by sqrt(1 + H).
  double plateau() const;
  /// <|grad h|^2>^(1/2) of the unbounded surface [-]; the short waves carry it.
  double rms_slope() const;
  /// Throws InputError naming the entry that is out of range.
  void check() const;
};

}  // namespace asperity

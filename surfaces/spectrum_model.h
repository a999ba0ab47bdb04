// Models of the isotropic power spectral density C(q) of a height field.
//
// Convention (Jacobs, Junge, Pastewka 2017, Surf. Topogr.: Metrol. Prop. 5, 013001): C(q) = lx ly <|a_q|^2>
// in m^4 with h(x) = sum_q a_q exp(i q x); hence Sq^2 = (2 pi)^-2 int C d^2q = (2 pi)^-1 int q C(q) dq, and
// on a periodic domain Sq^2 = sum_q C(|q|) / (lx ly). Wave numbers q = 2 pi / wavelength in rad/m.
#pragma once

#include <functional>
#include <vector>

namespace asperity {

/// C(q) [m^4] at a wave number q [rad/m].
using Spectrum = std::function<double(double)>;

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

/// Measured C(q), interpolated linearly in log C over log q; constant below the first wave number, 0 above
/// the last.
struct TabulatedSpectrum {
  std::vector<double> q;  ///< increasing wave numbers [rad/m]
  std::vector<double> C;  ///< [m^4], positive
  double operator()(double wave_number) const;
};

}  // namespace asperity

// Models of the isotropic power spectral density C(q) of a height field.
//
// Convention (Jacobs, Junge, Pastewka 2017, Surf. Topogr.: Metrol. Prop. 5, 013001): C(q) = lx ly <|a_q|^2>
// in m^4 with h(x) = sum_q a_q exp(i q x); hence Sq^2 = (2 pi)^-2 int C d^2q = (2 pi)^-1 int q C(q) dq, and
// on a periodic domain Sq^2 = sum_q C(|q|) / (lx ly). Wave numbers q = 2 pi / wavelength in rad/m.
#pragma once

#include <functional>
#include <vector>

#include "core/self_affine_spectrum.h"

namespace asperity {

/// C(q) [m^4] at a wave number q [rad/m].
using Spectrum = std::function<double(double)>;

/// Measured C(q), interpolated linearly in log C over log q; constant below the first wave number, 0 above
/// the last.
struct TabulatedSpectrum {
  std::vector<double> q;  ///< increasing wave numbers [rad/m]
  std::vector<double> C;  ///< [m^4], positive
  double operator()(double wave_number) const;
};

}  // namespace asperity

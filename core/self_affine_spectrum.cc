#include "core/self_affine_spectrum.h"

#include <cmath>

#include "core/error.h"
#include "core/quantity.h"

namespace asperity {

double SelfAffineSpectrum::plateau() const {
  const double q_r = 2 * M_PI / rolloff;
  // (2 pi) Sq^2 = C0 q_r^2 [1/2 + (1 - (q_s/q_r)^(-2H)) / (2H)]
  return 2 * M_PI * rms * rms /
         (q_r * q_r * (0.5 + (1 - std::pow(cutoff / rolloff, 2 * hurst)) / (2 * hurst)));
}

double SelfAffineSpectrum::rms_slope() const {
  const double q_r = 2 * M_PI / rolloff, ratio = rolloff / cutoff;
  // (2 pi) <|grad h|^2> = int q^3 C dq = C0 q_r^4 [1/4 + ((q_s/q_r)^(2-2H) - 1) / (2-2H)], the logarithm for
  // H = 1
  const double exponent = 2 - 2 * hurst;
  const double falling = exponent == 0 ? std::log(ratio) : (std::pow(ratio, exponent) - 1) / exponent;
  return std::sqrt(plateau() * std::pow(q_r, 4) * (0.25 + falling) / (2 * M_PI));
}

double SelfAffineSpectrum::operator()(double q) const {
  const double q_r = 2 * M_PI / rolloff, q_s = 2 * M_PI / cutoff;
  constexpr double rounding =
      1e-9;  // a wave as long as the cut-off belongs to the surface, however its wave number was computed
  if (q > q_s * (1 + rounding)) return 0;
  return q < q_r ? plateau() : plateau() * std::pow(q / q_r, -2 - 2 * hurst);
}

void SelfAffineSpectrum::check() const {
  if (!(rms >= 0) || !std::isfinite(rms)) throw InputError("rms must be a length, zero or larger");
  if (!(hurst > 0 && hurst <= 1)) throw InputError("hurst must lie between 0 and 1 (0.8 is common)");
  if (!(cutoff > 0) || !std::isfinite(cutoff))
    throw InputError("cutoff must be a wavelength larger than zero");
  if (!(rolloff >= cutoff) || !std::isfinite(rolloff))
    throw InputError("rolloff (" + format_quantity(rolloff, Dimension::length) +
                     ") must be a wavelength not shorter than cutoff (" +
                     format_quantity(cutoff, Dimension::length) + ")");
}

}  // namespace asperity

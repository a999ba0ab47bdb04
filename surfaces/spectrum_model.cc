#include "surfaces/spectrum_model.h"

#include <algorithm>
#include <cmath>

namespace asperity {

double TabulatedSpectrum::operator()(double wave_number) const {
  if (q.empty() || wave_number > q.back()) return 0;
  if (wave_number <= q.front()) return C.front();
  const std::size_t upper = std::lower_bound(q.begin(), q.end(), wave_number) - q.begin();
  const double t = std::log(wave_number / q[upper - 1]) / std::log(q[upper] / q[upper - 1]);
  return std::exp((1 - t) * std::log(C[upper - 1]) + t * std::log(C[upper]));
}

}  // namespace asperity

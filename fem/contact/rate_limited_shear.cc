#include "fem/contact/rate_limited_shear.h"

#include <algorithm>
#include <cmath>

namespace asperity::fem {

Shear return_to_rate(const FrictionLaw& law, const InterfacePoint& point, const double* history,
                     const PlaneVector& trial, double penalty) {
  const double size = std::hypot(trial[0], trial[1]);
  if (size == 0 || !(point.pressure > 0)) return return_to_limit(trial, 0);
  InterfacePoint moved = point;
  const auto limit_after = [&](double slip) {
    moved.slip = {slip, 0}, moved.slip_path = point.slip_path + slip;
    moved.slip_rate = slip / point.time_step;
    return law.limit(moved, history).stress;
  };
  // The slip grows by decades with the traction: its logarithm is halved.
  constexpr double slowest = 1e-30;  // share of the largest slip
  double low = std::log(slowest), high = 0;
  const double largest = size / penalty;
  constexpr double close = 1e-10;
  while (high - low > close) {
    const double middle = 0.5 * (low + high), slip = largest * std::exp(middle);
    (limit_after(slip) + penalty * slip > size ? high : low) = middle;
  }
  const double slip = largest * std::exp(low), limit = size - penalty * slip;
  constexpr double apart = 1e-4;  // of the slip, for the derivative
  const double growth = (limit_after(slip * (1 + apart)) - limit_after(slip)) / (slip * apart);
  const double along = growth > 0 ? growth / (growth + penalty) : 0, share = limit / size,
               nx = trial[0] / size, ny = trial[1] / size;
  return {{share * trial[0], share * trial[1]},
          share * ny * ny + along * nx * nx,
          (along - share) * nx * ny,
          share * nx * nx + along * ny * ny,
          true,
          along};
}

}  // namespace asperity::fem

#include "core/hertz.h"

#include <boost/math/tools/minima.hpp>
#include <limits>

namespace asperity {

SubsurfaceMaximum hertz_subsurface_maximum(double poisson_ratio) {
  // The maximum lies between 0.38 (nu = 0) and 0.55 (nu = 1/2); a parabola near it is flat to half the
  // digits.
  const auto minimum = boost::math::tools::brent_find_minima(
      [&](double z) { return -hertz_axis_stress(z, poisson_ratio).von_mises(); }, 0.2, 1.0,
      std::numeric_limits<double>::digits / 2);
  return {minimum.first, -minimum.second};
}

}  // namespace asperity

#include "fem/mortar/coupling.h"

namespace asperity::fem {

SurfaceDisplacement mean_surface_displacement(const std::vector<std::array<double, 3>>& place,
                                              const std::vector<double>& weight,
                                              const std::array<std::vector<double>, 2>& along) {
  double total = 0, x = 0, y = 0;
  SurfaceDisplacement mean;
  for (std::size_t k = 0; k < weight.size(); ++k) {
    total += weight[k];
    x += weight[k] * place[k][0], y += weight[k] * place[k][1];
    mean.x += weight[k] * along[0][k], mean.y += weight[k] * along[1][k];
  }
  if (total <= 0) return {};
  x /= total, y /= total, mean.x /= total, mean.y /= total;
  double turning = 0, spread = 0;
  for (std::size_t k = 0; k < weight.size(); ++k) {
    const double dx = place[k][0] - x, dy = place[k][1] - y;
    turning += weight[k] * (dx * (along[1][k] - mean.y) - dy * (along[0][k] - mean.x));
    spread += weight[k] * (dx * dx + dy * dy);
  }
  if (spread > 0) mean.turn = turning / spread;
  // The turn is about the axis, not about the middle of the weights.
  mean.x += mean.turn * y, mean.y -= mean.turn * x;
  return mean;
}

}  // namespace asperity::fem

#include "surfaces/tip.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace asperity {
namespace {

struct Offset {
  int x, y;
  double height;  ///< of the tip above its apex [m]
};

/// Pixels of the tip that can touch a surface with this range of heights, the apex first.
std::vector<Offset> tip_pixels(const Tip& tip, double dx, double dy, double range) {
  const bool spherical = tip.shape == Tip::Shape::spherical;
  double reach = std::sqrt(2 * tip.radius * range);
  if (spherical) reach = range < tip.radius ? std::sqrt(range * (2 * tip.radius - range)) : tip.radius;
  std::vector<Offset> pixels;
  const int nx = static_cast<int>(reach / dx), ny = static_cast<int>(reach / dy);
  for (int y = -ny; y <= ny; ++y)
    for (int x = -nx; x <= nx; ++x) {
      const double u2 = x * dx * x * dx + y * dy * y * dy;
      if (u2 > reach * reach) continue;
      pixels.push_back(
          {x, y, spherical ? tip.radius - std::sqrt(tip.radius * tip.radius - u2) : u2 / (2 * tip.radius)});
    }
  return pixels;
}

}  // namespace

Topography dilated(const Topography& surface, const Tip& tip) {
  if (!(tip.radius > 0)) return surface;
  const auto [lowest, highest] = std::minmax_element(surface.heights.begin(), surface.heights.end());
  const auto pixels = tip_pixels(tip, surface.dx(), surface.dy(), *highest - *lowest);
  Topography image = surface;
#pragma omp parallel for schedule(static)
  for (int iy = 0; iy < surface.ny; ++iy)
    for (const Offset& offset : pixels) {
      int y = iy + offset.y;
      if (surface.periodic) y = (y % surface.ny + surface.ny) % surface.ny;
      if (y < 0 || y >= surface.ny) continue;
      const auto raise = [&](int ix, int x) {
        image.at(ix, iy) = std::max(image.at(ix, iy), surface.at(x, y) - offset.height);
      };
      const int first = std::max(0, -offset.x), last = std::min(surface.nx, surface.nx - offset.x);
      for (int ix = first; ix < last; ++ix) raise(ix, ix + offset.x);
      if (!surface.periodic) continue;
      for (int ix = 0; ix < first; ++ix) raise(ix, ix + offset.x + surface.nx);
      for (int ix = last; ix < surface.nx; ++ix) raise(ix, ix + offset.x - surface.nx);
    }
  return image;
}

}  // namespace asperity

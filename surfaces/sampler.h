// Heights of a topography between its pixels: quintic B-spline interpolation (Unser, Aldroubi, Eden 1993,
// IEEE Trans. Signal Process. 41, 821), which passes through every pixel and is four times continuously
// differentiable. A sine of four pixels per wavelength keeps its amplitude within 0.2 %, hence Sq to well
// within 1 %.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/topography_spec.h"
#include "surfaces/topography.h"

namespace asperity {

class HeightSampler {
 public:
  /// Missing pixels are first filled smoothly from their surroundings (surfaces/fill_missing.h).
  /// Throws InputError for a map without points or size.
  explicit HeightSampler(const Topography& map, Outside outside = Outside::refuse);

  /// Height [m] at (x, y) [m] from the centre of the map. Periodic maps continue periodically; beyond the
  /// edge of others throws InputError, or goes on mirrored if asked to. Safe to call from several threads.
  double height(double x, double y) const;

 private:
  int nx_, ny_;
  double lx_, ly_;
  bool periodic_;
  Outside outside_;
  std::string source_;
  std::vector<double> coefficients_;  ///< of the B-splines, [iy * nx + ix]

  void refuse(double x, double y) const;
};

}  // namespace asperity

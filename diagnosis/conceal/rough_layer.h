// A sphere on an elastic half-space that carries a layer of asperities, solved on rings (in the spirit of
// Greenwood & Tripp 1967, J. Appl. Mech. 34:153; pressure against gap after Persson 2007, Phys. Rev. Lett.
// 99:125502):
//   p(r) = P0 exp(-g(r)/l),   g(r) = s(r) + u(r) - delta,   u(r) = 4/(pi E*) int p(s) s/(r + s) K(k) ds,  k^2
//   = 4 r s/(r + s)^2.
// s(r): profile of the sphere; l: decay length of the layer; P0: pressure at which the mean planes meet. SI
// units.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "diagnosis/conceal/sphere.h"

namespace asperity::hidden {

class RoughLayer {
 public:
  /// Rings out to `reach`.
  RoughLayer(const Sphere& sphere, double decay_length, double pressure_at_zero_gap, double reach, int rings);
  /// Force at an approach of the mean planes; negative approaches count.
  /// [m] to [N]. Throws WorkError where the rings find no equilibrium.
  double force(double approach);
  /// Displacement of each ring's middle by unit pressure on each ring [m/Pa].
  const Eigen::MatrixXd& influence() const { return influence_; }
  const Eigen::VectorXd& areas() const { return area_; }

 private:
  double length_, pressure_;
  Eigen::VectorXd profile_, area_, log_pressure_;
  Eigen::MatrixXd influence_;
};

}  // namespace asperity::hidden

// What a sliding law remembers of its contact. Values: copy to try a step, keep the copy to accept it. SI
// units.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "dem_compare/laws/spring_slider.h"

namespace asperity {

/// Elastic shear displacement of the contact strip that the contact reached at the approach `depth`, see
/// mindlin_deresiewicz.h.
struct StripNode {
  double depth = 0;                                 ///< s = x^2/R [m]
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();  ///< u(s) [m]
};

struct SlidingHistory {
  SpringSlider<Eigen::Vector3d> spring;  ///< resistance [N]: what the particle is held back with
  std::vector<StripNode> profile;        ///< of Mindlin and Deresiewicz only

  /// The contact plane turned; its history turns with it.
  void rotate(const Eigen::Quaterniond& rotation) {
    spring.resistance = rotation * spring.resistance;
    for (auto& node : profile) node.shift = rotation * node.shift;
  }
};

}  // namespace asperity

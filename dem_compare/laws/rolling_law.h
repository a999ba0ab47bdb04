// Any of the rolling laws, as one value: a spring that yields at the law's limit. SI units.
#pragma once

#include "dem_compare/laws/any_law.h"
#include "dem_compare/laws/rotation_mode.h"

namespace asperity {

using RollingHistory = SpringSlider<Eigen::Vector3d>;  ///< resistance: moment [N m]

/// Rotations about axes in the contact plane.
struct RollingMode : RotationMode<RollingHistory, Eigen::Vector3d> {
  static constexpr const char* name = "rolling";
};

using RollingLaw = LawOf<RollingMode>;

}  // namespace asperity

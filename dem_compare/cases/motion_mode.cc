#include "dem_compare/cases/motion_mode.h"

namespace asperity {

const MotionMode& sliding_mode() {
  static const MotionMode mode{Motion::sliding,
                               "Sliding, f_l = mu (f + h)",
                               &History::lateral_displacement,
                               &History::lateral_force,
                               "N",
                               "lateral_stiffness",
                               "N/m",
                               "Experiment/Distance",
                               true,
                               false,
                               1,
                               &ContactParameters::sliding_friction,
                               &ContactParameters::sliding_offset,
                               &ContactParameters::lateral_stiffness};
  return mode;
}

const MotionMode& torsion_mode() {
  static const MotionMode mode{Motion::torsion,
                               "Torsion, M = mu lambda (f + h)",
                               &History::torsion_angle,
                               &History::torsion_moment,
                               "N m",
                               "torsion_stiffness",
                               "N m/rad",
                               "Experiment/Angle",
                               false,
                               true,
                               3,
                               &ContactParameters::torsion_friction,
                               &ContactParameters::torsion_offset,
                               &ContactParameters::torsion_stiffness};
  return mode;
}

const MotionMode& rolling_mode() {
  static const MotionMode mode{Motion::rolling,
                               "Rolling, M = mu lambda (f + h)",
                               &History::rolling_angle,
                               &History::rolling_moment,
                               "N m",
                               "rolling_stiffness",
                               "N m/rad",
                               "Experiment/Distance",
                               false,
                               true,
                               1,
                               &ContactParameters::rolling_friction,
                               &ContactParameters::rolling_offset,
                               &ContactParameters::rolling_stiffness};
  return mode;
}

}  // namespace asperity

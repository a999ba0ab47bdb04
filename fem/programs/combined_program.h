// Stations of a program that combines motions (core/motion_program.h).
#pragma once

#include <vector>

#include "core/case.h"
#include "core/motion_program.h"
#include "fem/programs/program.h"

namespace asperity::fem {

/// From the largest load on, where the particle stands as `start` says. Loads are fractions of `largest`: [N]
/// under control by force, [m] of approach else. The steps of a part are fine where slip begins and no wider
/// than those of a single motion.
std::vector<Station> combined_program(const std::vector<ProgramPart>& parts,
                                      const ExperimentInput& experiment, const MotionScales& scales,
                                      const RigidMotion& start);

/// How far the contact goes over the substrate and over the particle, from where the program begins.
struct MotionExtent {
  double low_x = 0, high_x = 0, low_y = 0, high_y = 0;   ///< [m]
  double low_roll = 0, high_roll = 0, largest_spin = 0;  ///< [rad]
};

/// How far the stations go.
MotionExtent extent_of(const std::vector<Station>& stations);

/// Where the particle begins so that its path lies evenly about the axis of the meshes.
RigidMotion start_of(const MotionExtent& extent);

}  // namespace asperity::fem

// Which steps have fields, and when they are shown: the time of ParaView's animation.
#pragma once

#include <string>
#include <vector>

#include "fem/programs/program.h"

namespace asperity::fem {

/// What runs on from frame to frame.
enum class FrameTime {
  seconds,  ///< where the case has speeds or times
  path,  ///< nm of the contact's path, where it moves; pressing takes the last nm before it, leaving one more
  load,  ///< uN, counted on while the load falls
  approach,  ///< nm, likewise, under displacement control
};

/// The steps of an experiment as frames of an animation.
struct Frames {
  FrameTime time_is = FrameTime::load;
  std::vector<double> time;         ///< at the end of each step, in the unit of time_is; never falls
  std::vector<double> path_length;  ///< of the contact until then [m]; of its rim where it spins
  std::vector<char> shown;          ///< whether a step has fields

  /// "path length in nm, ..." for the fields.
  std::string time_text() const;
};

/// every: steps between frames; 0: ten of them at even times. Each first step at the largest load and the
/// last step are frames too. largest: load [N] or approach [m].
Frames frames_of(const ExperimentInput& experiment, const std::vector<Station>& program,
                 const MotionScales& scales, double largest, int every);

}  // namespace asperity::fem

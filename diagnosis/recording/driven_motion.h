// What a run's control says of its motion: direction, path since the reversal, holds, cycles, speed.
#pragma once

#include "diagnosis/recording/samples.h"

namespace asperity {

/// What the table of a run says itself, and what drives it.
struct DrivenBy {
  bool normal = false;  ///< approach, else lateral motion
  bool force = false;   ///< of normal experiments: the force, else the displacement
  bool has_speed = false, has_cycles = false, has_time = false;
  bool time_from_path = false;  ///< a lateral motion whose table gives speeds and no time
};

/// Fills the samples of one run, whose segments are named, with what follows from the control alone.
void follow_motion(Samples& samples, const SampleRun& run, const DrivenBy& by);

}  // namespace asperity

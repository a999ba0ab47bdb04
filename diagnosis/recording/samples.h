// A recording as the simulation is driven through it: one list of samples in order, cut into runs and
// segments, with what follows from the control alone (direction, path since the last reversal, time in the
// hold). SI units.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/recording/recording.h"
#include "diagnosis/recording/turning_point.h"

namespace asperity {

/// One row: what drives the simulation, and the response that was recorded.
struct Sample {
  double time = 0, normal_displacement = 0, normal_force = 0, lateral_displacement = 0;
  double speed = 0;     ///< of sliding or rolling [m/s]: recorded, else from path and time, else 0
  double approach = 0;  ///< rate of the displacement under normal load, from displacement and time [m/s]
  double radius = 0;    ///< of the particle
  double rms_roughness = 0;
  double rail_angle = 0;
  double humidity = 0;               ///< relative, 0 to 1
  double since_reversal = 0;         ///< path since the driven motion last turned [m]
  std::optional<TurningPoint> turn;  ///< where it turned between the sample before and this one
  double hold_time = 0;              ///< since the hold began [s]; 0 outside holds
  int hold = 0;                      ///< holds of the run begun so far
  int direction = 1;                 ///< of lateral motion, or of approach: +1, -1
  double cycle = 0;                  ///< number of the loop, from 0
  double cycles_passed = 0;          ///< since the run began, within a cycle by path
  int segment = 0;                   ///< index into Samples::segment_names
  int part = 0;                      ///< number of the contiguous part of one run and segment
  int row = 0;                       ///< of the table
  std::size_t index = 0;             ///< place in the whole list, also after thinning
  double response = 0, sd = 0;       ///< sd: given with the row; 0: not given
  bool counts = true;  ///< false: missing, or an outlier; drives the simulation but is not compared
};

/// Consecutive samples that share one history, or independent rows of a series.
struct SampleRun {
  std::size_t begin = 0, end = 0;
  std::size_t table = 0;
  double number = 0;  ///< of the experiment
  bool independent_rows = false;
  bool response_is_displacement = false;  ///< normal mode under force control
  ForcePlace at = ForcePlace::indenter;
  double first_response = 0;  ///< lateral force with which the run begins; 0: at rest
};

struct Samples {
  std::vector<Sample> list;
  std::vector<SampleRun> runs;
  std::vector<std::string> segment_names;
  std::vector<std::string> table_names, response_channels;
  int parts = 0;
  double snap_width = 0;  ///< displacement by which a solved simulation may snap off earlier or later [m]
};

/// All tables of a recording, in their order.
Samples samples_of(const Recording& recording);

/// Every sample near reversals, fewer elsewhere, at most about `most`; ends of segments stay.
Samples thinned(const Samples& samples, std::size_t most);

}  // namespace asperity

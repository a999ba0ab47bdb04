#include "diagnosis/recording/time_from_path.h"

#include <algorithm>
#include <cmath>

#include "core/printable.h"
#include "diagnosis/recording/recording.h"
#include "diagnosis/recording/samples.h"

namespace asperity {

bool time_is_known(const Recording& recording, const RecordingTable& table) {
  if (table.has("time")) return true;
  if (recording.mode == Motion::normal || table.kind != TableKind::trace) return false;
  if (!table.has("speed") || !table.has("lateral_displacement")) return false;
  const auto& speed = table.column("speed");
  return std::all_of(speed.begin(), speed.end(), [](double v) { return v > 0; });
}

void take_time_from_path(Samples& samples, const SampleRun& run) {
  double time = 0;
  for (std::size_t i = run.begin; i < run.end; ++i) {
    Sample& s = samples.list[i];
    if (i > run.begin) {
      const Sample& before = samples.list[i - 1];
      const double turned = s.turn ? s.turn->displacement : s.lateral_displacement;
      const double path =
          std::abs(turned - before.lateral_displacement) + std::abs(s.lateral_displacement - turned);
      time += path / ((s.speed + before.speed) / 2);
    }
    s.time = time;
  }
}

std::vector<std::string> remarks_on_time(const Recording& recording) {
  std::vector<std::string> remarks;
  for (const auto& table : recording.tables) {
    if (table.kind != TableKind::trace || table.has("time")) continue;
    const std::string begin = "'" + printable(table.file) + "' has no column of time: ";
    remarks.push_back(begin + (time_is_known(recording, table)
                                   ? "path over speed was taken for it, in which time at rest is missing"
                                   : "no effect that passes with time was tried"));
  }
  return remarks;
}

}  // namespace asperity

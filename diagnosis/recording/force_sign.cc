#include "diagnosis/recording/force_sign.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "diagnosis/recording/samples.h"

namespace asperity {
namespace {

/// Number, sum and sum of squares of a force [N] in one direction of motion.
struct ForceInDirection {
  double count = 0, sum = 0, squares = 0;

  void add(double force) { count += 1, sum += force, squares += force * force; }
  double mean() const { return count > 0 ? sum / count : 0; }
  double about_mean() const { return std::max(0.0, squares - sum * mean()); }  // round-off of a constant
};

/// +1: what drives the motion does work, and friction dissipates it; -1: friction would give energy; 0: this
/// run does not tell.
int sign_of_dissipation(const Samples& samples, const SampleRun& run) {
  ForceInDirection rising, falling;
  bool contradicts_names = true;
  for (std::size_t i = run.begin; i < run.end; ++i) {
    const Sample& s = samples.list[i];
    const std::string& name = samples.segment_names[static_cast<std::size_t>(s.segment)];
    if (!s.counts || name == "hold") continue;
    (s.direction > 0 ? rising : falling).add(s.response);
    contradicts_names = contradicts_names && name == (s.direction > 0 ? "backward" : "forward");
  }
  if ((rising.count == 0 || falling.count == 0) && !contradicts_names) return 0;
  const double difference = rising.mean() - falling.mean();  // one of them is 0 in one direction alone
  const double count = rising.count + falling.count;
  const double scatter = std::sqrt((rising.about_mean() + falling.about_mean()) / std::max(1.0, count));
  return difference < -scatter ? -1 : difference > scatter ? 1 : 0;
}

/// Which signs the runs of a table have.
struct SignsOfRuns {
  bool dissipate = false, give = false;
};

SignsOfRuns signs_of_runs(const Recording& recording, std::size_t table) {
  const Samples samples = samples_of(recording);
  SignsOfRuns signs;
  for (const SampleRun& run : samples.runs) {
    const int sign = run.table == table ? sign_of_dissipation(samples, run) : 0;
    signs.dissipate = signs.dissipate || sign > 0;
    signs.give = signs.give || sign < 0;
  }
  return signs;
}

}  // namespace

void turn_displacement_along_force(Recording& recording) {
  if (recording.mode == Motion::normal) return;
  for (std::size_t t = 0; t < recording.tables.size(); ++t) {
    RecordingTable& table = recording.tables[t];
    if (table.kind != TableKind::trace || table.response != "lateral_force" ||
        !table.has("lateral_displacement"))
      continue;
    const SignsOfRuns as_given = signs_of_runs(recording, t);
    if (!as_given.give) continue;
    for (double& x : table.columns["lateral_displacement"]) x = -x;
    if (as_given.dissipate || signs_of_runs(recording, t).give)
      throw InputError(
          (recording.folder.empty() ? table.file : (recording.folder / table.file).string()) +
          ": the lateral force of some runs is smaller on the way forward than on the way back, so friction "
          "would give energy there; turn the sign of their lateral_force");
    recording.remarks.push_back(
        table.file +
        ": lateral force and lateral displacement are positive in opposite directions, so that "
        "friction would give energy; the sign of the displacement is turned");
  }
}

}  // namespace asperity

#include "diagnosis/recording/force_sign.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "diagnosis/recording/samples.h"

namespace asperity {
namespace {

/// Number, sum and sum of squares of a force [N] in one direction of motion.
struct ForceInDirection {
  double count = 0, sum = 0, squares = 0;

  void add(double force) { count += 1, sum += force, squares += force * force; }
  double mean() const { return count > 0 ? sum / count : 0; }
  double over_count() const { return count > 0 ? 1 / count : 0; }
  double about_mean() const { return std::max(0.0, squares - sum * mean()); }  // round-off of a constant
};

/// +1: what drives the motion does work, and friction dissipates it; -1: friction would give energy; 0: this
/// run does not tell.
int sign_of_dissipation(const Samples& samples, const SampleRun& run) {
  constexpr double of_chance = 5;  // standard deviations of the means' difference
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
  const double by_chance = std::sqrt(rising.over_count() + falling.over_count());
  if (!(std::abs(difference) > scatter * std::max(1.0, of_chance * by_chance))) return 0;
  return difference > 0 ? 1 : -1;
}

/// How many runs of a table dissipate, and how many would give energy.
struct RunsBySign {
  int dissipate = 0, give = 0;
};

RunsBySign runs_by_sign(const Recording& recording, std::size_t table) {
  const Samples samples = samples_of(recording);
  RunsBySign runs;
  for (const SampleRun& run : samples.runs) {
    const int sign = run.table == table ? sign_of_dissipation(samples, run) : 0;
    runs.dissipate += sign > 0, runs.give += sign < 0;
  }
  return runs;
}

void turn(std::vector<double>& column) {
  for (double& x : column) x = -x;
}

/// The displacement turned, or, where the names of segments alone say the direction, the force.
void agree_on_signs(Recording& recording, std::size_t t) {
  RecordingTable& table = recording.tables[t];
  RunsBySign runs = runs_by_sign(recording, t);
  if (runs.give > runs.dissipate) {
    std::string turned = "displacement";
    turn(table.columns["lateral_displacement"]);
    if (runs_by_sign(recording, t).give >= runs.give) {
      turn(table.columns["lateral_displacement"]), turn(table.columns["lateral_force"]);
      turned = "force";
    }
    recording.remarks.push_back(table.file +
                                ": lateral force and lateral displacement are positive in opposite "
                                "directions, so that friction would give energy; the sign of the " +
                                turned + " is turned");
    std::swap(runs.give, runs.dissipate);
  }
  if (runs.give > 0)
    recording.remarks.push_back(table.file + ": in " + std::to_string(runs.give) + " of " +
                                std::to_string(runs.give + runs.dissipate) +
                                " runs the lateral force has the other sign than in the rest, so that "
                                "friction would give energy there");
}

}  // namespace

void turn_signs_to_dissipate(Recording& recording) {
  if (recording.mode == Motion::normal) return;
  for (std::size_t t = 0; t < recording.tables.size(); ++t) {
    const RecordingTable& table = recording.tables[t];
    if (table.kind == TableKind::trace && table.response == "lateral_force" &&
        table.has("lateral_displacement"))
      agree_on_signs(recording, t);
  }
}

}  // namespace asperity

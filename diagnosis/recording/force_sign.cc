#include "diagnosis/recording/force_sign.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "diagnosis/recording/samples.h"

namespace asperity {
namespace {

/// Sums over the forces f [N] in one direction of motion and their places k in the run.
struct ForceInDirection {
  double count = 0, f = 0, k = 0, ff = 0, kk = 0, fk = 0;

  void add(double force, double place) {
    count += 1, f += force, k += place, ff += force * force, kk += place * place, fk += force * place;
  }
  double mean() const { return count > 0 ? f / count : 0; }
  double place() const { return count > 0 ? k / count : 0; }
  double over_count() const { return count > 0 ? 1 / count : 0; }
  /// Sums of products about the means.
  double force_squared() const { return ff - f * mean(); }
  double place_squared() const { return kk - k * place(); }
  double force_and_place() const { return fk - f * place(); }
};

/// Of motion in both directions, force on the way forward less that on the way back, without a drift of the
/// force that goes on all the time (analysis of covariance: Fisher 1932). A tilt, whose force rises one way
/// and falls the other, is no drift.
struct ForceDifference {
  double value, scatter, sd;  ///< scatter: of a sample; sd: standard deviation of the value [N]

  ForceDifference(const ForceInDirection& forward, const ForceInDirection& back) {
    value = forward.mean() - back.mean();  // one of them is 0 in one direction alone
    double squares = forward.force_squared() + back.force_squared();
    double variance = forward.over_count() + back.over_count();  // over that of a sample
    if (forward.count > 1 && back.count > 1) {
      const double between = forward.place() - back.place();
      const double products = forward.force_and_place() + back.force_and_place();
      const double places = forward.place_squared() + back.place_squared(), drift = products / places;
      value -= drift * between;
      squares -= drift * products;
      variance += between * between / places;
    }
    // Round-off of a constant force may leave less than nothing.
    scatter = std::sqrt(std::max(0.0, squares) / std::max(1.0, forward.count + back.count));
    sd = scatter * std::sqrt(variance);
  }
};

/// +1: what drives the motion does work, and friction dissipates it; -1: friction would give energy; 0: this
/// run does not tell.
int sign_of_dissipation(const Samples& samples, const SampleRun& run) {
  constexpr double of_chance = 5;  // standard deviations
  ForceInDirection forward, back;
  bool contradicts_names = true;
  for (std::size_t i = run.begin; i < run.end; ++i) {
    const Sample& s = samples.list[i];
    const std::string& name = samples.segment_names[static_cast<std::size_t>(s.segment)];
    if (!s.counts || name == "hold") continue;
    (s.direction > 0 ? forward : back).add(s.response, static_cast<double>(i - run.begin));
    contradicts_names = contradicts_names && name == (s.direction > 0 ? "backward" : "forward");
  }
  if ((forward.count == 0 || back.count == 0) && !contradicts_names) return 0;
  const ForceDifference difference(forward, back);
  if (!(std::abs(difference.value) > std::max(difference.scatter, of_chance * difference.sd))) return 0;
  return difference.value > 0 ? 1 : -1;
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

#include "diagnosis/mapping/branch_curves.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace asperity {
namespace {

/// Displacement against force, straight in f^(2/3) between what was solved: as the approach is by Hertz.
/// Beyond its ends it stays as it is there.
class ForceCurve {
 public:
  void add(double force, double displacement) { points_.push_back({scaled(force), displacement}); }
  void finish() {
    std::stable_sort(points_.begin(), points_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
  }
  double at(double force) const {
    const double x = scaled(force);
    if (points_.empty()) return 0;
    if (x <= points_.front().first) return points_.front().second;
    if (x >= points_.back().first) return points_.back().second;
    const auto after = std::upper_bound(points_.begin(), points_.end(), x,
                                        [](double value, const auto& point) { return value < point.first; });
    const auto before = after - 1;
    const double width = after->first - before->first;
    return before->second +
           (width > 0 ? (x - before->first) / width * (after->second - before->second) : 0.0);
  }

 private:
  static double scaled(double force) { return std::copysign(std::pow(std::abs(force), 2.0 / 3), force); }
  std::vector<std::pair<double, double>> points_;
};

struct Branches {
  ForceCurve loading, unloading;
};

class SolvedDifference : public BranchCorrection {
 public:
  std::vector<Branches> of_protocol;
  std::vector<std::size_t> protocol;  ///< by Sample::index
  std::vector<char> is_unloading;     ///< by Sample::index
  double displacement_error = 0;

  double displacement(const Sample& sample, double force) const override {
    const bool known = sample.index < protocol.size();
    const Branches& b = of_protocol[known ? protocol[sample.index] : 0];
    return (known && is_unloading[sample.index] ? b.unloading : b.loading).at(force);
  }
  double error() const override { return displacement_error; }
};

/// The reduced law under the forces of a solution.
std::vector<double> reduced_displacements(const Mechanics& reduced, const SolvedResponse& solved) {
  Samples samples;
  for (std::size_t i = 0; i < solved.force.size(); ++i) {
    Sample s;
    s.index = i;
    s.normal_force = solved.force[i];
    samples.list.push_back(s);
  }
  SampleRun run;
  run.end = samples.list.size();
  run.response_is_displacement = true;
  samples.runs.push_back(run);
  return simulate(reduced, samples);
}

Branches branches_of(const SolvedResponse& solved, const Mechanics& reduced) {
  const std::vector<double> by_law = reduced_displacements(reduced, solved);
  Branches b;
  b.loading.add(0, 0);
  for (std::size_t i = 0; i < solved.force.size(); ++i) {
    // Without load the reduced law's displacement is not determined, nor is it asked for.
    if (!(solved.force[i] > 0)) continue;
    const double difference = solved.displacement[i] - by_law[i];
    if (i <= solved.peak) b.loading.add(solved.force[i], difference);
    if (i >= solved.peak) b.unloading.add(solved.force[i], difference);
  }
  b.loading.finish();
  b.unloading.finish();
  if (solved.peak + 1 >= solved.force.size()) b.unloading = b.loading;  // nothing yields: it comes back on it
  return b;
}

double load_of(const SampleRun& run, const Sample& s) {
  return run.response_is_displacement ? s.normal_force : s.normal_displacement;
}

}  // namespace

RecordedProtocols protocols_of(const Samples& samples) {
  constexpr double same = 0.05;
  RecordedProtocols found;
  std::vector<double> forces;
  for (const auto& run : samples.runs) {
    if (run.independent_rows)
      throw InputError(
          "a case is solved for traces only: this recording holds a series of single loads; record approach "
          "and force along loading, or leave out --case");
    std::size_t peak = run.begin;
    for (std::size_t i = run.begin; i < run.end; ++i)
      if (load_of(run, samples.list[i]) > load_of(run, samples.list[peak])) peak = i;
    found.peak.push_back(peak);
    // Single samples are noisy: the middle of those around the largest load.
    constexpr std::size_t around = 2;
    std::vector<double> near;
    for (std::size_t i = std::max(run.begin + around, peak) - around;
         i < std::min(run.end, peak + around + 1); ++i) {
      const Sample& s = samples.list[i];
      if (run.response_is_displacement || s.counts)
        near.push_back(run.response_is_displacement ? s.normal_force : s.response);
    }
    std::sort(near.begin(), near.end());
    forces.push_back(near.empty() ? 0 : near[near.size() / 2]);
  }
  std::vector<std::size_t> order(forces.size());
  for (std::size_t r = 0; r < order.size(); ++r) order[r] = r;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return forces[a] > forces[b]; });
  found.of_run.resize(forces.size());
  for (const std::size_t r : order) {
    if (found.list.empty() || forces[r] < (1 - same) * found.list.back().largest_force)
      found.list.push_back({forces[r], false});
    found.of_run[r] = found.list.size() - 1;
    const SampleRun& run = samples.runs[r];
    constexpr double back = 0.98;  // of the largest load: less is noise
    for (std::size_t i = found.peak[r]; i < run.end; ++i)
      if (load_of(run, samples.list[i]) < back * load_of(run, samples.list[found.peak[r]]))
        found.list.back().unloads = true;
  }
  if (found.list.empty() || !(found.list.back().largest_force > 0))
    throw InputError(
        "a run of the recording is not pressed at all, so that no case can be solved for it; leave it out");
  return found;
}

std::shared_ptr<const BranchCorrection> difference_to(const std::vector<SolvedResponse>& solved,
                                                      const RecordedProtocols& protocols,
                                                      const Mechanics& reduced, const Samples& samples) {
  auto difference = std::make_shared<SolvedDifference>();
  for (const SolvedResponse& response : solved) {
    difference->of_protocol.push_back(branches_of(response, reduced));
    difference->displacement_error = std::max(difference->displacement_error, response.displacement_error);
  }
  difference->protocol.resize(samples.list.size());
  difference->is_unloading.resize(samples.list.size());
  for (std::size_t r = 0; r < samples.runs.size(); ++r)
    for (std::size_t i = samples.runs[r].begin; i < samples.runs[r].end; ++i) {
      difference->protocol[samples.list[i].index] = protocols.of_run[r];
      difference->is_unloading[samples.list[i].index] =
          i > protocols.peak[r] && protocols.list[protocols.of_run[r]].unloads;
    }
  return difference;
}

}  // namespace asperity

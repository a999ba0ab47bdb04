#include "diagnosis/choose/held_out.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "diagnosis/fit/likely_surface.h"

namespace asperity {
namespace {

constexpr int most_blocks = 5;

/// At most `most_blocks` groups of keys in their order, alternating so that no group holds one end alone.
void group(std::vector<int>& keys, int distinct, Blocks& blocks) {
  blocks.count = std::min(most_blocks, distinct);
  for (int& key : keys) key %= blocks.count;
  blocks.of_sample = std::move(keys);
}

/// What a left-out block changes, in coordinates of the search, may not exceed this part of a parameter, if
/// it is clear of noise.
constexpr double largest_change = 0.6, clear_of_noise = 6;

bool moves_too_far(const FreeParameter& p, double with_all, double without, double sd) {
  if (p.effect < 0) return false;
  const double from = p.coordinate(with_all), to = p.coordinate(without);
  // Between bounds that mean something, as the limits of a law, zero is no size of its own.
  const double size = p.logarithmic        ? 1
                      : p.bounds_are_meant ? p.coordinate(p.high) - p.coordinate(p.low)
                                           : std::max(std::abs(from), 1e-12);
  return std::abs(to - from) > std::max(largest_change * size, clear_of_noise * sd);
}

}  // namespace

Blocks blocks_of(const Samples& samples) {
  Blocks blocks;
  const bool series = std::any_of(samples.runs.begin(), samples.runs.end(),
                                  [](const SampleRun& r) { return r.independent_rows; });
  std::vector<int> keys(samples.list.size(), 0);
  if (series) {
    blocks.name = "rows";
    int next = 0;
    for (const auto& run : samples.runs)
      for (std::size_t i = run.begin; i < run.end; ++i) keys[i] = run.independent_rows ? next++ : next;
    group(keys, std::max(2, next), blocks);
    return blocks;
  }
  constexpr std::size_t fewest = 3;
  if (samples.runs.size() >= fewest) {
    blocks.name = "runs";
    for (std::size_t r = 0; r < samples.runs.size(); ++r)
      for (std::size_t i = samples.runs[r].begin; i < samples.runs[r].end; ++i) keys[i] = static_cast<int>(r);
    group(keys, static_cast<int>(samples.runs.size()), blocks);
    return blocks;
  }
  std::map<std::pair<std::size_t, double>, int> cycles;
  for (std::size_t r = 0; r < samples.runs.size(); ++r)
    for (std::size_t i = samples.runs[r].begin; i < samples.runs[r].end; ++i)
      keys[i] = cycles.try_emplace({r, samples.list[i].cycle}, static_cast<int>(cycles.size())).first->second;
  if (cycles.size() >= fewest) {
    blocks.name = "cycles";
    group(keys, static_cast<int>(cycles.size()), blocks);
    return blocks;
  }
  // Blocks of each segment: twenty, dealt out in turn.
  blocks.name = "blocks";
  constexpr int in_a_segment = 20;
  for (const auto& run : samples.runs)
    for (std::size_t i = run.begin; i < run.end; ++i)
      keys[i] = static_cast<int>((i - run.begin) * in_a_segment / (run.end - run.begin));
  group(keys, in_a_segment, blocks);
  return blocks;
}

HeldOut predict_held_out(const FitProblem& problem, const ModelFit& fit, const Blocks& blocks,
                         double off_by) {
  constexpr int steps = 4;
  HeldOut result;
  result.blocks = blocks.count;
  result.block_name = blocks.name;
  double sum = 0, cost = 0, count = 0;
  const auto& parameters = fit.explanation->parameters();
  for (int block = 0; block < blocks.count; ++block) {
    Samples rest = problem.thin;
    for (auto& s : rest.list)
      if (blocks.of_sample[s.index] == block) s.counts = false;
    const ModelFit without = refitted(problem, fit, rest, false, steps);
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      const double sd =
          fit.covariance.size() > 0 ? off_by * std::sqrt(std::max(0.0, fit.covariance(i, i))) : 0;
      if (fit.covariance.size() > 0 && moves_too_far(parameters[k], fit.values[k], without.values[k], sd))
        result.consistent = false;
    }
    const auto residual =
        FitProblem::residual(problem.samples, simulated_on_likely_surface(problem, without, rest));
    for (std::size_t i = 0; i < residual.size(); ++i) {
      if (!problem.samples.list[i].counts || blocks.of_sample[i] != block) continue;
      const double r = residual[i] / problem.noise.sd[i];
      sum += r * r;
      cost += huber_cost(r);
      ++count;
    }
  }
  result.chi2_reduced = sum / std::max(1.0, count);
  result.cost = cost / std::max(1.0, count);
  return result;
}

}  // namespace asperity

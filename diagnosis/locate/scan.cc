#include "diagnosis/locate/scan.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace asperity {
namespace {

/// T of a bin below which it is no part of a region: two standard deviations.
constexpr double background = 4;
constexpr int simulated_noises = 240;
constexpr double region_significance = 0.01;
constexpr std::size_t most_regions = 6;
/// How well a standard deviation is known, relative: given ones are rounded, estimated ones have few samples.
constexpr double uncertainty_of_sd = 0.05;

struct Run {
  std::size_t from = 0, to = 0;
  double score = 0;
};

/// Disjoint runs of positive sum, the largest first: take the largest, then look to either side of it.
void best_runs(const std::vector<double>& excess, std::size_t from, std::size_t to, std::vector<Run>& found,
               bool only_best) {
  Run best;
  double sum = 0;
  std::size_t start = from;
  for (std::size_t i = from; i < to; ++i) {
    if (sum <= 0) sum = 0, start = i;
    sum += excess[i];
    if (sum > best.score) best = {start, i + 1, sum};
  }
  if (best.score <= 0) return;
  found.push_back(best);
  if (only_best) return;
  best_runs(excess, from, best.from, found, false);
  best_runs(excess, best.to, to, found, false);
}

/// Noise of unit variance in place of every run's residuals.
std::vector<double> simulated_noise(const Samples& samples, const Noise& noise, std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::vector<double> values(samples.list.size());
  for (std::size_t r = 0; r < samples.runs.size(); ++r) {
    const SharedNoise shared = samples.runs[r].independent_rows ? SharedNoise{} : noise.shared[r];
    const double fresh = std::sqrt(shared.share * (1 - shared.memory * shared.memory)),
                 own = std::sqrt(1 - shared.share);
    double slow = std::sqrt(shared.share) * normal(random);
    for (std::size_t i = samples.runs[r].begin; i < samples.runs[r].end; ++i) {
      values[i] = slow + own * normal(random);
      slow = shared.memory * slow + fresh * normal(random);
    }
  }
  return values;
}

/// Single samples far off between two that are not are outliers, or the one sample in which something
/// snapped.
void leave_out_spikes(const Samples& samples, std::vector<double>& ratio) {
  constexpr double far = 4.5, near = 3;
  const std::vector<double> given = ratio;
  for (const auto& run : samples.runs) {
    if (run.independent_rows) continue;
    for (std::size_t i = run.begin; i < run.end; ++i)
      if (std::abs(given[i]) > far && (i == run.begin || std::abs(given[i - 1]) < near) &&
          (i + 1 == run.end || std::abs(given[i + 1]) < near))
        ratio[i] = 0;
  }
}

BinMoments moments(const Bin& bin, const std::vector<double>& ratio) {
  BinMoments m;
  for (const std::size_t i : bin.samples) {
    m.mean += ratio[i];
    m.square += ratio[i] * ratio[i];
  }
  const auto count = static_cast<double>(bin.samples.size());
  m.mean /= count;
  m.square /= count;
  return m;
}

/// What there is to scan: residuals, and what the laws may be off by, over the noise of each sample.
struct Scanned {
  std::vector<double> ratio, allowance;
  double whole_excess = 0;  ///< of the squares over those of noise
};

Scanned over_noise(const Samples& samples, const Noise& noise, const std::vector<double>& residual,
                   const std::vector<double>& tolerated) {
  Scanned scanned{std::vector<double>(residual.size()), std::vector<double>(residual.size(), 0.0), 0};
  for (std::size_t i = 0; i < residual.size(); ++i) {
    const double sd = noise.sd[samples.list[i].index];
    scanned.ratio[i] = residual[i] / sd;
    if (!tolerated.empty()) scanned.allowance[i] = tolerated[i] / sd;
    if (samples.list[i].counts) scanned.whole_excess += scanned.ratio[i] * scanned.ratio[i] - 1;
  }
  leave_out_spikes(samples, scanned.ratio);
  return scanned;
}

/// A run of bins that noise alone seldom shows.
struct CandidateRegion {
  std::size_t view;
  Run run;
};

/// The view of a segment in which the mismatch stands out most.
struct BestView {
  double score = 0;
  std::vector<CandidateRegion> candidates;
};

MismatchRegion region_of(const Run& run, const View& view, const Samples& samples, const Scanned& scanned) {
  MismatchRegion region;
  region.table = samples.table_names[view.table];
  region.channel = samples.response_channels[view.table];
  region.segment = view.segment;
  region.variable = view.variable;
  region.unit = unit_of_channel(view.variable);
  region.from = view.bins[run.from].from;
  region.to = view.bins[run.to - 1].to;
  double excess = 0, mean = 0, count = 0;
  for (std::size_t b = run.from; b < run.to; ++b)
    for (const std::size_t i : view.bins[b].samples) {
      excess += scanned.ratio[i] * scanned.ratio[i] - 1;
      mean += scanned.ratio[i];
      ++count;
    }
  region.size_in_noise = mean / count;
  region.share = scanned.whole_excess > 0 ? std::clamp(excess / scanned.whole_excess, 0.0, 1.0) : 0;
  return region;
}

}  // namespace

double Scanner::departure(const BinMoments& m, const BinScale& scale, double allowed) {
  const double coherent = m.mean * m.mean / (scale.mean * scale.mean + allowed);
  const double part = scale.square * scale.square / 9;  // 2/(9 n) of n independent samples
  const double q = (std::cbrt(std::max(0.0, m.square - allowed)) - (1 - part)) / std::sqrt(part);
  return std::max(coherent, q > 0 ? q * q : 0.0);
}

double chi2_reduced(const Samples& samples, const std::vector<double>& residual, const Noise& noise) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < residual.size(); ++i)
    if (samples.list[i].counts) {
      sum += std::pow(residual[i] / noise.sd[samples.list[i].index], 2);
      ++count;
    }
  return count > 0 ? sum / count : 0;
}

Scanner::Scanner(const Samples& samples, const Experiment& experiment, const Noise& noise, unsigned seed)
    : samples_(samples), noise_(noise), views_(views_of(samples, experiment)) {
  std::mt19937 random(seed);
  std::vector<std::vector<std::vector<BinMoments>>> all(views_.size());
  for (std::size_t v = 0; v < views_.size(); ++v) all[v].resize(views_[v].bins.size());
  for (int n = 0; n < simulated_noises; ++n) {
    const auto values = simulated_noise(samples, noise, random);
    for (std::size_t v = 0; v < views_.size(); ++v)
      for (std::size_t b = 0; b < views_[v].bins.size(); ++b)
        all[v][b].push_back(moments(views_[v].bins[b], values));
  }
  scales_.resize(views_.size());
  for (std::size_t v = 0; v < views_.size(); ++v)
    for (const auto& bin : all[v]) {
      double mean = 0, square = 0;
      for (const auto& m : bin) mean += m.mean * m.mean, square += (m.square - 1) * (m.square - 1);
      scales_[v].push_back({std::sqrt(mean / simulated_noises),
                            std::hypot(std::sqrt(square / simulated_noises), 2 * uncertainty_of_sd)});
    }
  for (int n = 0; n < simulated_noises; ++n) {
    double largest = 0;
    for (std::size_t v = 0; v < views_.size(); ++v) {
      std::vector<double> excess;
      for (std::size_t b = 0; b < views_[v].bins.size(); ++b)
        excess.push_back(departure(all[v][b][static_cast<std::size_t>(n)], scales_[v][b], 0) - background);
      std::vector<Run> runs;
      best_runs(excess, 0, excess.size(), runs, true);
      if (!runs.empty()) largest = std::max(largest, runs.front().score);
    }
    noise_scores_.push_back(largest);
  }
  std::sort(noise_scores_.begin(), noise_scores_.end());
}

double Scanner::p_value(double score) const {
  if (score <= 0) return 1;
  constexpr double tail = 0.2, smallest = 1e-12;
  const auto count = static_cast<double>(noise_scores_.size());
  const auto above = static_cast<double>(noise_scores_.end() -
                                         std::lower_bound(noise_scores_.begin(), noise_scores_.end(), score));
  const auto edge = static_cast<std::size_t>((1 - tail) * count);
  if (score <= noise_scores_[edge]) return (above + 1) / (count + 1);
  double excess = 0;
  for (std::size_t i = edge; i < noise_scores_.size(); ++i) excess += noise_scores_[i] - noise_scores_[edge];
  excess /= static_cast<double>(noise_scores_.size() - edge);
  return excess > 0 ? std::max(smallest, tail * std::exp(-(score - noise_scores_[edge]) / excess))
                    : (above + 1) / (count + 1);
}

std::vector<double> Scanner::excess_of_bins(std::size_t v, const std::vector<double>& ratio,
                                            const std::vector<double>& allowance) const {
  std::vector<double> excess;
  for (std::size_t b = 0; b < views_[v].bins.size(); ++b) {
    const Bin& bin = views_[v].bins[b];
    const auto m = moments(bin, ratio);
    double allowed = 0;
    for (const std::size_t i : bin.samples) allowed += allowance[i] * allowance[i];
    allowed /= static_cast<double>(bin.samples.size());
    excess.push_back(departure(m, scales_[v][b], allowed) - background);
  }
  return excess;
}

ScanResult Scanner::scan(const std::vector<double>& residual, const std::vector<double>& tolerated) const {
  ScanResult result;
  result.chi2_reduced = asperity::chi2_reduced(samples_, residual, noise_);
  const Scanned scanned = over_noise(samples_, noise_, residual, tolerated);
  std::map<std::pair<std::size_t, std::string>, BestView> best_of_segment;
  double largest = 0;
  for (std::size_t v = 0; v < views_.size(); ++v) {
    const std::vector<double> excess = excess_of_bins(v, scanned.ratio, scanned.allowance);
    std::vector<Run> runs;
    best_runs(excess, 0, excess.size(), runs, false);
    BestView here;
    for (const auto& run : runs) {
      largest = std::max(largest, run.score);
      if (p_value(run.score) >= region_significance) continue;
      here.score += run.score;
      here.candidates.push_back({v, run});
    }
    if (views_[v].variable.empty() || here.score <= 0) continue;
    auto& best = best_of_segment[{views_[v].table, views_[v].segment}];
    if (here.score > best.score) best = here;
  }
  std::vector<CandidateRegion> candidates;
  for (const auto& [segment, best] : best_of_segment)
    candidates.insert(candidates.end(), best.candidates.begin(), best.candidates.end());
  result.p_value = p_value(largest);
  std::sort(candidates.begin(), candidates.end(),
            [](const auto& a, const auto& b) { return a.run.score > b.run.score; });
  if (candidates.size() > most_regions) candidates.resize(most_regions);
  for (const auto& [view, run] : candidates) {
    result.regions.push_back(region_of(run, views_[view], samples_, scanned));
    result.regions.back().p_value = p_value(run.score);
  }
  return result;
}

}  // namespace asperity

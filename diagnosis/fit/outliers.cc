#include "diagnosis/fit/outliers.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "diagnosis/recording/median.h"

namespace asperity {
namespace {

/// Whether a sample lies far off those within four places of it in its run, a `partner` aside: beyond all of
/// them, not only off their middle, for the edge of a step is none.
bool lies_far_off(const Samples& samples, const std::vector<double>& residual, const Noise& noise,
                  const SampleRun& run, std::size_t sample, std::size_t partner) {
  constexpr std::size_t reach = 4, fewest = 4;
  constexpr double far = 6;
  std::vector<double> near;
  for (std::size_t i = std::max(run.begin + reach, sample) - reach; i < std::min(run.end, sample + reach + 1);
       ++i)
    if (i != sample && i != partner && samples.list[i].counts) near.push_back(residual[i]);
  if (near.size() < fewest) return false;
  const double middle = median(near);
  for (double& value : near) value = std::abs(value - middle);
  const double spread = std::max(noise.sd[sample], 1.4826 * median(near)),
               off = std::abs(residual[sample] - middle);
  return off > far * spread && off > 2 * *std::max_element(near.begin(), near.end());
}

}  // namespace

std::size_t mark_outliers(Samples& samples, const std::vector<double>& residual, const Noise& noise) {
  constexpr double most_of_all = 0.05;
  std::vector<std::size_t> marked;
  for (const auto& run : samples.runs) {
    if (run.independent_rows) continue;
    const auto is_outlier = [&](std::size_t i, std::size_t partner) {
      return lies_far_off(samples, residual, noise, run, i, partner);
    };
    for (std::size_t i = run.begin; i < run.end; ++i) {
      if (!samples.list[i].counts) continue;
      if (is_outlier(i, i))
        marked.push_back(i);
      else if (i + 1 < run.end && samples.list[i + 1].counts && is_outlier(i, i + 1) && is_outlier(i + 1, i))
        marked.insert(marked.end(), {i, i + 1});
    }
  }
  marked.erase(std::unique(marked.begin(), marked.end()), marked.end());
  if (static_cast<double>(marked.size()) > most_of_all * static_cast<double>(samples.list.size())) return 0;
  for (const std::size_t i : marked) samples.list[i].counts = false;
  return marked.size();
}

}  // namespace asperity

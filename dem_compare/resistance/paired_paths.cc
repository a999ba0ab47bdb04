#include "dem_compare/resistance/paired_paths.h"

#include <algorithm>
#include <cmath>

#include "dem_compare/cases/path_averages.h"

namespace asperity {
namespace {

using Values = std::vector<double>;
constexpr std::size_t fewest_in_common = 4;
constexpr double least_in_common = 0.5;

double mean_of(const Values& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// Of a sum over positions that go up or down, at a place between the first and the last.
double at(const Values& position, const Values& sum, double place) {
  const double direction = position.back() > position.front() ? 1 : -1;
  std::size_t i = 1;
  while (i + 1 < position.size() && direction * position[i] < direction * place) ++i;
  const double share = (place - position[i - 1]) / (position[i] - position[i - 1]);
  return sum[i - 1] + share * (sum[i] - sum[i - 1]);
}

/// Error of the mean of `deviations`, and what both balances leave open where they are of the whole.
double error_of(const Values& deviations, DissipationPart part, double unbalanced, double other_unbalanced) {
  const double of_blocks = mean_of_blocks(deviations).sd;
  return part == DissipationPart::total ? std::hypot(of_blocks, unbalanced, other_unbalanced) : of_blocks;
}

/// NaN where the history tells no energies.
double open_balance(const SteadyPath& path) { return std::isfinite(path.unbalanced) ? path.unbalanced : 0; }

}  // namespace

std::vector<Values> rates_in_common(const std::vector<const SteadyPath*>& paths, DissipationPart part) {
  if (paths.empty()) return {};
  const auto which = static_cast<std::size_t>(part);
  const auto goes_up = [](const PathSums& sums) { return sums.position.back() > sums.position.front(); };
  double begin = -INFINITY, end = INFINITY, block = 0, longest = 0;
  std::size_t fewest_steps = SIZE_MAX;
  for (const auto* path : paths) {
    const PathSums& sums = path->sums;
    if (sums.position.size() < 2 || sums.energy[which].empty() ||
        goes_up(sums) != goes_up(paths.front()->sums))
      return {};
    const auto [low, high] = std::minmax(sums.position.front(), sums.position.back());
    begin = std::max(begin, low), end = std::min(end, high);
    block = std::max(block, sums.block), longest = std::max(longest, high - low);
    fewest_steps = std::min(fewest_steps, sums.position.size() - 1);
  }
  if (!(end - begin >= least_in_common * longest)) return {};
  const auto count = std::max(static_cast<std::size_t>(std::lround((end - begin) / block)), fewest_in_common);
  if (count > fewest_steps) return {};
  std::vector<Values> rates;
  for (const auto* path : paths) {
    Values own;
    const double length = (end - begin) / static_cast<double>(count),
                 direction = goes_up(path->sums) ? 1 : -1;
    for (std::size_t k = 0; k < count; ++k) {
      const auto sum_at = [&](std::size_t boundary) {
        return at(path->sums.position, path->sums.energy[which],
                  begin + length * static_cast<double>(boundary));
      };
      own.push_back(direction * (sum_at(k + 1) - sum_at(k)) / length);
    }
    rates.push_back(std::move(own));
  }
  return rates;
}

Uncertain paired_difference(const SteadyPath& one, const SteadyPath& other, DissipationPart part) {
  const auto rates = rates_in_common({&one, &other}, part);
  if (rates.empty()) return one.of(part) - other.of(part);
  Values differences;
  for (std::size_t k = 0; k < rates[0].size(); ++k) differences.push_back(rates[0][k] - rates[1][k]);
  return {mean_of(differences), error_of(differences, part, open_balance(one), open_balance(other))};
}

Uncertain paired_ratio(const SteadyPath& one, const SteadyPath& other) {
  const auto rates = rates_in_common({&one, &other}, DissipationPart::total);
  if (rates.empty()) return ratio(one.resistance(), other.resistance());
  const double below = mean_of(rates[1]), value = mean_of(rates[0]) / below;
  Values deviations;
  for (std::size_t k = 0; k < rates[0].size(); ++k) deviations.push_back(rates[0][k] - value * rates[1][k]);
  return {value,
          error_of(deviations, DissipationPart::total, open_balance(one), value * open_balance(other)) /
              std::abs(below)};
}

}  // namespace asperity

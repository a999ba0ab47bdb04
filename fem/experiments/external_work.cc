#include "fem/experiments/external_work.h"

#include <algorithm>
#include <array>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <optional>

namespace asperity::fem {
namespace {

constexpr double hertz_exponent = 1.5, smallest_exponent = 0.5, largest_exponent = 8;

struct State {
  double delta, force;
};

/// m for which F^(1/m) is a straight line through three states of a branch; none if they do not rise
/// together.
std::optional<double> exponent(std::array<State, 3> s) {
  std::sort(s.begin(), s.end(), [](const State& a, const State& b) { return a.force < b.force; });
  if (!(s[0].force >= 0 && s[0].force < s[1].force && s[1].force < s[2].force && s[0].delta < s[1].delta &&
        s[1].delta < s[2].delta))
    return std::nullopt;
  const double place = (s[1].delta - s[0].delta) / (s[2].delta - s[0].delta);
  const auto off = [&](double m) {
    const double low = std::pow(s[0].force, 1 / m), high = std::pow(s[2].force, 1 / m);
    return (std::pow(s[1].force, 1 / m) - low) / (high - low) - place;
  };
  if (off(smallest_exponent) * off(largest_exponent) > 0) return std::nullopt;
  const auto [low, high] = boost::math::tools::bisect(off, smallest_exponent, largest_exponent,
                                                      boost::math::tools::eps_tolerance<double>(30));
  return 0.5 * (low + high);
}

double between(const State& a, const State& b, double m) {
  const double low = std::pow(std::max(0.0, a.force), 1 / m), high = std::pow(std::max(0.0, b.force), 1 / m);
  if (std::abs(high - low) < 1e-9 * std::max(low, high))
    return 0.5 * (a.force + b.force) * (b.delta - a.delta);
  if (low == high) return 0;
  return (b.delta - a.delta) / (high - low) * (std::pow(high, m + 1) - std::pow(low, m + 1)) / (m + 1);
}

}  // namespace

std::vector<double> external_work(const std::vector<double>& delta, const std::vector<double>& force) {
  std::vector<State> path{{0, 0}};
  for (std::size_t k = 0; k < delta.size(); ++k) path.push_back({delta[k], force[k]});
  const auto direction = [&](std::size_t k) {
    return (path[k].force > path[k - 1].force) - (path[k].force < path[k - 1].force);
  };
  std::vector<double> work;
  double total = 0;
  for (std::size_t k = 1; k < path.size(); ++k) {
    double sum = 0;
    int count = 0;
    const auto take = [&](std::size_t middle) {
      if (const auto m = exponent({path[middle - 1], path[middle], path[middle + 1]})) sum += *m, ++count;
    };
    if (k + 1 < path.size() && direction(k + 1) == direction(k)) take(k);
    if (k > 1 && direction(k - 1) == direction(k)) take(k - 1);
    work.push_back(total += between(path[k - 1], path[k], count ? sum / count : hertz_exponent));
  }
  return work;
}

}  // namespace asperity::fem

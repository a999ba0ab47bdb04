#include "diagnosis/recording/monotonic_path.h"

#include <algorithm>

namespace asperity {

std::vector<double> nearest_rising(const std::vector<double>& values) {
  struct Pool {
    double sum = 0;
    std::size_t count = 0;
    double mean() const { return sum / static_cast<double>(count); }
  };
  std::vector<Pool> pools;
  for (const double value : values) {
    pools.push_back({value, 1});
    while (pools.size() > 1 && pools[pools.size() - 2].mean() > pools.back().mean()) {
      pools[pools.size() - 2].sum += pools.back().sum;
      pools[pools.size() - 2].count += pools.back().count;
      pools.pop_back();
    }
  }
  std::vector<double> rising;
  for (const Pool& pool : pools) rising.insert(rising.end(), pool.count, pool.mean());
  return rising;
}

std::vector<double> monotonic_path(const std::vector<double>& path, int direction) {
  constexpr double noise = 0.01;  // of the path; more is a motion of its own
  if (path.size() < 2) return path;
  std::vector<double> along;
  for (const double x : path) along.push_back(direction * x);
  double farthest = along.front(), back = 0;
  for (const double x : along) {
    farthest = std::max(farthest, x);
    back = std::max(back, farthest - x);
  }
  if (back == 0 || back > noise * (along.back() - along.front())) return path;
  along = nearest_rising(along);
  for (double& x : along) x *= direction;
  return along;
}

}  // namespace asperity

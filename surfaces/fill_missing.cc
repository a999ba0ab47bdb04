#include "surfaces/fill_missing.h"

#include <string>
#include <utility>
#include <vector>

#include "core/error.h"

namespace asperity {
namespace {

struct Level {
  int nx = 0, ny = 0;
  std::vector<double> heights;
  std::vector<std::uint8_t> known;
  std::size_t index(int ix, int iy) const { return static_cast<std::size_t>(iy) * nx + ix; }
};

/// Half the resolution: the mean of the known pixels of each 2 x 2 block.
Level coarsened(const Level& fine) {
  Level coarse;
  coarse.nx = (fine.nx + 1) / 2, coarse.ny = (fine.ny + 1) / 2;
  coarse.heights.assign(static_cast<std::size_t>(coarse.nx) * coarse.ny, 0.0);
  coarse.known.assign(coarse.heights.size(), 0);
  std::vector<int> count(coarse.heights.size(), 0);
  for (int iy = 0; iy < fine.ny; ++iy)
    for (int ix = 0; ix < fine.nx; ++ix)
      if (fine.known[fine.index(ix, iy)]) {
        coarse.heights[coarse.index(ix / 2, iy / 2)] += fine.heights[fine.index(ix, iy)];
        ++count[coarse.index(ix / 2, iy / 2)];
      }
  for (std::size_t i = 0; i < count.size(); ++i)
    if (count[i] > 0) {
      coarse.heights[i] /= count[i];
      coarse.known[i] = 1;
    }
  return coarse;
}

/// Each unknown pixel becomes the mean of its neighbours, several times (Gauss and Seidel).
void relax(Level& level) {
  constexpr int sweeps = 30;  // the coarser level has settled what is longer than a few pixels
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (int iy = 0; iy < level.ny; ++iy)
      for (int ix = 0; ix < level.nx; ++ix) {
        if (level.known[level.index(ix, iy)]) continue;
        double sum = 0;
        int neighbours = 0;
        const auto add = [&](int x, int y) {
          if (x < 0 || y < 0 || x >= level.nx || y >= level.ny) return;
          sum += level.heights[level.index(x, y)];
          ++neighbours;
        };
        add(ix - 1, iy), add(ix + 1, iy), add(ix, iy - 1), add(ix, iy + 1);
        level.heights[level.index(ix, iy)] = sum / neighbours;
      }
}

void fill(Level& level) {
  bool complete = true;
  for (const auto known : level.known) complete = complete && known;
  if (complete) return;
  Level coarse = coarsened(level);
  fill(coarse);
  for (int iy = 0; iy < level.ny; ++iy)
    for (int ix = 0; ix < level.nx; ++ix)
      if (!level.known[level.index(ix, iy)])
        level.heights[level.index(ix, iy)] = coarse.heights[coarse.index(ix / 2, iy / 2)];
  relax(level);
}

}  // namespace

Topography fill_missing(const Topography& map) {
  const std::size_t missing = map.missing_count();
  if (missing == 0) return map;
  if (missing == map.heights.size())
    throw InputError("the topography '" + map.source + "' has missing points only");
  Topography filled = map;
  Level level{map.nx, map.ny, std::move(filled.heights), std::vector<std::uint8_t>(map.missing.size())};
  for (std::size_t i = 0; i < level.known.size(); ++i) level.known[i] = !map.missing[i];
  fill(level);
  filled.heights = std::move(level.heights);
  filled.missing.clear();
  filled.source += ", " + std::to_string(missing) + " missing points filled smoothly";
  return filled;
}

}  // namespace asperity

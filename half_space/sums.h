// Sums over cells that do not depend on the number of threads: over blocks, added up in their order.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "half_space/grid.h"

namespace asperity::half_space {

/// visit(cell, sums) for each cell, several at a time; it adds to `sums`.
template <std::size_t N, typename Visit>
std::array<double, N> sums_over(std::size_t cells, const Visit& visit) {
  constexpr std::size_t block = 4096;
  const auto blocks = static_cast<long>((cells + block - 1) / block);
  std::vector<std::array<double, N>> parts(blocks);
#pragma omp parallel for schedule(static)
  for (long b = 0; b < blocks; ++b) {
    std::array<double, N> part{};
    const std::size_t end = std::min(cells, (b + 1) * block);
    for (std::size_t cell = b * block; cell < end; ++cell) visit(cell, part);
    parts[b] = part;
  }
  std::array<double, N> all{};
  for (const auto& part : parts)
    for (std::size_t n = 0; n < N; ++n) all[n] += part[n];
  return all;
}

}  // namespace asperity::half_space

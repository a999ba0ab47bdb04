// Loops that threads share: those of Intel's TBB, which deal.II uses too, so that there is one pool of them.
//
// A thread that comes late, since it slept or another process has its core, finds its share taken over: a
// shared loop costs a microsecond more than a serial one, also on a busy machine. OpenMP's threads wait for
// each other instead: some 50 us a loop where they sleep in between, and many times the loop where they spin
// and another process has a core (benchmarks/README.md).
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace asperity {

/// Calls work(first, last) for parts of 0, ..., count - 1, of `grain` members or more where there are so
/// many.
template <typename Work>
inline void for_parts(int count, int grain, const Work& work) {
  if (count <= grain) {
    if (count > 0) work(0, count);
    return;
  }
  tbb::parallel_for(tbb::blocked_range<int>(0, count, grain),
                    [&](const tbb::blocked_range<int>& part) { work(part.begin(), part.end()); });
}

/// Calls work(i) for each entry; the calls must not depend on each other.
template <typename Work>
inline void for_entries(int count, const Work& work) {
  constexpr int grain = 8192;
  for_parts(count, grain, [&](int first, int last) {
    const Work own = work;  // in registers: what entries are written to cannot change it
#pragma omp simd
    for (int i = first; i < last; ++i) own(i);
  });
}

/// visit(i, sums) for each entry, several at a time; it adds to `sums`, which are the same on any number of
/// threads: over blocks, added up in their order.
template <std::size_t N, typename Visit>
inline std::array<double, N> sums_over(std::size_t entries, const Visit& visit) {
  constexpr std::size_t block = 4096;
  const auto blocks = static_cast<int>((entries + block - 1) / block);
  std::vector<std::array<double, N>> sums_of_block(static_cast<std::size_t>(blocks));
  for_parts(blocks, 1, [&](int first, int last) {
    for (auto b = static_cast<std::size_t>(first); b < static_cast<std::size_t>(last); ++b) {
      std::array<double, N> sums{};
      const std::size_t end = std::min(entries, (b + 1) * block);
      for (std::size_t i = b * block; i < end; ++i) visit(i, sums);
      sums_of_block[b] = sums;
    }
  });
  std::array<double, N> all{};
  for (const auto& sums : sums_of_block)
    for (std::size_t n = 0; n < N; ++n) all[n] += sums[n];
  return all;
}

/// The sum of value(i) [any unit], which may change entry i on its way; the same on any number of threads.
template <typename Value>
inline double sum_over_entries(int count, const Value& value) {
  constexpr int block = 4096, grain = 2;
  const int blocks = (count + block - 1) / block;
  std::vector<double> sum_of_block(static_cast<std::size_t>(blocks));
  for_parts(blocks, grain, [&](int first, int last) {
    const Value own = value;
    for (int b = first; b < last; ++b) {
      const int end = std::min(count, (b + 1) * block);
      double sum = 0;
#pragma omp simd reduction(+ : sum)
      for (int i = b * block; i < end; ++i) sum += own(i);
      sum_of_block[static_cast<std::size_t>(b)] = sum;
    }
  });
  return std::accumulate(sum_of_block.begin(), sum_of_block.end(), 0.0);
}

}  // namespace asperity

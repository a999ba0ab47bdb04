// Loops over the entries of vectors that threads share. Sums are the same on any number of threads.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace asperity::fem {

/// Entries from which on a loop is worth a second thread.
constexpr int worth_threads = 20000;

/// Calls work(i) for each entry; the calls must not depend on each other.
template <typename Work>
inline void for_entries(int count, const Work& work) {
#pragma omp parallel for simd schedule(static) if (count > worth_threads)
  for (int i = 0; i < count; ++i) work(i);
}

/// The sum of value(i), which may change entry i on its way.
template <typename Value>
inline double sum_over_entries(int count, const Value& value) {
  constexpr int block = 4096;
  const int blocks = (count + block - 1) / block;
  std::vector<double> sums(static_cast<std::size_t>(blocks));
#pragma omp parallel for schedule(static) if (count > worth_threads)
  for (int b = 0; b < blocks; ++b) {
    const int end = std::min(count, (b + 1) * block);
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (int i = b * block; i < end; ++i) sum += value(i);
    sums[static_cast<std::size_t>(b)] = sum;
  }
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

}  // namespace asperity::fem

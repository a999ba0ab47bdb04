#include "benchmarks/hot_paths/measured_path.h"

namespace asperity::hot_paths {

void add(const char* name, void (*run)(benchmark::State&)) {
  constexpr int repetitions = 3;
  constexpr double least_seconds = 0.2;
  benchmark::RegisterBenchmark(name, run)
      ->UseRealTime()
      ->Repetitions(repetitions)
      ->MinTime(least_seconds)
      ->Unit(benchmark::kMillisecond);
}

void count(benchmark::State& state, double items, double bytes) {
  state.counters["items"] = items;
  state.counters["items/s"] = benchmark::Counter(items, benchmark::Counter::kIsIterationInvariantRate);
  if (bytes > 0)
    state.counters["bytes/s"] =
        benchmark::Counter(bytes, benchmark::Counter::kIsIterationInvariantRate, benchmark::Counter::kIs1024);
}

}  // namespace asperity::hot_paths

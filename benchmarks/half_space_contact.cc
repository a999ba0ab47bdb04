// The half-space solver on rough contacts in 512 x 512 and 1024 x 1024 cells: time of a solution from
// nothing, of its stiffness, and of one convolution.
//
//   half_space_contact [--benchmark_filter=REGEX]        OMP_NUM_THREADS=2 for two threads
#include <benchmark/benchmark.h>

#include "app/case_file.h"
#include "half_space/case_contact.h"

namespace {

using namespace asperity;
using namespace asperity::half_space;

/// The contact of rough_contact.prm, both bodies rough, elastic.
struct Scene {
  CaseInput input = read_case(ASPERITY_SOURCE_DIR "/benchmarks/rough_contact.prm");
  Grid grid;
  Field gap;
  explicit Scene(int n) : grid(square_grid(derived_half_width(input), n)), gap(gap_of_case(input, grid)) {}
  NormalContact contact() const { return {grid, Boundary::free, hertz_of(input).reduced_modulus, gap}; }
};

void solution(benchmark::State& state) {
  const Scene scene(static_cast<int>(state.range(0)));
  NormalContactSolution found;
  for (auto _ : state) found = scene.contact().at_force(scene.input.experiment.normal_load);
  const ContactShape shape = contact_shape(scene.grid, found.pressure, 1e300);
  state.counters["iterations"] = found.iterations;
  state.counters["convolutions"] = found.convolutions;
  state.counters["area_um2"] = shape.area * 1e12;
  state.counters["largest_GPa"] = shape.largest_pressure * 1e-9;
  state.counters["approach_nm"] = found.approach * 1e9;
  state.counters["error"] = found.error;
}

void kernel(benchmark::State& state) {
  const Scene scene(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(scene.contact());
}

void stiffness(benchmark::State& state) {
  const Scene scene(static_cast<int>(state.range(0)));
  const NormalContact contact = scene.contact();
  const auto found = contact.at_force(scene.input.experiment.normal_load);
  for (auto _ : state) benchmark::DoNotOptimize(contact.stiffness(found));
}

void convolution(benchmark::State& state) {
  const Scene scene(static_cast<int>(state.range(0)));
  const Compliance compliance(scene.grid, Boundary::free, 50e9);
  Field sunk;
  for (auto _ : state) compliance.apply(scene.gap, sunk);
}

void surfaces(benchmark::State& state) {
  const Scene scene(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(gap_of_case(scene.input, scene.grid));
}

BENCHMARK(solution)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(kernel)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(stiffness)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(convolution)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(surfaces)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();

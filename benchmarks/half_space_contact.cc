// The half-space solver on rough contacts in 256 x 256 to 1024 x 1024 cells: time of a solution from nothing,
// of its stiffnesses, of a separation with attraction, of a step of partial slip, and of one convolution.
//
//   half_space_contact [--benchmark_filter=REGEX]        OMP_NUM_THREADS=2 for two threads
#include <benchmark/benchmark.h>

#include <cmath>

#include "app/case_file.h"
#include "half_space/case_contact.h"
#include "half_space/partial_slip.h"

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

/// Pressed and drawn apart, with an attraction of 60 mJ/m^2 over 1 nm.
void separation(benchmark::State& state) {
  const Scene scene(static_cast<int>(state.range(0)));
  const NormalContact contact = scene.contact();
  constexpr double work = 0.06, length = 1e-9;
  const auto law = [](double gap) { return work / length * std::exp(-gap / length); };
  const AdhesiveContact adhesive(contact, {law, law, 5 * length, work});
  PullOff found;
  for (auto _ : state) found = adhesive.pull_off(adhesive.at_force(scene.input.experiment.normal_load));
  state.counters["states"] = found.states;
  state.counters["pull_off_nN"] = found.force * 1e9;
}

/// Stuck together and shifted.
void lateral_stiffness(benchmark::State& state) {
  const Scene scene(static_cast<int>(state.range(0)));
  const auto pressure = scene.contact().at_force(scene.input.experiment.normal_load).pressure;
  const StuckContact stuck(scene.grid, shear_compliance(scene.input));
  for (auto _ : state) benchmark::DoNotOptimize(stuck.lateral_stiffness(pressure));
}

/// One step from rest to where about half of it slips, under a friction coefficient of 0.3.
void partial_slip(benchmark::State& state) {
  const Scene scene(static_cast<int>(state.range(0)));
  Field limit = scene.contact().at_force(scene.input.experiment.normal_load).pressure;
  const StuckContact stuck(scene.grid, shear_compliance(scene.input));
  const double stiffness = stuck.lateral_stiffness(limit);
  for (double& value : limit) value *= 0.3;
  const PartialSlip slip(stuck, limit);
  SlipState found;
  for (auto _ : state) found = slip.shifted(slip.at_rest(), 0.75 * slip.full_slip() / stiffness, 0);
  state.counters["iterations"] = found.iterations;
  state.counters["slipping"] = found.slipping;
}

BENCHMARK(separation)->Arg(256)->Arg(512)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(lateral_stiffness)->Arg(256)->Arg(512)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(partial_slip)->Arg(256)->Arg(512)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(solution)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(kernel)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(stiffness)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(convolution)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(surfaces)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();

// Laws that a diagnosis evaluates sample by sample, some million times a recording, each against Hertz' law
// in the same run: what is compared are times per sample, so that another machine cancels out.
//
//   diagnosis_laws [--benchmark_filter=REGEX]
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "diagnosis/catalogue/effect.h"

namespace {

using namespace asperity;

constexpr int samples = 240;

Experiment sphere_on_wafer() {
  Experiment e;
  e.particle = {71e9, 0.17};
  e.substrate = {179e9, 0.25};
  e.radius = 8.5e-6;
  e.largest_force = 3e-3;
  e.largest_displacement = e.hertz().approach(e.largest_force);
  e.duration = 100;
  return e;
}

/// Pressed and drawn back once.
void press(benchmark::State& state, const std::string& effect, const std::vector<double>& parameters) {
  Mechanics m;
  m.experiment = sphere_on_wafer();
  m.geometry = m.experiment.hertz();
  m.normal.contact = std::make_shared<HertzContact>(m.geometry);
  if (!effect.empty()) effect_of(effect).assemble(m, parameters.data());
  const double depth = m.experiment.largest_displacement;
  for (auto _ : state) {
    const auto contact = m.normal.contact->clone();
    for (int i = 1; i <= samples; ++i) {
      const double d = depth * (i <= samples / 2 ? i : samples - i) / (samples / 2);
      contact->begin_step(m.experiment.duration / samples);
      benchmark::DoNotOptimize(contact->force(d));
      contact->accept(d);
    }
  }
  state.SetItemsProcessed(state.iterations() * samples);
}

BENCHMARK_CAPTURE(press, hertz, "", std::vector<double>{});
BENCHMARK_CAPTURE(press, adhesion, "adhesion", std::vector<double>{60e-6, 0.5});
BENCHMARK_CAPTURE(press, adhesion_hysteresis, "adhesion_hysteresis", std::vector<double>{0.1, 0.4, 0.9});
BENCHMARK_CAPTURE(press, bulk_plasticity, "bulk_plasticity", std::vector<double>{1e9, 2.84});
BENCHMARK_CAPTURE(press, film, "film", std::vector<double>{20e-9, 0.5});
BENCHMARK_CAPTURE(press, viscoelasticity, "viscoelasticity", std::vector<double>{0.4, 10.0});

}  // namespace

BENCHMARK_MAIN();

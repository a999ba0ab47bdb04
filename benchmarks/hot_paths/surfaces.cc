// Surfaces: made, transformed, measured and sampled.
#include <cmath>

#include "benchmarks/hot_paths/measured_path.h"
#include "surfaces/fft2d.h"
#include "surfaces/generate.h"
#include "surfaces/sampler.h"
#include "surfaces/spectrum.h"

namespace asperity::hot_paths {
namespace {

constexpr int pixels = 1024;
const SelfAffineSpectrum spectrum{1.5e-9, 0.8, 200e-9, 20e-9};
Topography surface() {
  GenerateOptions options;
  options.nx = options.ny = pixels;
  options.lx = options.ly = 5e-6;
  options.rms = spectrum.rms;
  return generate_periodic(spectrum, options);
}
void fourier_transform(benchmark::State& state) {
  const Topography map = surface();
  for (auto _ : state) benchmark::DoNotOptimize(forward_fft(map.heights, pixels, pixels));
  count(state, pixels * pixels);
}
void surface_generation(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(surface());
  count(state, pixels * pixels);
}
void power_spectrum(benchmark::State& state) {
  const Topography map = surface();
  for (auto _ : state) benchmark::DoNotOptimize(radial_spectrum(map));
  count(state, pixels * pixels);
}
void sampler_set_up(benchmark::State& state) {
  const Topography map = surface();
  for (auto _ : state) benchmark::DoNotOptimize(HeightSampler(map));
  count(state, pixels * pixels);
}
void height_samples(benchmark::State& state) {
  const HeightSampler sampler(surface());
  constexpr int points = 10000;
  double sum = 0;
  for (auto _ : state)
    for (int k = 0; k < points; ++k)
      sum += sampler.height(5e-7 * std::sin(0.7 * k), 5e-7 * std::cos(1.1 * k));
  benchmark::DoNotOptimize(sum);
  count(state, points);
}

}  // namespace

void add_surfaces() {
  add("surface generation", surface_generation);
  add("power spectrum", power_spectrum);
  add("Fourier transform", fourier_transform);
  add("sampler set-up", sampler_set_up);
  add("height samples", height_samples);
}

}  // namespace asperity::hot_paths

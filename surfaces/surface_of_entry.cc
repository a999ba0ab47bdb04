#include "surfaces/surface_of_entry.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/quantity.h"
#include "surfaces/fft2d.h"
#include "surfaces/scan_spec.h"
#include "surfaces/spectrum.h"
#include "surfaces/statistics.h"
#include "surfaces/virtual_afm.h"

namespace asperity {
namespace {

constexpr double pixels_per_cutoff = 4;

}  // namespace

SelfAffineSpectrum surface_spectrum(const GeneratorParameters& parameters) {
  const SelfAffineSpectrum& spectrum = parameters.spectrum;
  if (!(parameters.window > 0 && spectrum.rms > 0)) return spectrum;
  AfmSettings afm;
  afm.size = parameters.window;
  return calibrated(spectrum, spectrum.rms, afm);
}

double default_period(const SelfAffineSpectrum& spectrum) {
  constexpr double most_rolloffs = 64, fewest_rolloffs = 8, pixels = 2048;
  const double carried = pixels / pixels_per_cutoff * spectrum.cutoff;
  return std::max(fewest_rolloffs * spectrum.rolloff, std::min(most_rolloffs * spectrum.rolloff, carried));
}

GeneratorGrid generator_grid(const GeneratorParameters& parameters) {
  constexpr int largest = 16384;  // 2 GiB of heights
  GeneratorGrid grid{parameters.size > 0 ? parameters.size : default_period(parameters.spectrum), 0};
  const double pixels = pixels_per_cutoff * grid.period / parameters.spectrum.cutoff;
  if (pixels > largest)
    throw InputError("'" + parameters.text() + "' over " + format_quantity(grid.period, Dimension::length) +
                     " needs more than " + std::to_string(largest) +
                     " pixels a side; take a longer cutoff, a shorter rolloff or a smaller size");
  grid.pixels = fast_fft_length(pixels);
  return grid;
}

namespace {

/// Sets the scales of a scan's waves: see TopographyScales.
void find_scan_waves(const Topography& map, TopographyScales& scales) {
  constexpr double resolved_share = 0.99, pixels_per_wave = 4;
  const RadialSpectrum spectrum = radial_spectrum(map);
  double total = 0, above = 0;
  const auto slope_variance = [&](std::size_t ring) {
    return std::pow(spectrum.q[ring], 3) * spectrum.C[ring];
  };
  for (std::size_t ring = 0; ring < spectrum.q.size(); ++ring) total += slope_variance(ring);
  if (!(total > 0)) return;
  const double shortest_measured = pixels_per_wave * std::max(map.dx(), map.dy());
  std::size_t last = 0;
  for (; last < spectrum.q.size(); ++last) {
    above += slope_variance(last);
    const bool next_is_measured =
        last + 1 < spectrum.q.size() && 2 * M_PI / spectrum.q[last + 1] >= shortest_measured;
    if (above >= resolved_share * total || !next_is_measured) break;
  }
  scales.shortest_wave = 2 * M_PI / spectrum.q[std::min(last, spectrum.q.size() - 1)];
  scales.unresolved = std::max(0.0, 1 - above / total);
}

Topography generated(const GeneratorParameters& parameters) {
  const GeneratorGrid grid = generator_grid(parameters);
  GenerateOptions options;
  options.nx = options.ny = grid.pixels;
  options.lx = options.ly = grid.period;
  options.seed = parameters.seed;
  options.amplitudes = parameters.amplitudes;
  // A calibrated spectrum keeps its own magnitude: scaling this period to its rms would put the waves too
  // long for the period into the shorter ones.
  options.rms = parameters.window > 0 ? -1 : parameters.spectrum.rms;
  Topography map = generate_periodic(surface_spectrum(parameters), options);
  map.source = parameters.text();
  return map;
}

Topography smooth_surface() {
  Topography flat;
  flat.nx = flat.ny = 1;
  flat.lx = flat.ly = 1;
  flat.heights = {0.0};
  flat.periodic = true;
  flat.source = "smooth";
  return flat;
}

}  // namespace

TopographyScales topography_scales(const TopographySpec& spec) {
  TopographyScales scales;
  if (const auto* generator = spec.generator()) {
    if (generator->spectrum.rms > 0)
      scales = {generator->spectrum.rms, generator->spectrum.cutoff, 0, generator_grid(*generator).period};
  } else if (const auto* scan = spec.scan()) {
    const Topography map = prepared_scan(*scan);
    scales.rms = height_moments(map).Sq;
    if (scan->cutoff > 0)
      scales.shortest_wave = scan->cutoff;
    else
      find_scan_waves(map, scales);
  }
  return scales;
}

Topography topography_for(const TopographySpec& spec) {
  if (spec.generator()) return generated(*spec.generator());
  return spec.scan() ? prepared_scan(*spec.scan()) : smooth_surface();
}

HeightSampler heights_over(const TopographySpec& spec, double size) {
  const Topography map = topography_for(spec);
  if (!spec.scan()) return HeightSampler(map);
  require_cover(*spec.scan(), map, size);
  return HeightSampler(map, spec.scan()->outside);
}

}  // namespace asperity

#include "surfaces/topography_spec.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/error.h"
#include "core/quantity.h"
#include "surfaces/entry_call.h"
#include "surfaces/fft2d.h"
#include "surfaces/scan_spec.h"
#include "surfaces/spectrum.h"
#include "surfaces/statistics.h"
#include "surfaces/virtual_afm.h"

namespace asperity {
namespace {

const std::string call = "generated";
const std::string known_keys = "rms, window, hurst, rolloff, cutoff, size, seed, amplitudes";
constexpr double pixels_per_cutoff = 4;
const std::string example = "generated(rms=1.5 nm, hurst=0.8, rolloff=200 nm, cutoff=20 nm, seed=3)";

std::uint64_t parse_seed(const std::string& value) {
  if (value.empty() || value.size() > 18 ||
      !std::all_of(value.begin(), value.end(), [](unsigned char c) { return std::isdigit(c); }))
    throw InputError("'" + value + "' is not a whole number from 0 on");
  return std::stoull(value);
}

Amplitudes parse_amplitudes(const std::string& value) {
  if (value == "random") return Amplitudes::random;
  if (value == "fixed") return Amplitudes::fixed;
  throw InputError("'" + value + "' is neither random nor fixed");
}

double parse_side(const std::string& value) {
  const double side = parse_quantity(value, Dimension::length);
  if (!(side > 0 && std::isfinite(side))) throw InputError("'" + value + "' is no side of a square; write a length above 0, such as 2.5 um");
  return side;
}

void set_entry(GeneratorParameters& parameters, const std::string& key, const std::string& value) {
  if (key == "rms")
    parameters.spectrum.rms = parse_quantity(value, Dimension::length);
  else if (key == "window")
    parameters.window = parse_side(value);
  else if (key == "hurst")
    parameters.spectrum.hurst = parse_quantity(value, Dimension::none);
  else if (key == "rolloff")
    parameters.spectrum.rolloff = parse_quantity(value, Dimension::length);
  else if (key == "cutoff")
    parameters.spectrum.cutoff = parse_quantity(value, Dimension::length);
  else if (key == "size")
    parameters.size = parse_side(value);
  else if (key == "seed")
    parameters.seed = parse_seed(value);
  else if (key == "amplitudes")
    parameters.amplitudes = parse_amplitudes(value);
  else
    throw InputError("there is no such entry; those known are " + known_keys);
}

}  // namespace

SelfAffineSpectrum GeneratorParameters::surface_spectrum() const {
  if (!(window > 0 && spectrum.rms > 0)) return spectrum;
  AfmSettings afm;
  afm.size = window;
  return calibrated(spectrum, spectrum.rms, afm);
}

std::string GeneratorParameters::text() const {
  const auto length = [](double value) { return format_quantity(value, Dimension::length, 6); };
  return call + "(rms=" + length(spectrum.rms) + (window > 0 ? ", window=" + length(window) : "") +
         ", hurst=" + format_quantity(spectrum.hurst, Dimension::none) +
         ", rolloff=" + length(spectrum.rolloff) + ", cutoff=" + length(spectrum.cutoff) +
         (size > 0 ? ", size=" + length(size) : "") + ", seed=" + std::to_string(seed) + (amplitudes == Amplitudes::fixed ? ", amplitudes=fixed)" : ")");
}

bool is_generator_call(const std::string& spec) { return is_entry_call(spec, call); }

bool is_scan(const std::string& spec) {
  return without_outer_blanks(spec) != "smooth" && !is_generator_call(spec);
}

GeneratorParameters parse_generator(const std::string& spec) {
  GeneratorParameters parameters;
  bool has_rms = false;
  read_entry_call(spec, call, example, [&](const std::string& key, const std::string& value) {
    if (key.empty()) throw InputError("it lacks '=' and a value; write for example " + example);
    has_rms = has_rms || key == "rms";
    set_entry(parameters, key, value);
  });
  if (!has_rms) throw InputError("'" + spec + "' lacks the entry 'rms'; write for example " + example);
  try {
    parameters.spectrum.check();
  } catch (const InputError& error) {
    throw InputError("in '" + spec + "' " + error.what());
  }
  if (parameters.size > 0 && parameters.size < 2 * parameters.spectrum.rolloff)
    throw InputError("in '" + spec + "' size holds fewer than two waves of the rolloff; leave it out or make it larger");
  return parameters;
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
    throw InputError("'" + parameters.text() + "' over " + format_quantity(grid.period, Dimension::length) + " needs more than " +
                     std::to_string(largest) + " pixels a side; take a longer cutoff, a shorter rolloff or a smaller size");
  grid.pixels = fast_fft_length(pixels);
  return grid;
}

namespace {

/// Sets the scales of a scan's waves: see TopographyScales.
void find_scan_waves(const Topography& map, TopographyScales& scales) {
  constexpr double resolved_share = 0.99, pixels_per_wave = 4;
  const RadialSpectrum spectrum = radial_spectrum(map);
  double total = 0, above = 0;
  const auto slope_variance = [&](std::size_t ring) { return std::pow(spectrum.q[ring], 3) * spectrum.C[ring]; };
  for (std::size_t ring = 0; ring < spectrum.q.size(); ++ring) total += slope_variance(ring);
  if (!(total > 0)) return;
  const double shortest_measured = pixels_per_wave * std::max(map.dx(), map.dy());
  std::size_t last = 0;
  for (; last < spectrum.q.size(); ++last) {
    above += slope_variance(last);
    const bool next_is_measured = last + 1 < spectrum.q.size() && 2 * M_PI / spectrum.q[last + 1] >= shortest_measured;
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
  // A calibrated spectrum keeps its own magnitude: scaling this period to its rms would put the waves too long for the
  // period into the shorter ones.
  options.rms = parameters.window > 0 ? -1 : parameters.spectrum.rms;
  Topography map = generate_periodic(parameters.surface_spectrum(), options);
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

TopographyScales topography_scales(const std::string& spec) {
  TopographyScales scales;
  if (is_generator_call(spec)) {
    const GeneratorParameters parameters = parse_generator(spec);
    if (parameters.spectrum.rms > 0)
      scales = {parameters.spectrum.rms, parameters.spectrum.cutoff, 0, generator_grid(parameters).period};
  } else if (is_scan(spec)) {
    const Topography map = prepared_scan(spec);
    scales.rms = height_moments(map).Sq;
    const double cutoff = parse_scan(spec).cutoff;
    if (cutoff > 0) scales.shortest_wave = cutoff;
    else find_scan_waves(map, scales);
  }
  return scales;
}

Topography topography_for(const std::string& spec) {
  const std::string text = without_outer_blanks(spec);
  if (text == "smooth") return smooth_surface();
  return is_generator_call(text) ? generated(parse_generator(text)) : prepared_scan(text);
}

HeightSampler heights_over(const std::string& spec, double size) {
  const Topography map = topography_for(spec);
  if (!is_scan(spec)) return HeightSampler(map);
  require_cover(spec, map, size);
  return HeightSampler(map, parse_scan(spec).outside);
}

}  // namespace asperity

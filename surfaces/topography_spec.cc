#include "surfaces/topography_spec.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/error.h"
#include "core/quantity.h"
#include "surfaces/entry_call.h"
#include "surfaces/fft2d.h"
#include "surfaces/scan_spec.h"
#include "surfaces/statistics.h"
#include "surfaces/virtual_afm.h"

namespace asperity {
namespace {

const std::string call = "generated";
const std::string known_keys = "rms, window, hurst, rolloff, cutoff, seed, amplitudes";
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

double parse_window(const std::string& value) {
  const double window = parse_quantity(value, Dimension::length);
  if (!(window > 0 && std::isfinite(window)))
    throw InputError("'" + value + "' is no side of a scan; write a length above 0, such as 2.5 um");
  return window;
}

void set_entry(GeneratorParameters& parameters, const std::string& key, const std::string& value) {
  if (key == "rms")
    parameters.spectrum.rms = parse_quantity(value, Dimension::length);
  else if (key == "window")
    parameters.window = parse_window(value);
  else if (key == "hurst")
    parameters.spectrum.hurst = parse_quantity(value, Dimension::none);
  else if (key == "rolloff")
    parameters.spectrum.rolloff = parse_quantity(value, Dimension::length);
  else if (key == "cutoff")
    parameters.spectrum.cutoff = parse_quantity(value, Dimension::length);
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
         ", seed=" + std::to_string(seed) + (amplitudes == Amplitudes::fixed ? ", amplitudes=fixed)" : ")");
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
  return parameters;
}

GeneratorGrid generator_grid(const GeneratorParameters& parameters, double size) {
  constexpr double periods_of_rolloff = 8, pixels_per_cutoff = 4;
  constexpr int largest = 16384;  // 2 GiB of heights
  GeneratorGrid grid{periods_of_rolloff * parameters.spectrum.rolloff, 0};
  while (grid.period < size) grid.period *= 2;
  const double pixels = pixels_per_cutoff * grid.period / parameters.spectrum.cutoff;
  if (pixels > largest)
    throw InputError("'" + parameters.text() + "' over " +
                     format_quantity(std::max(size, grid.period), Dimension::length) + " needs more than " +
                     std::to_string(largest) +
                     " pixels a side; take a longer cutoff, a shorter rolloff or a smaller region");
  grid.pixels = fast_fft_length(pixels);
  return grid;
}

TopographyScales topography_scales(const std::string& spec) {
  TopographyScales scales;
  if (is_generator_call(spec)) {
    const SelfAffineSpectrum spectrum = parse_generator(spec).spectrum;
    scales = {spectrum.rms, spectrum.cutoff};
  } else if (is_scan(spec)) {
    scales.rms = height_moments(prepared_scan(spec)).Sq;
    const double cutoff = parse_scan(spec).cutoff;
    if (cutoff > 0) scales.shortest_wave = cutoff;
  }
  return scales;
}

Topography topography_for(const std::string& spec, double size, double /*spacing*/) {
  const std::string text = without_outer_blanks(spec);
  if (text == "smooth") {
    Topography flat;
    flat.nx = flat.ny = 1;
    flat.lx = flat.ly = size;
    flat.heights = {0.0};
    flat.periodic = true;
    flat.source = "smooth";
    return flat;
  }
  if (is_generator_call(text)) {
    const GeneratorParameters parameters = parse_generator(text);
    const GeneratorGrid grid = generator_grid(parameters, size);
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
  return scan_over(text, size);
}

}  // namespace asperity

#include "surfaces/topography_spec.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "core/error.h"
#include "core/quantity.h"
#include "surfaces/fft2d.h"
#include "surfaces/levelling.h"
#include "surfaces/read_topography.h"

namespace asperity {
namespace {

const std::string call = "generated";
const std::string known_keys = "rms, hurst, rolloff, cutoff, seed, amplitudes";

std::string trimmed(const std::string& text) {
  const auto is_space = [](unsigned char c) { return std::isspace(c); };
  const auto first = std::find_if_not(text.begin(), text.end(), is_space);
  const auto last = std::find_if_not(text.rbegin(), std::make_reverse_iterator(first), is_space).base();
  return std::string(first, last);
}

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

void set_entry(GeneratorParameters& parameters, const std::string& key, const std::string& value) {
  if (key == "rms")
    parameters.spectrum.rms = parse_quantity(value, Dimension::length);
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

std::string GeneratorParameters::text() const {
  const auto length = [](double value) { return format_quantity(value, Dimension::length, 6); };
  return call + "(rms=" + length(spectrum.rms) +
         ", hurst=" + format_quantity(spectrum.hurst, Dimension::none) +
         ", rolloff=" + length(spectrum.rolloff) + ", cutoff=" + length(spectrum.cutoff) +
         ", seed=" + std::to_string(seed) + (amplitudes == Amplitudes::fixed ? ", amplitudes=fixed)" : ")");
}

bool is_generator_call(const std::string& spec) {
  const std::string text = trimmed(spec);
  if (text.compare(0, call.size(), call) != 0) return false;
  const std::string rest = trimmed(text.substr(call.size()));
  return rest.empty() || rest.front() == '(';
}

GeneratorParameters parse_generator(const std::string& spec) {
  const std::string text = trimmed(spec);
  const std::string example =
      "; write for example generated(rms=1.5 nm, hurst=0.8, rolloff=200 nm, cutoff=20 nm, seed=3)";
  const auto open = text.find('(');
  if (!is_generator_call(text) || open == std::string::npos || text.back() != ')')
    throw InputError("'" + spec + "' is not a call of the generator" + example);

  GeneratorParameters parameters;
  std::set<std::string> seen;
  const std::string arguments = trimmed(text.substr(open + 1, text.size() - open - 2));
  for (std::size_t begin = 0; begin < arguments.size();) {
    const std::size_t end = std::min(arguments.find(',', begin), arguments.size());
    const std::string entry = trimmed(arguments.substr(begin, end - begin));
    begin = end + 1;
    const auto equals = entry.find('=');
    if (equals == std::string::npos)
      throw InputError("in '" + spec + "' the entry '" + entry + "' lacks '=' and a value" + example);
    const std::string key = trimmed(entry.substr(0, equals)), value = trimmed(entry.substr(equals + 1));
    if (!seen.insert(key).second) throw InputError("in '" + spec + "' the entry '" + key + "' stands twice");
    try {
      set_entry(parameters, key, value);
    } catch (const InputError& error) {
      throw InputError("in '" + spec + "' at '" + key + "': " + error.what());
    }
  }
  if (!seen.count("rms")) throw InputError("'" + spec + "' lacks the entry 'rms'" + example);
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

Topography topography_for(const std::string& spec, double size, double /*spacing*/) {
  const std::string text = trimmed(spec);
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
    options.rms = parameters.spectrum.rms;
    Topography map = generate_periodic(parameters.spectrum, options);
    map.source = parameters.text();
    return map;
  }
  Topography map = levelled(read_topography(text), Level::plane);
  map.source += ", mean plane removed";
  if (map.lx < size || map.ly < size)
    throw InputError("the topography '" + text + "' covers " + format_quantity(map.lx, Dimension::length) +
                     " x " + format_quantity(map.ly, Dimension::length) + " but a region of " +
                     format_quantity(size, Dimension::length) +
                     " is needed; take a larger map or a smaller contact region");
  return map;
}

}  // namespace asperity

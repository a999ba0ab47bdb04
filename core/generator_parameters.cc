#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/entry_call.h"
#include "core/error.h"
#include "core/quantity.h"
#include "core/topography_spec.h"

namespace asperity {
namespace {

const std::string call = "generated";
const std::string known_keys = "rms, window, hurst, rolloff, cutoff, size, seed, amplitudes";
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
  if (!(side > 0 && std::isfinite(side)))
    throw InputError("'" + value + "' is no side of a square; write a length above 0, such as 2.5 um");
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

std::string text_of(const GeneratorParameters& generator, const std::string& seed) {
  const auto length = [](double value) { return format_quantity(value, Dimension::length, 6); };
  const SelfAffineSpectrum& spectrum = generator.spectrum;
  return call + "(rms=" + length(spectrum.rms) +
         (generator.window > 0 ? ", window=" + length(generator.window) : "") +
         ", hurst=" + format_quantity(spectrum.hurst, Dimension::none) +
         ", rolloff=" + length(spectrum.rolloff) + ", cutoff=" + length(spectrum.cutoff) +
         (generator.size > 0 ? ", size=" + length(generator.size) : "") + seed +
         (generator.amplitudes == Amplitudes::fixed ? ", amplitudes=fixed)" : ")");
}

}  // namespace

std::string GeneratorParameters::text() const { return text_of(*this, ", seed=" + std::to_string(seed)); }
std::string GeneratorParameters::text_without_seed() const { return text_of(*this, ""); }

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
    throw InputError("in '" + spec +
                     "' size holds fewer than two waves of the rolloff; leave it out or make it larger");
  return parameters;
}

}  // namespace asperity

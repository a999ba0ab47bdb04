#include "app/commands.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <memory>
#include <string>

#include "app/length_argument.h"
#include "core/atomic_file.h"
#include "core/error.h"
#include "core/quantity.h"
#include "surfaces/generate.h"
#include "surfaces/read_topography.h"
#include "surfaces/surface_report.h"
#include "surfaces/virtual_afm.h"

namespace asperity {
namespace {

std::string length_in_words(double value) { return format_quantity(value, Dimension::length, 4); }

// ---- measure
// ---------------------------------------------------------------------------------------------------------

struct MeasureArguments {
  std::string file, size, level = "plane", channel, height_unit, psd;
  bool json = false;
};

void measure_file(const MeasureArguments& arguments) {
  ReadOptions options;
  if (!arguments.size.empty()) {
    const auto times = arguments.size.find('x');
    options.size_x_m = length_argument("--size", arguments.size.substr(0, times));
    if (times != std::string::npos)
      options.size_y_m = length_argument("--size", arguments.size.substr(times + 1));
  }
  if (!arguments.channel.empty()) options.channel = arguments.channel;
  if (!arguments.height_unit.empty()) options.height_unit = arguments.height_unit;
  const Level level = parse_level(arguments.level);
  const SurfaceMeasurement measurement = measure_surface(read_topography(arguments.file, options), level);
  if (!arguments.psd.empty()) write_file_atomically(arguments.psd, spectrum_csv(measurement.spectrum));
  if (arguments.json)
    std::cout << to_json(measurement).dump(2) << "\n";
  else
    std::cout << to_text(measurement);
}

void add_measure(CLI::App& parent) {
  const auto arguments = std::make_shared<MeasureArguments>();
  CLI::App* command =
      parent.add_subcommand("measure", "Roughness of a scan: heights, slopes, correlation, spectrum");
  command
      ->add_option("FILE", arguments->file,
                   "The topography in any format of docs/surfaces.md, such as .gwy, .gsf, .spm, .ibw, .nid, "
                   ".jpk, .sur, .opd, "
                   ".x3p, .npy or text, also packed by gzip")
      ->required();
  command->add_option("--size", arguments->size,
                      "Physical size, such as \"2.5 um\" or \"2.5 um x 1 um\" (default: the file's)");
  command->add_option("--level", arguments->level, "mean, plane, quadratic, rows0, rows1 or rows2")
      ->capture_default_str();
  command->add_option("--channel", arguments->channel, "Name or number of the channel (default: heights)");
  command->add_option("--height-unit", arguments->height_unit, "Unit of heights in a file that names none");
  command->add_option("--psd", arguments->psd, "Also write the radial power spectral density to this .csv");
  command->add_flag("--json", arguments->json, "One JSON object instead of text");
  command->callback([arguments] { measure_file(*arguments); });
}

// ---- generate
// --------------------------------------------------------------------------------------------------------

struct GenerateArguments {
  std::string rms, size, rolloff, cutoff, psd, amplitudes = "random", output;
  double hurst = 0.8;
  int pixels = 0;
  std::int64_t seed = 0;
  bool window = false, as_measured = false;
};

double length_or_none(const char* option, const std::string& text) {
  return text.empty() ? 0 : length_argument(option, text);
}

void generate_file(const GenerateArguments& arguments) {
  if (arguments.seed < 0)
    throw InputError("--seed must be a whole number from 0 on; it is " + std::to_string(arguments.seed));
  GenerateOptions options;
  options.nx = options.ny = arguments.pixels;
  options.lx = options.ly = length_argument("--size", arguments.size);
  options.seed = static_cast<std::uint64_t>(arguments.seed);
  options.amplitudes = arguments.amplitudes == "fixed" ? Amplitudes::fixed : Amplitudes::random;

  Spectrum spectrum;
  double longest = 0;
  std::string said;
  if (!arguments.psd.empty()) {
    const TabulatedSpectrum table = read_spectrum_csv(arguments.psd);
    longest = 2 * M_PI / table.q.front();
    if (!arguments.rms.empty()) options.rms = length_argument("--rms", arguments.rms);
    if (arguments.as_measured)
      throw InputError("--as-measured goes with a spectrum of --rms, --hurst and --rolloff, not with --psd");
    spectrum = table;
    said = "spectrum of " + arguments.psd;
  } else {
    if (arguments.rms.empty())
      throw InputError("pass --rms, such as --rms \"1.5 nm\", or a measured spectrum with --psd");
    SelfAffineSpectrum model =
        spectrum_on_pixels(length_argument("--rms", arguments.rms), arguments.hurst,
                           length_or_none("--rolloff", arguments.rolloff),
                           length_or_none("--cutoff", arguments.cutoff), options.lx / options.nx);
    if (arguments.as_measured) {
      if (!arguments.window)
        throw InputError("--as-measured is meant for scans out of a larger surface: pass --window with it");
      AfmSettings afm;
      afm.size = options.lx, afm.pixels = options.nx;
      model = calibrated(model, model.rms, afm);
    }
    longest = model.rolloff, options.rms = model.rms, spectrum = model;
    said = "rms " + length_in_words(model.rms) + ", hurst " + format_quantity(model.hurst, Dimension::none) +
           ", rolloff " + length_in_words(model.rolloff) + ", cutoff " + length_in_words(model.cutoff);
  }
  Topography map =
      arguments.window ? generate_window(spectrum, longest, options) : generate_periodic(spectrum, options);
  map.source = "generated: " + said + ", seed " + std::to_string(arguments.seed) +
               (arguments.window ? ", window" : ", periodic");
  write_gsf(arguments.output, map);
  const HeightMoments moments = height_moments(map);
  std::cout << arguments.output << ": " << map.nx << " x " << map.ny << " pixels, " << length_in_words(map.lx)
            << ", " << (arguments.window ? "cut from a larger surface" : "periodic") << "\n"
            << said << ", seed " << arguments.seed << "\n"
            << "Sq of this realisation " << length_in_words(moments.Sq) << ", peak to valley "
            << length_in_words(moments.Sz) << "\n";
}

void add_generate(CLI::App& parent) {
  const auto arguments = std::make_shared<GenerateArguments>();
  CLI::App* command = parent.add_subcommand("generate", "A Gaussian surface from a spectrum, as .gsf");
  command->add_option("--rms", arguments->rms, "RMS height (Sq) of the surface, such as \"1.5 nm\"");
  command->add_option("--size", arguments->size, "Side of the square map, such as \"2.5 um\"")->required();
  command->add_option("--pixels", arguments->pixels, "Pixels along a side")
      ->required()
      ->check(CLI::Range(2, 16384));
  command->add_option("--hurst", arguments->hurst, "Hurst exponent")->capture_default_str();
  command->add_option(
      "--rolloff", arguments->rolloff,
      "Roll-off wavelength: longer waves are no higher (default 200 nm, at least ten cut-offs)");
  command->add_option("--cutoff", arguments->cutoff,
                      "Shortest wavelength (default 20 nm, at least four pixels)");
  command->add_option("--psd", arguments->psd,
                      "Spectrum measured by 'surface measure --psd' in place of hurst, rolloff, cutoff");
  command->add_option("--seed", arguments->seed, "Number of the realisation, from 0 on")->required();
  command
      ->add_option("--amplitudes", arguments->amplitudes,
                   "random: a Gaussian field; fixed: only phases are random")
      ->check(CLI::IsMember({"random", "fixed"}))
      ->capture_default_str();
  command->add_flag("--window", arguments->window,
                    "Not periodic: cut from a larger surface, which --rms then belongs to");
  command->add_flag("--as-measured", arguments->as_measured,
                    "With --window: --rms is what such scans show on average, tilt removed");
  command->add_option("--output", arguments->output, "File to write (.gsf)")->required();
  command->callback([arguments] { generate_file(*arguments); });
}

}  // namespace

void add_surface_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("surface", "Measure, generate and judge topographies");
  command->require_subcommand(1);
  add_measure(*command);
  add_generate(*command);
  add_surface_afm_command(*command);
}

}  // namespace asperity

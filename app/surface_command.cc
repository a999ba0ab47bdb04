#include "app/surface_command.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/quantity.h"
#include "surfaces/generate.h"
#include "surfaces/possible_spectra.h"
#include "surfaces/read_topography.h"
#include "surfaces/surface_report.h"
#include "surfaces/virtual_afm.h"

namespace asperity {
namespace {

double length_of(const std::string& option, const std::string& text) {
  try {
    const double value = parse_quantity(text, Dimension::length);
    if (value > 0 && std::isfinite(value)) return value;
  } catch (const InputError& error) {
    throw InputError(option + ": " + error.what());
  }
  throw InputError(option + " must be a length above 0, such as \"2.5 um\"; it is '" + text + "'");
}

std::string in_words(double value, int digits = 4) { return format_quantity(value, Dimension::length, digits); }

// ---- measure ---------------------------------------------------------------------------------------------------------

struct MeasureArguments {
  std::string file, size, level = "plane", channel, height_unit, psd;
  bool json = false;
};

void measure_file(const MeasureArguments& arguments) {
  ReadOptions options;
  if (!arguments.size.empty()) {
    const auto times = arguments.size.find('x');
    options.size_x_m = length_of("--size", arguments.size.substr(0, times));
    if (times != std::string::npos) options.size_y_m = length_of("--size", arguments.size.substr(times + 1));
  }
  if (!arguments.channel.empty()) options.channel = arguments.channel;
  if (!arguments.height_unit.empty()) options.height_unit = arguments.height_unit;
  const Level level = parse_level(arguments.level);
  const SurfaceMeasurement measurement = measure_surface(read_topography(arguments.file, options), level);
  if (!arguments.psd.empty()) write_file_atomically(arguments.psd, spectrum_csv(measurement.spectrum));
  if (arguments.json) std::cout << to_json(measurement).dump(2) << "\n";
  else std::cout << to_text(measurement);
}

void add_measure(CLI::App& parent) {
  const auto arguments = std::make_shared<MeasureArguments>();
  CLI::App* command = parent.add_subcommand("measure", "Roughness of a scan: heights, slopes, correlation, spectrum");
  command->add_option("FILE", arguments->file, "The topography: .gwy, .gsf, .spm/.di/.001, Park .tiff, .x3p, .nc, .xyz or text")
      ->required();
  command->add_option("--size", arguments->size, "Physical size, such as \"2.5 um\" or \"2.5 um x 1 um\" (default: the file's)");
  command->add_option("--level", arguments->level, "mean, plane, quadratic, rows0, rows1 or rows2")->capture_default_str();
  command->add_option("--channel", arguments->channel, "Name or number of the channel (default: heights)");
  command->add_option("--height-unit", arguments->height_unit, "Unit of heights in a text file that names none");
  command->add_option("--psd", arguments->psd, "Also write the radial power spectral density to this .csv");
  command->add_flag("--json", arguments->json, "One JSON object instead of text");
  command->callback([arguments] { measure_file(*arguments); });
}

// ---- generate --------------------------------------------------------------------------------------------------------

struct GenerateArguments {
  std::string rms, size, rolloff, cutoff, psd, amplitudes = "random", output;
  double hurst = 0.8;
  int pixels = 0;
  std::int64_t seed = 0;
  bool window = false, as_measured = false;
};

/// The spectrum asked for; what is not given follows from the pixels: cut-off 20 nm but not below four pixels, roll-off
/// 200 nm but not below ten cut-offs.
SelfAffineSpectrum model_of(const GenerateArguments& arguments, double spacing) {
  constexpr double usual_cutoff = 20e-9, usual_rolloff = 200e-9, pixels_per_cutoff = 4, cutoffs_per_rolloff = 10;
  SelfAffineSpectrum model;
  model.rms = length_of("--rms", arguments.rms);
  model.hurst = arguments.hurst;
  model.cutoff = arguments.cutoff.empty() ? std::max(usual_cutoff, pixels_per_cutoff * spacing) : length_of("--cutoff", arguments.cutoff);
  model.rolloff = arguments.rolloff.empty() ? std::max(usual_rolloff, cutoffs_per_rolloff * model.cutoff)
                                            : length_of("--rolloff", arguments.rolloff);
  model.check();
  constexpr double pixels_per_wave = 2;
  if (model.cutoff < pixels_per_wave * spacing * (1 - 1e-9))
    throw InputError("a cutoff of " + in_words(model.cutoff) + " needs pixels of at most half of it, but they are " +
                     in_words(spacing) + "; pass more --pixels or a longer --cutoff");
  return model;
}

void generate_file(const GenerateArguments& arguments) {
  if (arguments.seed < 0) throw InputError("--seed must be a whole number from 0 on; it is " + std::to_string(arguments.seed));
  GenerateOptions options;
  options.nx = options.ny = arguments.pixels;
  options.lx = options.ly = length_of("--size", arguments.size);
  options.seed = static_cast<std::uint64_t>(arguments.seed);
  options.amplitudes = arguments.amplitudes == "fixed" ? Amplitudes::fixed : Amplitudes::random;

  Spectrum spectrum;
  double longest = 0;
  std::string said;
  if (!arguments.psd.empty()) {
    const TabulatedSpectrum table = read_spectrum_csv(arguments.psd);
    longest = 2 * M_PI / table.q.front();
    if (!arguments.rms.empty()) options.rms = length_of("--rms", arguments.rms);
    if (arguments.as_measured) throw InputError("--as-measured goes with a spectrum of --rms, --hurst and --rolloff, not with --psd");
    spectrum = table;
    said = "spectrum of " + arguments.psd;
  } else {
    if (arguments.rms.empty()) throw InputError("pass --rms, such as --rms \"1.5 nm\", or a measured spectrum with --psd");
    SelfAffineSpectrum model = model_of(arguments, options.lx / options.nx);
    if (arguments.as_measured) {
      if (!arguments.window) throw InputError("--as-measured is meant for scans out of a larger surface: pass --window with it");
      AfmSettings afm;
      afm.size = options.lx, afm.pixels = options.nx;
      model = calibrated(model, model.rms, afm);
    }
    longest = model.rolloff, options.rms = model.rms, spectrum = model;
    said = "rms " + in_words(model.rms) + ", hurst " + format_quantity(model.hurst, Dimension::none) + ", rolloff " +
           in_words(model.rolloff) + ", cutoff " + in_words(model.cutoff);
  }
  Topography map = arguments.window ? generate_window(spectrum, longest, options) : generate_periodic(spectrum, options);
  map.source = "generated: " + said + ", seed " + std::to_string(arguments.seed) + (arguments.window ? ", window" : ", periodic");
  write_gsf(arguments.output, map);
  const HeightMoments moments = height_moments(map);
  std::cout << arguments.output << ": " << map.nx << " x " << map.ny << " pixels, " << in_words(map.lx) << ", "
            << (arguments.window ? "cut from a larger surface" : "periodic") << "\n"
            << said << ", seed " << arguments.seed << "\n"
            << "Sq of this realisation " << in_words(moments.Sq) << ", peak to valley " << in_words(moments.Sz) << "\n";
}

void add_generate(CLI::App& parent) {
  const auto arguments = std::make_shared<GenerateArguments>();
  CLI::App* command = parent.add_subcommand("generate", "A Gaussian surface from a spectrum, as .gsf");
  command->add_option("--rms", arguments->rms, "RMS height (Sq) of the surface, such as \"1.5 nm\"");
  command->add_option("--size", arguments->size, "Side of the square map, such as \"2.5 um\"")->required();
  command->add_option("--pixels", arguments->pixels, "Pixels along a side")->required()->check(CLI::Range(2, 16384));
  command->add_option("--hurst", arguments->hurst, "Hurst exponent")->capture_default_str();
  command->add_option("--rolloff", arguments->rolloff,
                      "Roll-off wavelength: longer waves are no higher (default 200 nm, at least ten cut-offs)");
  command->add_option("--cutoff", arguments->cutoff, "Shortest wavelength (default 20 nm, at least four pixels)");
  command->add_option("--psd", arguments->psd, "Spectrum measured by 'surface measure --psd' in place of hurst, rolloff, cutoff");
  command->add_option("--seed", arguments->seed, "Number of the realisation, from 0 on")->required();
  command->add_option("--amplitudes", arguments->amplitudes, "random: a Gaussian field; fixed: only phases are random")
      ->check(CLI::IsMember({"random", "fixed"}))
      ->capture_default_str();
  command->add_flag("--window", arguments->window, "Not periodic: cut from a larger surface, which --rms then belongs to");
  command->add_flag("--as-measured", arguments->as_measured, "With --window: --rms is what such scans show on average, tilt removed");
  command->add_option("--output", arguments->output, "File to write (.gsf)")->required();
  command->callback([arguments] { generate_file(*arguments); });
}

// ---- afm -------------------------------------------------------------------------------------------------------------

struct AfmArguments {
  std::vector<std::string> rms, rms_error, peak_to_valley, peak_to_valley_error;
  std::string size = "2.5 um", cutoff = "20 nm", rolloff, tip;
  std::vector<double> hursts{0.6, 0.8, 1.0};
  int pixels = 512, windows = 5;
  bool json = false;
};

std::vector<PublishedRoughness> published_of(const AfmArguments& arguments) {
  std::vector<PublishedRoughness> all(arguments.rms.size());
  const auto fill = [&](const std::string& option, const std::vector<std::string>& texts, double PublishedRoughness::*member) {
    if (texts.empty()) return;
    if (texts.size() != all.size()) throw InputError(option + " needs as many values as --rms");
    for (std::size_t i = 0; i < all.size(); ++i) all[i].*member = length_of(option, texts[i]);
  };
  fill("--rms", arguments.rms, &PublishedRoughness::rms);
  fill("--rms-error", arguments.rms_error, &PublishedRoughness::rms_error);
  fill("--peak-to-valley", arguments.peak_to_valley, &PublishedRoughness::peak_to_valley);
  fill("--peak-to-valley-error", arguments.peak_to_valley_error, &PublishedRoughness::peak_to_valley_error);
  return all;
}

nlohmann::ordered_json to_json(const SelfAffineSpectrum& spectrum) {
  return {{"rms_m", spectrum.rms},
          {"hurst", spectrum.hurst},
          {"rolloff_m", spectrum.rolloff},
          {"cutoff_m", spectrum.cutoff},
          {"correlation_length_m", correlation_length(spectrum)}};
}

nlohmann::ordered_json to_json(const LengthRange& range) {
  if (range.empty()) return nullptr;
  return {{"lower_m", range.lower}, {"upper_m", range.upper}, {"open_below", range.open_below}, {"open_above", range.open_above}};
}

nlohmann::ordered_json to_json(const PossibleSpectra& result) {
  nlohmann::ordered_json json{{"rms_m", result.published.rms},
                              {"peak_to_valley_m", result.published.peak_to_valley},
                              {"ratio", result.ratio},
                              {"possible_ratios", {result.least_possible, result.most_possible}},
                              {"correlation_length_of_means", to_json(result.correlation_of_means)},
                              {"rolloff_of_means", to_json(result.rolloff_of_means)},
                              {"correlation_length_within_errors", to_json(result.correlation_within_errors)},
                              {"rolloff_within_errors", to_json(result.rolloff_within_errors)},
                              {"sentence", result.sentence},
                              {"examples", nlohmann::ordered_json::array()}};
  for (const SelfAffineSpectrum& example : result.examples) json["examples"].push_back(to_json(example));
  return json;
}

void print_spectra(const std::vector<SelfAffineSpectrum>& spectra) {
  std::printf("  %-8s %-12s %-20s %s\n", "hurst", "rolloff", "correlation length", "rms of the surface");
  for (const SelfAffineSpectrum& spectrum : spectra)
    std::printf("  %-8.3g %-12s %-20s %s\n", spectrum.hurst, in_words(spectrum.rolloff, 3).c_str(),
                in_words(correlation_length(spectrum), 3).c_str(), in_words(spectrum.rms).c_str());
  std::fflush(stdout);
}

void print_wrapped(const std::string& text) {
  constexpr std::size_t width = 100;
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = text.size();
    if (end - begin > width) end = text.rfind(' ', begin + width);
    std::printf("%s\n", text.substr(begin, end - begin).c_str());
    begin = end + 1;
  }
}

void judge(const AfmArguments& arguments) {
  AfmSettings afm;
  afm.size = length_of("--size", arguments.size);
  afm.pixels = arguments.pixels;
  afm.windows = arguments.windows;
  if (!arguments.tip.empty()) afm.tip.radius = length_of("--tip", arguments.tip);
  const double cutoff = length_of("--cutoff", arguments.cutoff);
  const auto published = published_of(arguments);
  nlohmann::ordered_json json = nlohmann::ordered_json::array();

  if (arguments.peak_to_valley.empty()) {  // amplitudes alone
    if (arguments.rolloff.empty()) throw InputError("pass --peak-to-valley to find spectra, or --rolloff to scale those of that roll-off");
    for (const PublishedRoughness& one : published) {
      std::vector<SelfAffineSpectrum> spectra;
      for (const double hurst : arguments.hursts) {
        const SelfAffineSpectrum shape{0, hurst, length_of("--rolloff", arguments.rolloff), cutoff};
        shape.check();
        spectra.push_back(calibrated(shape, one.rms, afm));
      }
      if (arguments.json) {
        for (const auto& spectrum : spectra) json.push_back(to_json(spectrum));
      } else {
        std::printf("Surfaces whose scans show an RMS of %s on average:\n", in_words(one.rms).c_str());
        print_spectra(spectra);
      }
    }
    if (arguments.json) std::cout << json.dump(2) << "\n";
    return;
  }

  if (!arguments.json) std::cerr << "virtual scans of " << arguments.hursts.size() << " Hurst exponents ...\n";
  RatioOptions options;
  options.hursts = arguments.hursts;
  options.cutoff = cutoff;
  const auto curves = ratio_curves(afm, options);
  for (const PublishedRoughness& one : published) {
    const PossibleSpectra result = possible_spectra(one, afm, curves);
    if (arguments.json) {
      json.push_back(to_json(result));
      continue;
    }
    print_wrapped(result.sentence);
    if (!result.examples.empty()) print_spectra(result.examples);
    std::printf("\n");
  }
  if (arguments.json) std::cout << json.dump(2) << "\n";
}

void add_afm(CLI::App& parent) {
  const auto arguments = std::make_shared<AfmArguments>();
  CLI::App* command = parent.add_subcommand("afm", "Which Gaussian surfaces have a published RMS and peak to valley");
  command->add_option("--rms", arguments->rms, "Published RMS; several surfaces may be given at once")->required();
  command->add_option("--rms-error", arguments->rms_error, "Their uncertainties");
  command->add_option("--peak-to-valley", arguments->peak_to_valley, "Published peak to valley of each");
  command->add_option("--peak-to-valley-error", arguments->peak_to_valley_error, "Their uncertainties");
  command->add_option("--size", arguments->size, "Side of a scan")->capture_default_str();
  command->add_option("--pixels", arguments->pixels, "Pixels along its side")->capture_default_str()->check(CLI::Range(16, 4096));
  command->add_option("--windows", arguments->windows, "Scans averaged")->capture_default_str()->check(CLI::Range(1, 100));
  command->add_option("--hurst", arguments->hursts, "Hurst exponents tried")->capture_default_str();
  command->add_option("--cutoff", arguments->cutoff, "Short cut-off wavelength")->capture_default_str();
  command->add_option("--rolloff", arguments->rolloff, "Without --peak-to-valley: scale spectra of this roll-off to the RMS");
  command->add_option("--tip", arguments->tip, "Radius of a spherical tip, such as \"10 nm\" (default: sharp)");
  command->add_flag("--json", arguments->json, "A JSON array instead of text");
  command->footer("The paper's silicon surfaces: asperity surface afm --rms \"0.3 nm\" \"1.5 nm\" \"2.7 nm\" --rms-error \"0.1 nm\" "
                  "\"0.2 nm\" \"0.4 nm\"\n    --peak-to-valley \"1 nm\" \"10.5 nm\" \"14.8 nm\" --peak-to-valley-error \"0.1 nm\" \"0.7 nm\" \"1 nm\"");
  command->callback([arguments] { judge(*arguments); });
}

}  // namespace

void add_surface_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("surface", "Measure, generate and judge topographies");
  command->require_subcommand(1);
  add_measure(*command);
  add_generate(*command);
  add_afm(*command);
}

}  // namespace asperity

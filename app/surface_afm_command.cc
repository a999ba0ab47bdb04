#include "app/commands.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/length_argument.h"
#include "core/error.h"
#include "core/quantity.h"
#include "surfaces/possible_spectra.h"
#include "surfaces/virtual_afm.h"

namespace asperity {
namespace {

std::string rounded_length(double value, int digits = 4) {
  return format_quantity(value, Dimension::length, digits);
}

struct AfmArguments {
  std::vector<std::string> rms, rms_error, peak_to_valley, peak_to_valley_error;
  std::string size = "2.5 um", cutoff = "20 nm", rolloff, tip;
  std::vector<double> hursts{0.6, 0.8, 1.0};
  int pixels = 512, windows = 5;
  bool json = false;
};

std::vector<PublishedRoughness> published_of(const AfmArguments& arguments) {
  std::vector<PublishedRoughness> all(arguments.rms.size());
  const auto fill = [&](const std::string& option, const std::vector<std::string>& texts,
                        double PublishedRoughness::*member) {
    if (texts.empty()) return;
    if (texts.size() != all.size()) throw InputError(option + " needs as many values as --rms");
    for (std::size_t i = 0; i < all.size(); ++i) all[i].*member = length_argument(option, texts[i]);
  };
  fill("--rms", arguments.rms, &PublishedRoughness::rms);
  fill("--rms-error", arguments.rms_error, &PublishedRoughness::rms_error);
  fill("--peak-to-valley", arguments.peak_to_valley, &PublishedRoughness::peak_to_valley);
  fill("--peak-to-valley-error", arguments.peak_to_valley_error, &PublishedRoughness::peak_to_valley_error);
  return all;
}

nlohmann::ordered_json afm_json(const PossibleSpectrum& possible) {
  const SelfAffineSpectrum& spectrum = possible.spectrum;
  return {{"measured_rms_m", possible.measured_rms},
          {"rms_m", spectrum.rms},
          {"hurst", spectrum.hurst},
          {"rolloff_m", spectrum.rolloff},
          {"cutoff_m", spectrum.cutoff},
          {"correlation_length_m", correlation_length(spectrum)}};
}

nlohmann::ordered_json afm_json(const LengthRange& range) {
  if (range.empty()) return nullptr;
  return {{"lower_m", range.lower},
          {"upper_m", range.upper},
          {"open_below", range.open_below},
          {"open_above", range.open_above}};
}

nlohmann::ordered_json afm_json(const PossibleSpectra& result) {
  nlohmann::ordered_json json{
      {"rms_m", result.published.rms},
      {"peak_to_valley_m", result.published.peak_to_valley},
      {"ratio", result.ratio},
      {"possible_ratios", {result.least_possible, result.most_possible}},
      {"correlation_length_of_means", afm_json(result.correlation_of_means)},
      {"rolloff_of_means", afm_json(result.rolloff_of_means)},
      {"correlation_length_within_errors", afm_json(result.correlation_within_errors)},
      {"rolloff_within_errors", afm_json(result.rolloff_within_errors)},
      {"sentence", result.sentence},
      {"examples", nlohmann::ordered_json::array()}};
  for (const PossibleSpectrum& example : result.examples) json["examples"].push_back(afm_json(example));
  return json;
}

void print_spectra(const std::vector<PossibleSpectrum>& spectra) {
  std::printf("  %-8s %-12s %-20s %-20s %s\n", "hurst", "rolloff", "correlation length", "rms in scans",
              "rms of the surface");
  for (const auto& [spectrum, measured] : spectra)
    std::printf("  %-8.3g %-12s %-20s %-20s %s\n", spectrum.hurst,
                rounded_length(spectrum.rolloff, 3).c_str(),
                rounded_length(correlation_length(spectrum), 3).c_str(), rounded_length(measured, 3).c_str(),
                rounded_length(spectrum.rms).c_str());
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
  afm.size = length_argument("--size", arguments.size);
  afm.pixels = arguments.pixels;
  afm.windows = arguments.windows;
  if (!arguments.tip.empty()) afm.tip.radius = length_argument("--tip", arguments.tip);
  const double cutoff = length_argument("--cutoff", arguments.cutoff);
  const auto published = published_of(arguments);
  nlohmann::ordered_json json = nlohmann::ordered_json::array();

  if (arguments.peak_to_valley.empty()) {  // amplitudes alone
    if (arguments.rolloff.empty())
      throw InputError("pass --peak-to-valley to find spectra, or --rolloff to scale those of that roll-off");
    for (const PublishedRoughness& one : published) {
      std::vector<PossibleSpectrum> spectra;
      for (const double hurst : arguments.hursts) {
        const SelfAffineSpectrum shape{0, hurst, length_argument("--rolloff", arguments.rolloff), cutoff};
        shape.check();
        spectra.push_back({calibrated(shape, one.rms, afm), one.rms});
      }
      if (arguments.json) {
        for (const PossibleSpectrum& spectrum : spectra) json.push_back(afm_json(spectrum));
      } else {
        std::printf("Surfaces whose scans show an RMS of %s on average:\n", rounded_length(one.rms).c_str());
        print_spectra(spectra);
      }
    }
    if (arguments.json) std::cout << json.dump(2) << "\n";
    return;
  }

  if (!arguments.json)
    std::cerr << "virtual scans of " << arguments.hursts.size() << " Hurst exponents ...\n";
  RatioOptions options;
  options.hursts = arguments.hursts;
  options.cutoff = cutoff;
  const auto curves = ratio_curves(afm, options);
  for (const PublishedRoughness& one : published) {
    const PossibleSpectra result = possible_spectra(one, afm, curves);
    if (arguments.json) {
      json.push_back(afm_json(result));
      continue;
    }
    print_wrapped(result.sentence);
    if (!result.examples.empty()) print_spectra(result.examples);
    std::printf("\n");
  }
  if (arguments.json) std::cout << json.dump(2) << "\n";
}

}  // namespace

void add_surface_afm_command(CLI::App& parent) {
  const auto arguments = std::make_shared<AfmArguments>();
  CLI::App* command =
      parent.add_subcommand("afm", "Which Gaussian surfaces have a published RMS and peak to valley");
  command->add_option("--rms", arguments->rms, "Published RMS; several surfaces may be given at once")
      ->required();
  command->add_option("--rms-error", arguments->rms_error, "Their uncertainties");
  command->add_option("--peak-to-valley", arguments->peak_to_valley, "Published peak to valley of each");
  command->add_option("--peak-to-valley-error", arguments->peak_to_valley_error, "Their uncertainties");
  command->add_option("--size", arguments->size, "Side of a scan")->capture_default_str();
  command->add_option("--pixels", arguments->pixels, "Pixels along its side")
      ->capture_default_str()
      ->check(CLI::Range(16, 4096));
  command->add_option("--windows", arguments->windows, "Scans averaged")
      ->capture_default_str()
      ->check(CLI::Range(1, 100));
  command->add_option("--hurst", arguments->hursts, "Hurst exponents tried")->capture_default_str();
  command->add_option("--cutoff", arguments->cutoff, "Short cut-off wavelength")->capture_default_str();
  command->add_option("--rolloff", arguments->rolloff,
                      "Without --peak-to-valley: scale spectra of this roll-off to the RMS");
  command->add_option("--tip", arguments->tip,
                      "Radius of a spherical tip, such as \"10 nm\" (default: sharp)");
  command->add_flag("--json", arguments->json, "A JSON array instead of text");
  command->footer(
      "The paper's silicon surfaces: asperity surface afm --rms \"0.3 nm\" \"1.5 nm\" \"2.7 nm\" --rms-error "
      "\"0.1 nm\" \"0.2 nm\" \"0.4 nm\"\n    --peak-to-valley \"1 nm\" \"10.5 nm\" \"14.8 nm\" "
      "--peak-to-valley-error \"0.1 nm\" \"0.7 nm\" \"1 nm\"");
  command->callback([arguments] { judge(*arguments); });
}

}  // namespace asperity

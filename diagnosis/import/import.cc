#include "diagnosis/import/import.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/nearest_name.h"
#include "diagnosis/import/text_formats.h"

namespace asperity {
namespace {

const TextFormat& format_of(const InstrumentText& text, const std::string& asked) {
  for (const auto& format : text_formats()) {
    if (asked.empty() ? format.recognises(text) : asked == format.name) return format;
  }
  throw InputError("there is no format '" + asked + "'; " + did_you_mean(asked, import_formats()));
}

/// What the options say over what the file says; what neither says is asked for.
void fill_bodies(Recording& recording, const ImportOptions& options, const std::string& file) {
  RecordedBody &particle = recording.particle, &substrate = recording.substrate;
  if (options.radius) particle.radius = *options.radius;
  if (options.particle_modulus) particle.youngs_modulus = *options.particle_modulus;
  if (options.particle_poisson) particle.poissons_ratio = *options.particle_poisson;
  if (!std::isfinite(particle.youngs_modulus)) {  // indenters are of diamond unless something else is said
    particle.material = "diamond";
    particle.youngs_modulus = 1140e9;
    particle.poissons_ratio = 0.07;
  }
  if (options.substrate_modulus) substrate.youngs_modulus = *options.substrate_modulus;
  if (options.substrate_poisson) substrate.poissons_ratio = *options.substrate_poisson;
  if (!std::isfinite(particle.radius))
    throw InputError(
        file + ": does not say the radius of sphere or tip; give it with --radius, for example \"150 nm\"");
  if (!std::isfinite(substrate.youngs_modulus) || !std::isfinite(substrate.poissons_ratio))
    throw InputError(
        file + ": does not say what the substrate is; give --substrate-modulus and --substrate-poisson");
  if (!std::isfinite(particle.poissons_ratio))
    throw InputError(file + ": --particle-modulus needs --particle-poisson too");
}

void keep_run(RecordingTable& table, int run, const std::string& file) {
  const std::vector<double> runs = table.column("run");
  RecordingTable kept = table;
  kept.segment.clear();
  for (auto& [channel, values] : kept.columns) values.clear();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i] != run) continue;
    for (auto& [channel, values] : kept.columns) values.push_back(table.columns.at(channel)[i]);
    if (!table.segment.empty()) kept.segment.push_back(table.segment[i]);
  }
  if (kept.rows() == 0)
    throw InputError(file + ": has no run " + std::to_string(run) + "; there are " +
                     std::to_string(std::lround(*std::max_element(runs.begin(), runs.end()))));
  table = kept;
}

}  // namespace

void add_channel(RecordingTable& table, const std::string& channel, const std::vector<double>& values,
                 const std::string& unit) {
  const Dimension dimension = dimension_of_channel(channel);
  const double factor = dimension == Dimension::none ? 1 : unit_factor(instrument_unit(unit), dimension);
  auto& column = table.columns[channel];
  for (const double value : values) column.push_back(value * factor);
}

const std::vector<TextFormat>& text_formats() {
  static const std::vector<TextFormat> formats{{"hysitron", is_hysitron, read_hysitron},
                                               {"optics11", is_optics11, read_optics11},
                                               {"fischer", is_fischer, read_fischer},
                                               {"csv", is_csv, read_mapped_csv}};
  return formats;
}

std::vector<std::string> import_formats() {
  std::vector<std::string> names;
  for (const auto& format : text_formats()) names.push_back(format.name);
  return names;
}

Recording import_recording(const std::filesystem::path& file, const ImportOptions& options) {
  const InstrumentText text = read_instrument_text(file);
  Recording recording = format_of(text, options.format).read(text, options);
  recording.mode = options.mode;
  if (!options.title.empty()) recording.title = options.title;
  fill_bodies(recording, options, text.file);
  RecordingTable& table = recording.tables.front();
  if (!options.control.empty()) table.control = options.control;
  if (!options.response.empty()) table.response = options.response;
  if (options.run) keep_run(table, *options.run, text.file);
  try {
    check_recording(recording);
  } catch (const InputError& error) {
    throw InputError(text.file + ": " + error.what());
  }
  return recording;
}

}  // namespace asperity

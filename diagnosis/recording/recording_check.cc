// What a recording must be before it is compared with anything.
#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.h"
#include "core/joined.h"
#include "core/nearest_name.h"
#include "diagnosis/recording/recording.h"

namespace asperity {
namespace {

constexpr std::size_t fewest_samples_of_trace = 20, fewest_rows_of_series = 3;

std::string file_of(const Recording& recording, const std::string& name) {
  return recording.folder.empty() ? name : (recording.folder / name).string();
}

void check_body(const Recording& recording, const RecordedBody& body, const std::string& name) {
  const auto refuse = [&](const std::string& what) {
    throw InputError(file_of(recording, "recording.json") + ": '" + name + "' " + what);
  };
  if (!(body.youngs_modulus > 0)) refuse("needs its 'youngs_modulus', for example \"71 GPa\"");
  if (!(body.poissons_ratio > -1 && body.poissons_ratio <= 0.5))
    refuse("needs a 'poissons_ratio' between -1 and 0.5");
  if (!(body.rms_roughness >= 0)) refuse("has an 'rms_roughness' below zero");
}

void check_law(const Recording& recording, const std::string& kind, const std::string& value,
               const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), value) != known.end()) return;
  throw InputError(file_of(recording, "recording.json") + ": there is no law '" + value + "' for '" + kind +
                   "'; use " + joined(known, ", "));
}

void check_simulation(const Recording& recording) {
  const SimulationChoice& choice = recording.simulation;
  check_law(recording, "normal", choice.normal, {"hertz"});
  check_law(recording, "sliding", choice.sliding, {"mindlin_coulomb"});
  check_law(recording, "rolling", choice.rolling, {"constant"});
  check_law(recording, "torsion", choice.torsion, {"none", "constant"});
  const std::vector<std::string> known{"sliding_friction", "rolling_friction", "torsion_friction"};
  for (const auto& [name, parameter] : choice.parameters) {
    check_law(recording, "parameters", name, known);
    if (!(parameter.value >= 0))
      throw InputError(file_of(recording, "recording.json") + ": '" + name + "' is below zero");
  }
}

void check_time(const Recording& recording, const RecordingTable& table) {
  if (!table.has("time")) return;
  const auto& time = table.column("time");
  std::map<double, std::pair<double, std::size_t>> last;  // by run
  for (std::size_t row = 0; row < time.size(); ++row) {
    const double run = table.has("run") ? table.column("run")[row] : 0;
    const auto found = last.find(run);
    if (std::isnan(time[row]))
      throw InputError(file_of(recording, table.file) + ": row " + std::to_string(row + 1) +
                       " has no time; fill it, or leave out the column");
    // Clocks are coarser than samples: equal times are in order.
    if (found != last.end() && time[row] < found->second.first)
      throw InputError(file_of(recording, table.file) + ": time falls from row " +
                       std::to_string(found->second.second + 1) + " to row " + std::to_string(row + 1) +
                       " (" + format_quantity(found->second.first, Dimension::time, 6) + ", then " +
                       format_quantity(time[row], Dimension::time, 6) +
                       "); number separate experiments in a column 'run'");
    last[run] = {time[row], row};
  }
}

void check_table(const Recording& recording, const RecordingTable& table) {
  const std::string file = file_of(recording, table.file);
  const std::size_t rows = table.rows();
  for (const auto& [channel, values] : table.columns) {
    dimension_of_channel(channel);
    if (values.size() != rows)
      throw InputError(file + ": column '" + channel + "' is shorter than the others");
    for (std::size_t row = 0; row < values.size(); ++row)
      if (std::isinf(values[row]))
        throw InputError(file + ": row " + std::to_string(row + 1) + " of '" + channel + "' is not finite");
  }
  if (!table.segment.empty() && table.segment.size() != rows)
    throw InputError(file + ": column 'segment' is shorter than the others");
  if (table.control.empty()) throw InputError(file + ": no control channel is named");
  for (const auto& channel : table.control) {
    const auto& values = table.column(channel);
    for (std::size_t row = 0; row < values.size(); ++row)
      if (std::isnan(values[row]))
        throw InputError(file + ": row " + std::to_string(row + 1) + " has no '" + channel +
                         "', which drives the simulation; fill it or drop the row");
    if (channel == table.response)
      throw InputError(file + ": '" + channel + "' cannot be control and response at once");
  }
  for (const auto& channel : {"run", "cycle"})
    if (table.has(channel))
      for (std::size_t row = 0; row < rows; ++row)
        if (std::isnan(table.column(channel)[row]))
          throw InputError(file + ": row " + std::to_string(row + 1) + " does not say its '" + channel + "'");
  std::size_t samples = 0;
  for (const double value : table.column(table.response)) samples += std::isfinite(value);
  const std::size_t fewest = table.kind == TableKind::trace ? fewest_samples_of_trace : fewest_rows_of_series;
  if (samples < fewest)
    throw InputError(file + ": " + std::to_string(samples) + " samples of '" + table.response +
                     "' are too few for a " + (table.kind == TableKind::trace ? "trace" : "series") +
                     "; it takes " + std::to_string(fewest));
  const std::string sd = table.response + "_sd";
  if (table.has(sd))
    for (std::size_t row = 0; row < rows; ++row)
      if (table.column(sd)[row] <= 0)
        throw InputError(file + ": row " + std::to_string(row + 1) + " of '" + sd + "' is not above zero");
  const std::string other = recording.mode == Motion::normal ? "normal_displacement" : "normal_force";
  if (recording.mode != Motion::normal && !table.has(other)) table.column(other);
  for (const auto& [channel, values] : table.columns)
    if (is_deviation(channel))
      for (std::size_t row = 0; row < rows; ++row)
        if (values[row] < 0)
          throw InputError(file + ": row " + std::to_string(row + 1) + " of '" + channel + "' is below zero");
  check_time(recording, table);
}

}  // namespace

const std::vector<double>& RecordingTable::column(const std::string& channel) const {
  const auto found = columns.find(channel);
  if (found != columns.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& column : columns) names.push_back(column.first);
  throw InputError(file + ": there is no column '" + channel + "' among " + joined(names, ", "));
}

void check_recording(const Recording& recording) {
  const std::string file = file_of(recording, "recording.json");
  check_body(recording, recording.particle, "particle");
  check_body(recording, recording.substrate, "substrate");
  if (!(recording.particle.radius > 0))
    throw InputError(file + ": 'particle' needs its 'radius', for example \"8.5 um\"");
  const bool rolls = recording.mode == Motion::rolling || recording.mode == Motion::rail;
  if (recording.indenter)
    check_body(recording, *recording.indenter, "indenter");
  else if (rolls)
    throw InputError(file + ": '" + name_of(recording.mode) +
                     "' needs the 'indenter', the body that pushes from above");
  check_simulation(recording);
  for (const auto& [channel, sd] : recording.noise)
    if (!(sd > 0)) throw InputError(file + ": the noise of '" + channel + "' is not above zero");
  if (recording.tables.empty()) throw InputError(file + ": there are no tables");
  for (const auto& table : recording.tables) {
    check_table(recording, table);
    if (recording.mode == Motion::rail && !table.has("rail_angle") && !std::isfinite(recording.rail_angle))
      throw InputError(file + ": 'rail' needs the 'rail_angle', for example \"45 deg\"");
  }
}

}  // namespace asperity

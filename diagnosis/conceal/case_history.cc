// A solved case's history as a recording: the finite-element solver as truth.
#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "dem_compare/solved_case.h"
#include "diagnosis/conceal/add_noise.h"

namespace asperity {
namespace {

RecordedBody body_of(const SolvedCase& solved, const ElasticBody& elasticity, const std::string& section) {
  RecordedBody body;
  body.material = section == "Particle" ? "particle" : "substrate";
  body.youngs_modulus = elasticity.youngs_modulus;
  body.poissons_ratio = elasticity.poisson_ratio;
  if (section == "Particle") body.radius = solved.entries.quantity("Particle/Radius", Dimension::length);
  return body;
}

/// The accepted steps from `first` on, without anything between them, recorded again and again with noise of its own each time.
RecordingTable repeated_steps(const ContactHistory& history, std::size_t first, const std::vector<HistoryColumn>& channels,
                              std::vector<double> ContactHistory::*driven, const char* up, const char* down) {
  constexpr std::size_t samples = 240;
  const std::size_t steps = history.size() - first, repeats = (samples + steps - 1) / steps;
  const std::vector<double>& position = history.*driven;
  RecordingTable table;
  for (std::size_t repeat = 0; repeat < repeats; ++repeat)
    for (std::size_t i = first; i < history.size(); ++i) {
      table.columns["run"].push_back(static_cast<double>(repeat + 1));
      table.columns["time"].push_back(static_cast<double>(i - first));
      for (const auto& channel : channels) table.columns[channel.name].push_back((history.*channel.values)[i]);
      // A step belongs to the way that leads to it; the first one to that which leads on.
      const std::size_t before = i > first ? i - 1 : i, after = i > first ? i : std::min(i + 1, history.size() - 1);
      table.segment.push_back(position[after] >= position[before] ? up : down);
    }
  return table;
}

/// Approach without force, loading and unloading as one dense trace: between accepted steps F^(2/3) is straight in the approach, as it is
/// by Hertz. The approach of a case is counted from first touch.
RecordingTable loading_table(const ContactHistory& solved) {
  constexpr double way_before = 0.4;  // of the largest approach
  ContactHistory history;
  history.normal_displacement = {-way_before * *std::max_element(solved.normal_displacement.begin(), solved.normal_displacement.end()), 0};
  history.normal_force = {0, 0};
  history.normal_displacement.insert(history.normal_displacement.end(), solved.normal_displacement.begin(), solved.normal_displacement.end());
  history.normal_force.insert(history.normal_force.end(), solved.normal_force.begin(), solved.normal_force.end());
  constexpr double samples = 240;
  RecordingTable table;
  table.file = "loading.csv";
  table.control = {"normal_displacement"};
  table.response = "normal_force";
  const auto& d = history.normal_displacement;
  double path = 0;
  for (std::size_t i = 1; i < history.size(); ++i) path += std::abs(d[i] - d[i - 1]);
  const auto straight = [](double force) { return std::copysign(std::pow(std::abs(force), 2.0 / 3), force); };
  for (std::size_t i = 1; i < history.size(); ++i) {
    const auto count = static_cast<int>(std::ceil(samples * std::abs(d[i] - d[i - 1]) / path));
    for (int k = 0; k < count; ++k) {
      const double t = (k + 1.0) / count, force = straight(history.normal_force[i - 1]) * (1 - t) + straight(history.normal_force[i]) * t;
      table.columns["run"].push_back(1);
      table.columns["time"].push_back(static_cast<double>(i) - 1 + t);
      table.columns["normal_displacement"].push_back(d[i - 1] * (1 - t) + d[i] * t);
      table.columns["normal_force"].push_back(std::copysign(std::pow(std::abs(force), 1.5), force));
      table.segment.push_back(d[i] >= d[i - 1] ? "load" : "unload");
    }
  }
  return table;
}

/// From the last step before the shift on: what solvers leave of rounding before it is no motion.
RecordingTable sliding_table(const ContactHistory& history, const std::string& folder) {
  constexpr double rounding = 1e-4;  // of the largest shift
  double largest = 0;
  for (const double x : history.lateral_displacement) largest = std::max(largest, std::abs(x));
  std::size_t first = 0;
  while (first + 1 < history.size() && std::abs(history.lateral_displacement[first + 1]) <= rounding * largest) ++first;
  if (!(largest > 0) || first + 2 >= history.size()) throw InputError(folder + ": its history.csv has no sliding");
  RecordingTable table = repeated_steps(history, first,
                                        {{"lateral_displacement", &ContactHistory::lateral_displacement},
                                         {"normal_force", &ContactHistory::normal_force},
                                         {"lateral_force", &ContactHistory::lateral_force}},
                                        &ContactHistory::lateral_displacement, "forward", "backward");
  table.file = "loops.csv";
  table.control = {"lateral_displacement", "normal_force"};
  table.response = "lateral_force";
  return table;
}

}  // namespace

ConcealedRecording conceal_case(const std::filesystem::path& folder, const ConcealOptions& options) {
  const SolvedCase solved = read_solved_case(folder);
  if (options.mode != Mode::normal && options.mode != Mode::sliding)
    throw InputError(folder.string() + ": a case becomes a recording in modes normal and sliding, not " + name_of(options.mode));
  ConcealedRecording concealed;
  Recording& recording = concealed.recording;
  recording.title = "finite elements: " + solved.title();
  recording.mode = options.mode;
  recording.particle = body_of(solved, solved.particle(), "Particle");
  recording.substrate = body_of(solved, solved.substrate(), "Substrate");
  recording.tables = {options.mode == Mode::normal ? loading_table(solved.history) : sliding_table(solved.history, folder.string())};
  if (options.mode == Mode::sliding) {
    recording.simulation_is_given = true;
    recording.simulation.parameters["sliding_friction"] = {solved.entries.quantity("Interface/Friction coefficient", Dimension::none, 0.3), true};
  }
  for (const auto& id : options.effects) {
    TrueEffect effect;
    effect.id = id;
    effect.model = "finite elements";
    concealed.truth.effects.push_back(effect);
  }
  concealed.truth.family = options.effects.empty() ? "null" : options.effects.size() == 1 ? "single" : "pair";
  // A few steps are too coarse to tell noise from what they miss: the instrument says what its noise is.
  const auto& response = recording.tables[0].column(recording.tables[0].response);
  double largest = 0;
  for (const double value : response) largest = std::max(largest, std::abs(value));
  if (options.noise > 0) recording.noise[recording.tables[0].response] = options.noise * largest;
  hidden::add_noise(concealed, {}, options);
  check_recording(recording);
  return concealed;
}

}  // namespace asperity

// Histories of solved cases as a recording: the finite-element solver as truth. Each case is a run, or in
// torsion a row.
#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "dem_compare/laws/maugis_dugdale.h"
#include "diagnosis/conceal/add_noise.h"
#include "results/solved_case.h"

namespace asperity {
namespace {

RecordedBody solved_body(const SolvedCase& solved, const ElasticBody& elasticity,
                         const std::string& section) {
  RecordedBody body;
  body.material = section == "Particle" ? "particle" : "substrate";
  body.youngs_modulus = elasticity.youngs_modulus;
  body.poissons_ratio = elasticity.poisson_ratio;
  if (section == "Particle") body.radius = solved.entries.quantity("Particle/Radius", Dimension::length);
  return body;
}

double next_run(const RecordingTable& table) {
  const auto runs = table.columns.find("run");
  return runs == table.columns.end() || runs->second.empty() ? 1 : runs->second.back() + 1;
}

/// A channel of a recording and the column that it is.
struct Channel {
  const char* name;
  std::vector<double> History::*values;
};

/// The accepted steps from `first` on, without anything between them, recorded again and again with noise of
/// its own each time.
void add_repeated_steps(RecordingTable& table, const History& history, std::size_t first,
                        const std::vector<Channel>& channels, std::vector<double> History::*driven,
                        const char* up, const char* down) {
  constexpr std::size_t samples = 240;
  const std::size_t steps = history.size() - first, repeats = (samples + steps - 1) / steps;
  const std::vector<double>& position = history.*driven;
  for (std::size_t repeat = 0; repeat < repeats; ++repeat) {
    const double run = next_run(table);
    for (std::size_t i = first; i < history.size(); ++i) {
      table.columns["run"].push_back(run);
      table.columns["time"].push_back(static_cast<double>(i - first));
      for (const auto& channel : channels)
        table.columns[channel.name].push_back((history.*channel.values)[i]);
      // A step belongs to the segment that leads to it; the first one to the segment that it begins.
      const std::size_t before = i > first ? i - 1 : i,
                        after = i > first ? i : std::min(i + 1, history.size() - 1);
      table.segment.push_back(position[after] >= position[before] ? up : down);
    }
  }
}

/// Approach without force (none where the surfaces attract: solved cases begin at touch), loading and
/// unloading as one dense trace: between accepted steps F^(2/3) is straight in the approach, as it is by
/// Hertz. The approach of a case is counted from first touch. Where between two steps a contact broke is not
/// known: nothing is recorded in between, for no force on the way is one that a contact had.
void add_loading(RecordingTable& table, const History& solved) {
  constexpr double way_before = 0.4;  // of the largest approach
  const bool attracts = *std::min_element(solved.normal_force.begin(), solved.normal_force.end()) < 0;
  History history;
  if (!attracts) {
    history.normal_displacement = {
        -way_before * *std::max_element(solved.normal_displacement.begin(), solved.normal_displacement.end()),
        0};
    history.normal_force = {0, 0};
  }
  history.normal_displacement.insert(history.normal_displacement.end(), solved.normal_displacement.begin(),
                                     solved.normal_displacement.end());
  history.normal_force.insert(history.normal_force.end(), solved.normal_force.begin(),
                              solved.normal_force.end());
  constexpr double samples = 240;
  const double run = next_run(table);
  table.file = "loading.csv";
  table.control = {"normal_displacement"};
  table.response = "normal_force";
  const auto& d = history.normal_displacement;
  double path = 0;
  for (std::size_t i = 1; i < history.size(); ++i) path += std::abs(d[i] - d[i - 1]);
  const auto straight = [](double force) { return std::copysign(std::pow(std::abs(force), 2.0 / 3), force); };
  for (std::size_t i = 1; i < history.size(); ++i) {
    const auto count = static_cast<int>(std::ceil(samples * std::abs(d[i] - d[i - 1]) / path));
    const bool breaks = history.normal_force[i - 1] < 0 && history.normal_force[i] == 0;
    for (int k = breaks ? count - 1 : 0; k < count; ++k) {
      const double t = (k + 1.0) / count, force = straight(history.normal_force[i - 1]) * (1 - t) +
                                                  straight(history.normal_force[i]) * t;
      table.columns["run"].push_back(run);
      table.columns["time"].push_back(static_cast<double>(i) - 1 + t);
      table.columns["normal_displacement"].push_back(d[i - 1] * (1 - t) + d[i] * t);
      table.columns["normal_force"].push_back(std::copysign(std::pow(std::abs(force), 1.5), force));
      table.segment.push_back(d[i] >= d[i - 1] ? "load" : "unload");
    }
  }
}

/// From the last step before the shift on: what solvers leave of rounding before it is no motion.
void add_sliding(RecordingTable& table, const History& history, const std::string& folder) {
  constexpr double rounding = 1e-4;  // of the largest shift
  double largest = 0;
  for (const double x : history.lateral_displacement) largest = std::max(largest, std::abs(x));
  std::size_t first = 0;
  while (first + 1 < history.size() &&
         std::abs(history.lateral_displacement[first + 1]) <= rounding * largest)
    ++first;
  if (!(largest > 0) || first + 2 >= history.size())
    throw InputError(folder + ": its history.csv has no sliding");
  table.file = "loops.csv";
  table.control = {"lateral_displacement", "normal_force"};
  table.response = "lateral_force";
  add_repeated_steps(table, history, first,
                     {{"lateral_displacement", &History::lateral_displacement},
                      {"normal_force", &History::normal_force},
                      {"lateral_force", &History::lateral_force}},
                     &History::lateral_displacement, "forward", "backward");
}

/// The moment where the contact slips everywhere, as a force at the particle's radius; three measurements of
/// each load.
void add_torsion(RecordingTable& table, const SolvedCase& solved) {
  const History& history = solved.history;
  const double radius = solved.entries.quantity("Particle/Radius", Dimension::length);
  const auto largest = std::max_element(history.torsion_moment.begin(), history.torsion_moment.end());
  if (!(*largest > 0)) throw InputError(solved.folder.string() + ": its history.csv has no torsion");
  const auto step = static_cast<std::size_t>(largest - history.torsion_moment.begin());
  table.file = "series.csv";
  table.kind = TableKind::series;
  table.control = {"normal_force"};
  table.response = "lateral_force";
  constexpr int measurements = 3;
  for (int i = 0; i < measurements; ++i) {
    table.columns["normal_force"].push_back(history.normal_force[step]);
    table.columns["lateral_force"].push_back(history.torsion_moment[step] / radius);
  }
}

/// What a case's inputs say of an effect's parameters, where they mean what the catalogue means.
std::map<std::string, TrueParameter> known_parameters(const std::string& effect, const SolvedCase& solved) {
  const auto entry = [&](const char* path, Dimension dimension) {
    return TrueParameter{solved.entries.quantity(path, dimension, 0), true};
  };
  const TrueParameter work = entry("Interface/Work of adhesion", Dimension::surface_energy);
  if (effect == "bulk_plasticity")
    return {{"yield_stress", entry("Particle/Yield stress", Dimension::pressure)}};
  if (effect == "area_proportional_friction")
    return {{"shear_strength", entry("Interface/Shear strength", Dimension::pressure)}};
  if (effect == "adhesion_hysteresis")
    return {{"work_closing", work},
            {"work_opening", entry("Interface/Work of adhesion on separation", Dimension::surface_energy)}};
  if (effect == "adhesion") {
    const Hertz bodies = solved.hertz();
    const MaugisDugdale law{bodies.reduced_modulus, bodies.radius, work.value,
                            work.value / entry("Interface/Adhesion range", Dimension::length).value};
    return {{"pull_off_force", {law.pull_off_force(), true}}};
  }
  if (effect == "contact_radius_scaling") {
    constexpr double full_slip = 3 * M_PI / 16;  // M = 3 pi/16 mu P a (Lubkin 1951)
    return {{"rolling_friction",
             {full_slip * entry("Interface/Friction coefficient", Dimension::none).value, true}}};
  }
  return {};
}

}  // namespace

ConcealedRecording conceal_case(const std::filesystem::path& folder, const ConcealOptions& options) {
  return conceal_cases({folder}, options);
}

ConcealedRecording conceal_cases(const std::vector<std::filesystem::path>& folders,
                                 const ConcealOptions& options) {
  if (options.mode != Motion::normal && options.mode != Motion::sliding && options.mode != Motion::torsion)
    throw InputError(folders.front().string() +
                     ": a case becomes a recording in modes normal, sliding and torsion, not " +
                     name_of(options.mode));
  std::vector<SolvedCase> cases;
  for (const auto& folder : folders) cases.push_back(read_solved_case(folder));
  const SolvedCase& first = cases.front();
  ConcealedRecording concealed;
  Recording& recording = concealed.recording;
  recording.title = "finite elements: " + first.title();
  recording.mode = options.mode;
  recording.particle = solved_body(first, first.particle(), "Particle");
  recording.substrate = solved_body(first, first.substrate(), "Substrate");
  recording.tables.emplace_back();
  for (const SolvedCase& solved : cases) {
    RecordingTable& table = recording.tables[0];
    if (options.mode == Motion::normal)
      add_loading(table, solved.history);
    else if (options.mode == Motion::sliding)
      add_sliding(table, solved.history, solved.folder.string());
    else
      add_torsion(table, solved);
  }
  if (options.mode != Motion::normal) {
    recording.simulation_is_given = true;
    constexpr double guess = 0.3, torsion_guess = 0.01;
    if (options.mode == Motion::torsion) recording.simulation.torsion = "constant";
    recording.simulation
        .parameters[options.mode == Motion::sliding ? "sliding_friction" : "torsion_friction"] = {
        options.mode == Motion::sliding ? guess : torsion_guess, true};
  }
  for (const auto& id : options.effects) {
    TrueEffect effect;
    effect.id = id;
    effect.model = "finite elements";
    effect.parameters = known_parameters(id, first);
    concealed.truth.effects.push_back(effect);
  }
  concealed.truth.family = options.effects.empty() ? "null" : options.effects.size() == 1 ? "single" : "pair";
  // A few steps are too coarse to separate noise from model error: the instrument states its noise.
  const auto& response = recording.tables[0].column(recording.tables[0].response);
  double largest = 0;
  for (const double value : response) largest = std::max(largest, std::abs(value));
  if (options.noise > 0 && options.mode != Motion::torsion)
    recording.noise[recording.tables[0].response] = options.noise * largest;
  hidden::add_noise(concealed, {}, options);
  check_recording(recording);
  return concealed;
}

}  // namespace asperity

#include "app/finite_element_model.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/case_file.h"
#include "app/inputs_hash.h"
#include "app/study_runner.h"
#include "core/error.h"
#include "core/printed.h"
#include "results/solved_case.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

bool yields(const BodyInput& body) {
  const auto yield = body.parameters.find("Yield stress");
  return yield != body.parameters.end() && std::isfinite(yield->second);
}

void set_entry(Settings& settings, const std::string& path, const std::string& value) {
  const std::size_t slash = path.find('/');
  override_setting(settings, {path.substr(0, slash), path.substr(slash + 1), value, "diagnosis"});
}

/// The case under another load.
void drive(Settings& settings, const LoadingProtocol& protocol) {
  set_entry(settings, "Experiment/Control", "force");
  set_entry(settings, "Experiment/Normal load", printed("%.6g N", protocol.largest_force));
  set_entry(settings, "Experiment/Normal approach", "0 m");
  set_entry(settings, "Experiment/Unload", protocol.unloads ? "true" : "false");
  set_entry(settings, "Experiment/Retract", "0 m");
  set_entry(settings, "Experiment/Cycles", "1");
  set_entry(settings, "Experiment/Hold steps", "0");
}

SolvedResponse response_of(const fs::path& folder) {
  const SolvedCase solved = read_solved_case(folder);
  SolvedResponse response;
  response.displacement = solved.history.normal_displacement;
  response.force = solved.history.normal_force;
  const auto peak = std::max_element(response.force.begin(), response.force.end());
  response.peak = static_cast<std::size_t>(peak - response.force.begin());
  response.displacement_error = solved.effective("approach_from_first_touch").sd;
  if (!std::isfinite(response.displacement_error))
    throw WorkError(
        "'" + folder.string() +
        "' does not state the error of its approach, without which a mismatch cannot be told from "
        "the mesh's; solve it with this version");
  response.source = folder.string();
  return response;
}

}  // namespace

FiniteElementModel::FiniteElementModel(const fs::path& file, const std::vector<std::string>& overrides,
                                       FiniteElementModelOptions options)
    : file_(file), options_(std::move(options)) {
  const Settings given = read_settings(file, overrides);
  warn_of_former_names(given);
  input_ = case_from_settings(given, file);
  settings_ = complete_settings(given, file);
  if (input_.experiment.type != Motion::normal)
    throw InputError(file.string() + ": Experiment/Type is " + name_of(input_.experiment.type) +
                     ", and --case takes cases of normal contact so far; set Type = normal");
  if (input_.interface.work_of_adhesion > 0)
    throw InputError(file.string() +
                     ": Interface/Work of adhesion is above 0, and --case takes cases without adhesion so "
                     "far; set it to 0 J/m^2");
}

SimulatedBodies FiniteElementModel::bodies() const {
  return {{input_.particle.youngs_modulus, input_.particle.poisson_ratio},
          {input_.substrate.youngs_modulus, input_.substrate.poisson_ratio},
          input_.radius,
          yields(input_.particle),
          yields(input_.substrate)};
}

std::vector<SolvedResponse> FiniteElementModel::solve(const std::vector<CaseChange>& changes,
                                                      const std::vector<LoadingProtocol>& protocols) {
  Study study;
  study.title = "diagnosis";
  study.file = file_;
  for (const LoadingProtocol& protocol : protocols) {
    StudyCase item;
    item.settings = settings_;
    drive(item.settings, protocol);
    for (const CaseChange& change : changes)
      set_entry(item.settings, change.entry, printed("%.6g %s", change.value, change.unit.c_str()));
    case_from_settings(item.settings, file_);  // refuses what the case cannot take
    constexpr std::size_t enough = 12;
    item.name = "solve-" + inputs_sha256(item.settings, file_).substr(0, enough);
    study.cases.push_back(std::move(item));
  }
  StudyRunOptions options;
  options.output = options_.folder;
  options.resume = true;
  options.cores = options_.cores;
  options.program = options_.solver;
  options.say = options_.say;
  // A normal case is solved in minutes: one that was broken off is begun again, whatever build began it.
  options.objection_to_resume = [](const auto&, const auto&) { return std::string("is not complete"); };
  const std::vector<CaseProgress> progress = run_study(study, options);
  std::vector<SolvedResponse> responses;
  for (std::size_t i = 0; i < progress.size(); ++i) {
    const fs::path folder = options_.folder / study.cases[i].name;
    if (progress[i].state == CaseProgress::State::stopped ||
        progress[i].state == CaseProgress::State::waiting)
      // No WorkError: a stop ends the diagnosis, where a case that fails is left out of it.
      throw std::runtime_error("the diagnosis was stopped; the same command goes on with what is solved");
    if (progress[i].state == CaseProgress::State::failed)
      throw WorkError("'" + folder.string() + "' could not be solved: " + progress[i].message);
    responses.push_back(response_of(folder));
  }
  return responses;
}

}  // namespace asperity

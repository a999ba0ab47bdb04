#include "app/finite_element_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "app/case_file.h"
#include "app/driven_case.h"
#include "app/inputs_hash.h"
#include "app/relaxing_case.h"
#include "app/solved_motion.h"
#include "app/study_runner.h"
#include "app/study_summary.h"
#include "core/error.h"
#include "core/printed.h"
#include "core/quantity.h"
#include "core/wait_text.h"
#include "fem/interface/adhesion_law.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

double yield_stress(const BodyInput& body) {
  const auto yield = body.parameters.find("Yield stress");
  return yield != body.parameters.end() ? yield->second : std::numeric_limits<double>::infinity();
}

double rms_of_generated(const BodyInput& body) {
  const GeneratorParameters* generated = body.topography.generator();
  return generated ? generated->spectrum.rms : 0;
}

SolvedResponse loading_of(SolvedResponse response) {
  response.displacement.resize(response.peak + 1);
  response.force.resize(response.peak + 1);
  return response;
}

/// Accepted steps of a case that is being solved or was broken off.
std::size_t steps_in(const fs::path& folder) {
  return fs::exists(folder / "history.csv") ? read_history(folder / "history.csv").size() : 0;
}

std::string why_enough(const EnoughOfIt& enough, const fs::path& folder) {
  if (!enough || steps_in(folder) < least_steps_of_curve) return "";
  const History history = read_history(folder / "history.csv");
  return steps_within_region(history) < history.size() ? at_the_rim
                                                       : enough(response_of(folder, "it goes on"));
}

}  // namespace

FiniteElementModel::FiniteElementModel(const fs::path& file, const std::vector<std::string>& overrides,
                                       FiniteElementModelOptions options)
    : file_(file), options_(std::move(options)), begun_(std::chrono::steady_clock::now()) {
  const Settings given = read_settings(file, overrides);
  warn_of_former_names(given);
  input_ = case_from_settings(given, file);
  settings_ = complete_settings(given, file);
  const Motion type = input_.experiment.type;
  if (type == Motion::program)
    throw InputError(file.string() + ": Experiment/Type is " + name_of(type) +
                     ", and --case takes cases of one motion, which it drives as was recorded; set Type = "
                     "normal");
  refuse_what_relaxes_besides(input_, file);
}

SimulatedBodies FiniteElementModel::bodies() const {
  const auto given_of_interface = [this](const char* entry) {
    const auto found = input_.interface.parameters.find(entry);
    return found == input_.interface.parameters.end() ? 0.0 : found->second;
  };
  return {{input_.particle.youngs_modulus, input_.particle.poisson_ratio},
          {input_.substrate.youngs_modulus, input_.substrate.poisson_ratio},
          input_.radius,
          yield_stress(input_.particle),
          yield_stress(input_.substrate),
          input_.particle.topography.is_smooth() && input_.substrate.topography.is_smooth(),
          input_.mesh.interface_spacing,
          given_of_interface("Friction coefficient"),
          given_of_interface("Adhesion range"),
          input_.interface.work_of_adhesion,
          fem::work_of_adhesion(input_.interface).opening,
          input_.interface.attraction_force,
          relaxation_of(input_.particle),
          relaxation_of(input_.substrate),
          rms_of_generated(input_.substrate),
          input_.experiment.unload_steps};
}

Study FiniteElementModel::empty_study() const {
  Study study;
  study.title = "diagnosis";
  study.file = file_;
  return study;
}

template <class Protocol>
Settings FiniteElementModel::driven_by(const Protocol& protocol,
                                       const std::vector<CaseChange>& changes) const {
  Settings driven = settings_;
  leave_out_relaxation(driven, input_);
  drive(driven, protocol);
  for (const CaseChange& change : changes)
    set_entry(driven, change.entry,
              printed("%.6g", change.value) + (change.unit.empty() ? "" : " " + change.unit));
  const CaseInput changed = case_from_settings(driven, file_);  // refuses what the case cannot take
  if (changed.experiment.type == Motion::normal && fem::work_of_adhesion(changed.interface).opening > 0 &&
      changed.interface.adhesion_law != "dugdale")
    throw InputError(file_.string() + ": Interface/Adhesion law is " + changed.interface.adhesion_law +
                     ", and attraction is tried as Dugdale's so far; set it to dugdale");
  return driven;
}

FiniteElementModel::Asked FiniteElementModel::asked_of(const Settings& driven, Study& study) const {
  const std::string inputs = inputs_sha256(driven, file_);
  const fs::path earlier = options_.earlier.with_inputs(inputs);
  if (!earlier.empty()) return {earlier, true, false, ""};
  constexpr std::size_t enough = 12;
  StudyCase item;
  item.settings = driven;
  item.name = "solve-" + inputs.substr(0, enough);
  study.cases.push_back(std::move(item));
  return {options_.folder / study.cases.back().name, false, false, ""};
}

fs::path FiniteElementModel::pressed_further(const Settings& driven, const LoadingProtocol& protocol) const {
  if (protocol.unloads || protocol.approach > 0) return {};
  constexpr double rounding = 1e-3, most = 3;
  for (const DrivenCase& known : options_.earlier.of_contact(driven, file_))
    if (known.motion == Motion::normal && known.load > (1 - rounding) * protocol.largest_force &&
        known.load < most * protocol.largest_force &&
        tells_loading_up_to(known.folder, (1 + rounding) * protocol.largest_force))
      return known.folder;
  return {};
}

std::vector<MotionProtocol> FiniteElementModel::solved_motions(Motion motion) {
  std::vector<MotionProtocol> list;
  for (const DrivenCase& known : options_.earlier.of_contact(settings_, file_)) {
    if (known.motion != motion || !(known.load > 0) || known.speed != input_.experiment.speed) continue;
    const MotionProtocol protocol{motion, known.load, 0, {}, known.folder.string()};
    try {
      const SolvedMotion solved = motion_of(known.folder, protocol);
      if (std::isfinite(solved.resistance) && std::isfinite(solved.resistance_error))
        list.push_back(protocol);
    } catch (const WorkError&) {  // it outgrew its mesh
      continue;
    }
  }
  return list;
}

std::string FiniteElementModel::out_of_time(double seconds) const {
  if (seconds > longest_)
    return "it took " + wait_text(seconds) + " of the " + wait_text(options_.seconds) + " for all solutions";
  if (seconds_spent() > options_.seconds)
    return "the time for solutions, " + wait_text(options_.seconds) + ", was over";
  return "";
}

std::vector<CaseProgress> FiniteElementModel::run(const Study& study, const EnoughOfIt& enough,
                                                  const std::vector<std::string>& unchosen) {
  if (study.cases.empty()) return {};
  StudyRunOptions options;
  options.output = options_.folder;
  options.resume = true;
  options.cores = options_.cores;
  options.program = options_.solver;
  options.say = options_.say;
  options.chosen = [&](const std::string& name) {
    return std::find(unchosen.begin(), unchosen.end(), name) == unchosen.end();
  };
  // A normal case is solved in minutes: one that was broken off is begun again, whatever build began it.
  options.objection_to_resume = [](const auto&, const auto&) { return std::string("is not complete"); };
  longest_ = longest_solution(options_.seconds, seconds_spent());
  std::map<fs::path, std::size_t> looked_at;
  // Without the case as it is there is nothing to compare with, whatever it takes.
  if (enough)
    options.reason_to_stop = [&](const fs::path& folder, double seconds) {
      std::string late = out_of_time(seconds);
      if (!late.empty()) return late;
      const std::size_t steps = steps_in(folder);
      if (looked_at[folder] == steps) return std::string();
      looked_at[folder] = steps;
      return why_enough(enough, folder);
    };
  return run_study(study, options);
}

std::vector<SolvedResponse> FiniteElementModel::solve(const std::vector<CaseChange>& changes,
                                                      const std::vector<LoadingProtocol>& protocols,
                                                      const EnoughOfIt& enough) {
  Study study = empty_study();
  std::vector<Asked> asked;
  for (const LoadingProtocol& protocol : protocols) {
    const Settings driven = driven_by(protocol, changes);
    const fs::path further = pressed_further(driven, protocol);
    asked.push_back(further.empty() ? asked_of(driven, study) : Asked{further, true, true, ""});
  }
  std::vector<std::string> unchosen;
  for (Asked& each : asked) {
    if (each.is_earlier || has_result(each.folder)) continue;
    each.ended_early = why_enough(enough, each.folder);
    if (!each.ended_early.empty()) unchosen.push_back(each.folder.filename().string());
  }
  const std::vector<CaseProgress> progress = run(study, enough, unchosen);
  std::vector<SolvedResponse> responses;
  std::size_t next = 0;
  for (Asked& each : asked) {
    if (each.is_earlier) {
      responses.push_back(response_of(each.folder, ""));
      if (each.is_pressed_further) responses.back() = loading_of(responses.back());
      continue;
    }
    const CaseProgress& done = progress[next++];
    const std::string folder = each.folder.string();
    if (done.state == CaseProgress::State::stopped) each.ended_early = done.message;
    if (done.state == CaseProgress::State::failed)
      throw WorkError("'" + folder + "' could not be solved: " + done.message);
    if (done.state != CaseProgress::State::done && each.ended_early.empty())
      // No WorkError: a stop ends the diagnosis, where a case that fails is left out of it.
      throw std::runtime_error("the diagnosis was stopped; the same command goes on with what is solved");
    const bool is_late = !each.ended_early.empty() && !out_of_time(done.seconds).empty();
    if (!each.ended_early.empty() && steps_in(folder) < least_steps_of_curve) {
      const std::string why = "'" + folder + "' was stopped before it said anything: " + each.ended_early;
      if (is_late) throw OutOfTime(why);
      throw WorkError(why);
    }
    responses.push_back(response_of(folder, each.ended_early));
    if (changes.empty() && responses.back().ended_early == at_the_rim) refuse_outgrown(folder);
    responses.back().is_out_of_time = is_late;
  }
  return responses;
}

std::vector<SolvedMotion> FiniteElementModel::move(const std::vector<CaseChange>& changes,
                                                   const std::vector<MotionProtocol>& protocols,
                                                   bool must_end) {
  std::vector<SolvedMotion> motions = move_once(changes, protocols, must_end);
  // Resistance that is more than what was recorded needs a longer path until it is steady.
  constexpr double longer = 3;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const auto is_steady = [&] {
      return std::isfinite(motions[i].resistance) && std::isfinite(motions[i].resistance_error);
    };
    if (is_steady()) continue;
    MotionProtocol further = protocols[i];
    further.path *= longer;
    further.solved_in.clear();
    motions[i] = move_once(changes, {further}, must_end).front();
    if (!is_steady())
      throw WorkError("'" + motions[i].source +
                      "' states no steady resistance: the contact did not slip as a whole, or roll "
                      "steadily, on its path");
  }
  return motions;
}

std::vector<SolvedMotion> FiniteElementModel::move_once(const std::vector<CaseChange>& changes,
                                                        const std::vector<MotionProtocol>& protocols,
                                                        bool must_end) {
  Study study = empty_study();
  std::vector<Asked> asked;
  for (const MotionProtocol& protocol : protocols)
    asked.push_back(changes.empty() && !protocol.solved_in.empty()
                        ? Asked{protocol.solved_in, true, false, ""}
                        : asked_of(driven_by(protocol, changes), study));
  const EnoughOfIt whole_path = [](const SolvedResponse&) { return std::string(); };
  const std::vector<CaseProgress> progress = run(study, must_end ? nullptr : whole_path, {});
  for (std::size_t i = 0; i < progress.size(); ++i) {
    const CaseProgress& done = progress[i];
    if (done.state == CaseProgress::State::done) continue;
    const std::string folder = (options_.folder / study.cases[i].name).string();
    // Stopped for no reason of its own: by whoever stops the diagnosis.
    if (done.state == CaseProgress::State::failed ||
        (done.state == CaseProgress::State::stopped && !done.message.empty()))
      throw WorkError("'" + folder + "' could not be solved: " + done.message);
    throw std::runtime_error("the diagnosis was stopped; the same command goes on with what is solved");
  }
  std::vector<SolvedMotion> motions;
  for (std::size_t i = 0; i < asked.size(); ++i) motions.push_back(motion_of(asked[i].folder, protocols[i]));
  return motions;
}

}  // namespace asperity

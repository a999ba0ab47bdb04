#include "engines/engine.h"

#include "core/alone_in_mpi.h"
#include "core/atomic_file.h"
#include "core/error.h"
#include "core/output_folder.h"
#include "core/printed.h"
#include "core/quantity.h"
#include "engines/run_program.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

constexpr const char* log_name = "engine.log";
constexpr const char* trace_name = "trace.csv";

fs::path program_of(const Engine& engine, const EngineRunOptions& options) {
  const std::string wanted = options.program.empty() ? engine.executable() : options.program;
  fs::path found = find_program(wanted);
  if (found.empty())
    throw WorkError(engine.name() + " is missing: there is no program '" + wanted +
                    "'; install it with 'apt-get install " + engine.package() +
                    "' or './quickstart --engines', or name it with --program");
  return found;
}

}  // namespace

EngineRun run_engine(const Engine& engine, const EngineExperiment& experiment, const fs::path& folder,
                     const EngineRunOptions& options) {
  EngineRun run;
  run.engine = engine.name();
  run.plan = plan_motion(experiment);
  const std::string input = engine.input(experiment, run.plan);
  const fs::path program = program_of(engine, options);
  make_folder(folder);
  fs::remove(folder / trace_name);
  write_file_atomically(folder / engine.input_file(), input);
  std::vector<std::string> arguments{program.string()};
  for (const auto& argument : engine.arguments()) arguments.push_back(argument);
  // A program of the user's own choice may be a script that starts ranks.
  const auto environment = options.program.empty() ? environment_alone_in_mpi() : std::vector<std::string>{};
  const ProgramRun program_run = run_program(arguments, folder, log_name, options.time_limit, environment);
  const std::string log = read_file(folder / log_name), message = engine.error_message(log);
  const std::string log_path = (folder / log_name).string();
  if (program_run.status != 0 || !message.empty())
    throw WorkError(engine.name() + " failed" +
                    (message.empty() ? " with exit status " + std::to_string(program_run.status)
                                     : ": \"" + message + "\"") +
                    "; " + engine.remedy(message) + " (its output: " + log_path + ")");
  run.version = engine.version(log);
  run.wall_time = program_run.wall_time;
  try {
    run.trace = read_trace(folder / trace_name);
    run.measurements = measure(experiment, run.plan, run.trace);
  } catch (const std::runtime_error& error) {
    throw WorkError(engine.name() + " ended without an error but did not write what was asked for: " +
                    error.what() + "; " + engine.remedy("") + " (its output: " + log_path + ")");
  }
  return run;
}

nlohmann::ordered_json to_json(const EngineRun& run, const EngineExperiment& experiment) {
  nlohmann::ordered_json json;
  json["format"] = "asperity-engine-run/1";
  json["engine"] = run.engine;
  json["version"] = run.version;
  json["experiment"] = engine_experiment_name(experiment.type);
  json["load"] = {{"value", experiment.load}, {"unit", "N"}};
  json["wall_time"] = {{"value", run.wall_time}, {"unit", "s"}};
  json["time_step"] = {{"value", run.plan.time_step}, {"unit", "s"}};
  json["measurements"] = nlohmann::ordered_json::array();
  for (const auto& m : run.measurements)
    json["measurements"].push_back(
        {{"name", m.name}, {"unit", m.unit}, {"measured", m.measured}, {"law", m.law}, {"ratio", m.ratio()}});
  return json;
}

std::string to_text(const EngineRun& run, const EngineExperiment& experiment) {
  std::string text = run.engine + (run.version.empty() ? "" : " (" + run.version + ")") + ", " +
                     engine_experiment_name(experiment.type) + ", normal load " +
                     format_quantity(experiment.load, Dimension::force, 4);
  text += printed(", %.1f s\n\n%-42s %14s %14s  %-8s %9s\n", run.wall_time, "", "engine", "law", "unit",
                  "departs");
  for (const auto& m : run.measurements)
    text += printed("%-42s %14.6g %14.6g  %-8s %+8.3f %%\n", m.name.c_str(), m.measured, m.law,
                    m.unit.c_str(), 100 * (m.ratio() - 1));
  return text;
}

}  // namespace asperity

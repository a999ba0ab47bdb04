// A discrete element engine run as its users run it: input written, program started, output read back and
// measured.
#pragma once

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engines/engine_input.h"
#include "engines/experiment.h"
#include "engines/measurement.h"
#include "engines/trace.h"

namespace asperity {

/// An engine that asperity also runs: what differs from one to the other.
class Engine : public WrittenEngine {
 public:
  virtual std::string executable() const = 0;  ///< "lmp"
  virtual std::string package() const = 0;     ///< of Debian
  /// Its name in the folder that the engine runs in.
  virtual std::string input_file() const = 0;
  /// Input that makes the engine write trace.csv (trace.h) in the folder it runs in. Throws InputError for
  /// what it cannot do.
  virtual std::string input(const EngineExperiment& experiment, const MotionPlan& plan) const = 0;
  virtual std::vector<std::string> arguments() const = 0;  ///< behind the executable
  /// The engine's own error message in what it printed; "" if there is none.
  virtual std::string error_message(const std::string& log) const = 0;
  /// What to install or change about it.
  virtual std::string remedy(const std::string& error_message) const = 0;
  /// Version as it prints it; "" if it does not.
  virtual std::string version(const std::string& log) const = 0;
};

/// By its key; throws InputError naming what was meant.
const Engine& engine_of(const std::string& key);
/// Those that asperity runs, in alphabetical order of their keys.
std::vector<const Engine*> runnable_engines();
/// What each says of itself, such as its key: "lammps or yade" with the separator " or ".
std::string list_runnable_engines(std::string (Engine::*text)() const, const std::string& separator);

/// What came out of a run.
struct EngineRun {
  std::string engine, version;
  double wall_time = 0;  ///< [s]
  MotionPlan plan;
  EngineTrace trace;
  std::vector<EngineMeasurement> measurements;
};

/// How it is started.
struct EngineRunOptions {
  std::string program;  ///< in place of the engine's executable
  std::chrono::seconds time_limit{600};
};

/// Writes input, trace.csv and the engine's log into `folder`. Throws WorkError, one sentence, where the
/// engine is missing, fails or prints something else than was asked for.
EngineRun run_engine(const Engine& engine, const EngineExperiment& experiment,
                     const std::filesystem::path& folder, const EngineRunOptions& options = {});

/// The measurements beside the closed form, as JSON and as text to read.
nlohmann::ordered_json to_json(const EngineRun& run, const EngineExperiment& experiment);
std::string to_text(const EngineRun& run, const EngineExperiment& experiment);

}  // namespace asperity

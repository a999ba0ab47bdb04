// Running engines in tests.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <string>

#include "core/alone_in_mpi.h"
#include "engines/engine.h"
#include "engines/lammps.h"
#include "engines/run_program.h"
#include "engines/yade.h"
#include "tests/engines/canonical_contact.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/verification.h"

/// Skips the test with one line where an engine is not installed.
#define ASPERITY_ENGINE_OR_SKIP(engine)                      \
  if (asperity::find_program((engine).executable()).empty()) \
  GTEST_SKIP() << (engine).name() << " is not installed: apt-get install " << (engine).package()

namespace asperity::test {

/// LIGGGHTS takes scripts as LAMMPS does.
class Liggghts : public Lammps {
 public:
  std::string name() const override { return "LIGGGHTS"; }
  std::string executable() const override { return "liggghts"; }
  std::string package() const override { return "liggghts"; }
};

/// The canonical contact (100 uN, mu = 0.23) in one of the experiments.
inline EngineExperiment canonical_experiment(Motion type) {
  EngineExperiment e;
  e.type = type;
  e.substrate = canonical_contact();
  e.indenter = canonical_indenter();
  return e;
}

/// The V-rail: rolling coefficient as the paper's fit gives it for the roughness of each rail, torsion
/// coefficient 0.0056, both times the particle's radius; sliding coefficient of the rough wafer.
inline EngineExperiment rail_experiment(double degrees) {
  static const std::map<double, double> rolling{{25, 3.602e-4}, {45, 3.146e-4}, {60, 2.960e-4}};
  EngineExperiment e = canonical_experiment(Motion::rail);
  e.load = 5e-4;
  e.amplitude = 20e-9;
  e.rail_angle = degrees * std::acos(-1.0) / 180;
  for (ContactParameters* contact : {&e.substrate, &e.indenter}) {
    contact->rolling_friction->value = rolling.at(degrees);
    contact->sliding_friction->value = 0.65;
  }
  return e;
}

inline EngineRun run(const Engine& engine, const EngineExperiment& experiment) {
  const TemporaryFolder folder;
  return run_engine(engine, experiment, folder.path);
}

/// All of an experiment's measurements agree with the law in closed form; `what` names the experiment.
inline void expect_closed_form(const std::string& what, const EngineRun& engine_run, double tolerance) {
  Largest error;
  std::string all;
  for (const auto& m : engine_run.measurements) {
    error.count(m.ratio() - 1);
    all += "\n" + m.name + ": " + std::to_string(m.ratio()) + " of the law";
  }
  const Verified verified{"Engines", engine_run.engine + ", " + what + ": all that is measured of it",
                          "closed form"};
  EXPECT_TRUE(verified.within(1 + error, 1, tolerance)) << all;
}

/// Output of a script of the test's own, run by an engine's program.
inline std::string run_script(const Engine& engine, const std::string& script) {
  const TemporaryFolder folder;
  folder.write(engine.input_file(), script);
  std::vector<std::string> arguments{find_program(engine.executable()).string()};
  for (const auto& argument : engine.arguments()) arguments.push_back(argument);
  run_program(arguments, folder.path, "log", std::chrono::seconds(120), environment_alone_in_mpi());
  std::ifstream log(folder.path / "log");
  return {std::istreambuf_iterator<char>(log), {}};
}

/// The number behind `label` in a text; NaN if it is not there.
inline double number_after(const std::string& text, const std::string& label) {
  const auto at = text.find(label);
  return at == std::string::npos ? std::nan("") : std::strtod(text.c_str() + at + label.size(), nullptr);
}

}  // namespace asperity::test

// Engines that are missing, fail or print something else: one sentence with their own message and what to do.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "core/error.h"
#include "tests/engines/engine_support.h"

namespace asperity {
namespace {

using test::canonical_experiment;
using test::message_of;
using test::rail_experiment;
using test::TemporaryFolder;

#define EXPECT_CONTAINS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

/// What run_engine says about a program that does `shell`.
std::string message(const Engine& engine, const std::string& shell,
                    std::chrono::seconds limit = std::chrono::seconds(20)) {
  const TemporaryFolder folder;
  const auto fake = folder.write("fake", "#!/bin/sh\n" + shell + "\n");
  std::filesystem::permissions(fake, std::filesystem::perms::owner_all);
  EngineRunOptions options;
  options.program = fake.string();
  options.time_limit = limit;
  const std::string text = message_of<WorkError>(
      [&] { run_engine(engine, canonical_experiment(Motion::sliding), folder.path / "run", options); });
  EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  return text;
}

TEST(FailingEngine_behaviour, that_is_missing_is_named_with_the_package_to_install) {
  EngineRunOptions options;
  options.program = "no-such-engine";
  const TemporaryFolder folder;
  const std::string text = message_of<WorkError>(
      [&] { run_engine(Lammps(), canonical_experiment(Motion::sliding), folder.path, options); });
  EXPECT_EQ(
      text,
      "LAMMPS is missing: there is no program 'no-such-engine'; install it with 'apt-get install lammps' or "
      "'./quickstart --engines', or name it with --program");
}

TEST(FailingEngine_behaviour, lammps_is_quoted_with_its_own_error) {
  const std::string text = message(
      Lammps(),
      "echo 'LAMMPS (1 Jan 2030)'; echo 'ERROR: Unrecognized fix style (src/modify.cpp:900)'; exit 1");
  EXPECT_CONTAINS(text, "LAMMPS failed: \"ERROR: Unrecognized fix style (src/modify.cpp:900)\"");
  EXPECT_CONTAINS(text, "use that one, or name it with --program");
  EXPECT_CONTAINS(text, "engine.log");
}

TEST(FailingEngine_behaviour, a_program_of_the_users_own_may_start_ranks_and_the_engine_s_starts_alone) {
  const std::string says = "echo \"ERROR: network '$OMPI_MCA_btl'\"; exit 1";
  EXPECT_CONTAINS(message(Lammps(), says), "network ''");
  const TemporaryFolder folder;
  const auto fake = folder.write("lmp", "#!/bin/sh\n" + says + "\n");
  std::filesystem::permissions(fake, std::filesystem::perms::owner_all);
  const std::string path = ::getenv("PATH");
  ::setenv("PATH", (folder.path.string() + ":" + path).c_str(), 1);
  const std::string own = message_of<WorkError>(
      [&] { run_engine(Lammps(), canonical_experiment(Motion::sliding), folder.path / "run"); });
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_CONTAINS(own, "network 'self'");
}

TEST(FailingEngine_behaviour, lammps_without_its_granular_package_is_said_to_lack_it) {
  const std::string text = message(Lammps(), "echo \"ERROR: Unrecognized pair style 'granular'\"; exit 1");
  EXPECT_CONTAINS(text, "lacks the GRANULAR package");
}

TEST(FailingEngine_behaviour, yade_is_quoted_with_the_last_line_of_its_traceback) {
  const std::string text =
      message(Yade(),
              "echo 'Welcome to Yade 1.0'; echo 'Traceback (most recent call last):'; echo '  File \"a.py\", "
              "line 1'; "
              "echo \"NameError: name 'Ip2_FrictMat_FrictMat_MindlinPhys' is not defined\"; exit 1");
  EXPECT_CONTAINS(text,
                  "YADE failed: \"NameError: name 'Ip2_FrictMat_FrictMat_MindlinPhys' is not defined\"");
  EXPECT_CONTAINS(text, "lacks the Hertz-Mindlin law");
}

TEST(FailingEngine_behaviour, that_ends_with_a_status_alone_is_reported_with_it) {
  EXPECT_CONTAINS(message(Lammps(), "exit 7"), "LAMMPS failed with exit status 7");
  EXPECT_CONTAINS(message(Yade(), "kill -SEGV $$"), "YADE failed with exit status 139");
}

TEST(FailingEngine_behaviour, that_writes_nothing_or_something_else_is_not_believed) {
  EXPECT_CONTAINS(message(Lammps(), "exit 0"), "ended without an error but did not write what was asked for");
  EXPECT_CONTAINS(message(Lammps(), "echo 'a,b\n1,2' > trace.csv"), "leg");
  const std::string header = "echo '" + trace_header() + "' > trace.csv; ";
  EXPECT_CONTAINS(message(Lammps(), header + "for i in 1 2 3; do echo 0,1,1,1,1,1,1,1 >> trace.csv; done"),
                  "rows of leg 2 of 10");
  EXPECT_CONTAINS(message(Lammps(), header + "echo 0,1,1,nan,1,1,1,1 >> trace.csv"), "response");
}

TEST(FailingEngine_behaviour, that_does_not_end_is_stopped) {
  EXPECT_CONTAINS(message(Lammps(), "sleep 100", std::chrono::seconds(1)),
                  "did not end within 1 s and was stopped");
}

TEST(FailingEngine_behaviour, name_that_is_misspelt_is_corrected) {
  EXPECT_EQ(message_of<InputError>([] { engine_of("lamps"); }),
            "asperity cannot run an engine 'lamps'; did you mean 'lammps'?");
  EXPECT_EQ(message_of<InputError>([] { engine_experiment_type("roling"); }),
            "there is no experiment 'roling'; did you mean 'rolling'?");
}

TEST(EnginePlan_behaviour, refuses_an_amplitude_that_does_not_reach_sliding) {
  EngineExperiment e = canonical_experiment(Motion::sliding);
  e.amplitude = 1e-9;
  EXPECT_CONTAINS(message_of<InputError>([&] { plan_motion(e); }),
                  "an amplitude of 1 nm does not reach all the limits");
}

TEST(EnginePlan_behaviour, asks_for_a_rail_long_enough_for_soft_torsion_to_reach_its_limit) {
  EngineExperiment e = rail_experiment(45);
  e.substrate.torsion_stiffness->value = 1.37e-9;  // no slip, a thousandth of the canonical one
  EXPECT_CONTAINS(message_of<InputError>([&] { plan_motion(e); }),
                  "does not reach all the limits of this contact; take at least");
}

TEST(EnginePlan_behaviour, says_which_quantity_an_experiment_lacks) {
  EngineExperiment e = canonical_experiment(Motion::rolling);
  e.indenter.rolling_friction.reset();
  EXPECT_CONTAINS(message_of<InputError>([&] { plan_motion(e); }), "has no 'rolling_friction'");
  e.substrate.particle.density = std::nan("");
  EXPECT_CONTAINS(message_of<InputError>([&] { plan_motion(e); }), "particle/density");
}

}  // namespace
}  // namespace asperity

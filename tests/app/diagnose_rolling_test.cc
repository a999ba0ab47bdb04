// asperity diagnose --case with recordings of rolling and of torsion, as a person calls it: the case is
// rolled or spun by finite elements under the recorded loads.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>

#include "core/atomic_file.h"
#include "core/hertz.h"
#include "core/printed.h"
#include "tests/app/called_program.h"
#include "tests/app/smooth_case.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::call;
using test::Outcome;
using test::TemporaryFolder;

constexpr double turned_radius = 8.5e-6;

double edge_of_contact(double load) {
  return Hertz{reduced_modulus({71e9, 0.17}, {179e9, 0.25}), turned_radius}.contact_radius(load);
}

/// Eight rows of each load, in either direction, noise 1 % of the largest force.
std::filesystem::path turned_recording(const TemporaryFolder& folder, const std::string& mode,
                                       const std::vector<double>& loads,
                                       const std::function<double(double)>& force) {
  const auto recording = folder.path / "recording";
  std::filesystem::create_directory(recording);
  nlohmann::json table{{"file", "series.csv"}, {"kind", "series"}, {"response", "lateral_force"}};
  table["control"] = std::vector<std::string>{"normal_force"};
  nlohmann::json about{{"format", "asperity-recording/1"}, {"title", "turned"}, {"mode", mode}};
  about["particle"] = {{"material", "borosilicate"},
                       {"youngs_modulus", "71 GPa"},
                       {"poissons_ratio", 0.17},
                       {"radius", "8.5 um"}};
  about["substrate"] = {{"material", "silicon"}, {"youngs_modulus", "179 GPa"}, {"poissons_ratio", 0.25}};
  about["indenter"] = about["substrate"];
  about["tables"] = std::vector<nlohmann::json>{table};
  write_file_atomically(recording / "recording.json", about.dump());
  const double deviation = 0.01 * force(loads.back());
  std::string csv = "normal_force [N],lateral_force [N],lateral_force_sd [N],segment\n";
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, deviation);
  for (const double load : loads)
    for (int row = 0; row < 8; ++row) {
      const int direction = row % 2 == 0 ? 1 : -1;
      csv += printed("%.6e,%.9e,%.6e,%s\n", load, direction * force(load) + noise(random), deviation,
                     direction > 0 ? "forward" : "backward");
    }
  write_file_atomically(recording / "series.csv", csv);
  return recording;
}

nlohmann::json diagnosed_turning(const TemporaryFolder& folder, const std::filesystem::path& recording,
                                 const std::string& spacing) {
  const auto file = folder.write("case.prm", test::smooth_case() +
                                                 "subsection Interface\n  set Friction coefficient = "
                                                 "0.3\nend\nsubsection Mesh\n  set Interface spacing = " +
                                                 spacing + "\n  set Layers = 2\nend\n");
  const auto output = folder.path / "diagnosis";
  const Outcome outcome = call("diagnose " + recording.string() + " --case " + file.string() + " --output " +
                               output.string() + " --minutes 60");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  auto said = nlohmann::json::parse(read_file(output / "diagnosis.json"));
  said["printed"] = outcome.output;
  return said;
}

/// M = (3 pi/16) mu f a (Lubkin 1951).
TEST(DiagnoseTorsion_analytic, a_moment_of_the_case_s_friction_agrees_with_it) {
  const TemporaryFolder folder;
  const auto moment = [](double load) {
    return 3 * M_PI / 16 * 0.3 * load * edge_of_contact(load) / turned_radius;
  };
  const auto said = diagnosed_turning(folder, turned_recording(folder, "torsion", {100e-6}, moment), "40 nm");
  EXPECT_EQ(said["verdict"], "no_mismatch") << said["printed"].get<std::string>();
  EXPECT_EQ(said["forward_model"]["solves"], 1);
  EXPECT_LT(said["forward_model"]["discretisation_error"]["value"].get<double>(), 0.1);

  // The solution stands for a load that is near, and is the simulation itself.
  const auto near = folder.path / "near";
  std::filesystem::create_directory(near);
  std::filesystem::rename(turned_recording(folder, "torsion", {80e-6}, moment), near / "recording");
  const Outcome of_study =
      call("diagnose " + (near / "recording").string() + " --study " +
           (folder.path / "diagnosis/solves").string() + " --output " + (near / "out").string());
  EXPECT_EQ(of_study.status, 0) << of_study.output;
  EXPECT_FALSE(std::filesystem::exists(near / "out/solves"));
  EXPECT_EQ(nlohmann::json::parse(read_file(near / "out/diagnosis.json"))["verdict"], "no_mismatch")
      << of_study.output;
}

/// Where closing gains nothing, what closes is Hertz' contact, and 2 a w is lost per path behind it.
TEST(DiagnoseRollingNightly_analytic, work_that_opening_takes_is_named_and_written_to_the_case) {
  constexpr double work = 0.05;
  const TemporaryFolder folder;
  const auto said =
      diagnosed_turning(folder,
                        turned_recording(folder, "rolling", {60e-6, 120e-6, 240e-6},
                                         [](double load) { return 2 * edge_of_contact(load) * work; }),
                        "25 nm");
  EXPECT_EQ(said["verdict"], "explained") << said["printed"].get<std::string>();
  ASSERT_EQ(said["left_out"].size(), 1u) << said["printed"].get<std::string>();
  EXPECT_EQ(said["left_out"][0]["effect"], "rolling_adhesion_hysteresis");
  const auto& corrected = said["forward_model"]["corrected"];
  const char* entry = "Interface/Work of adhesion on separation";
  ASSERT_TRUE(corrected.contains(entry)) << said["printed"].get<std::string>();
  EXPECT_NEAR(corrected[entry]["value"].get<double>() / work, 1, 0.1);
  EXPECT_LT(corrected[entry]["ci95"][0], work);
  EXPECT_GT(corrected[entry]["ci95"][1], work);
  EXPECT_NE(read_file(folder.path / "diagnosis/corrected.prm").find("set Work of adhesion on separation"),
            std::string::npos);
}

}  // namespace
}  // namespace asperity

// asperity diagnose --case with a recording of sliding, as a person calls it: the case is slid by finite
// elements under the recorded loads.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>

#include "core/atomic_file.h"
#include "core/hertz.h"
#include "core/printed.h"
#include "core/shear_moduli.h"
#include "diagnosis/conceal/masing_contact.h"
#include "tests/app/called_program.h"
#include "tests/app/smooth_case.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::call;
using test::Outcome;
using test::TemporaryFolder;

constexpr double ball_radius = 8.5e-6;
const ElasticBody ball_body{71e9, 0.17}, plane_body{179e9, 0.25};

double radius_under(double load) {
  return Hertz{reduced_modulus(ball_body, plane_body), ball_radius}.contact_radius(load);
}

/// Loops of Cattaneo, Mindlin and Deresiewicz at each load, noise 0.5 % of the largest force; `limit` of the
/// load [N], `compliance` in series [m/N].
std::filesystem::path slid_recording(const TemporaryFolder& folder, const std::vector<double>& loads,
                                     const std::function<double(double)>& limit, double compliance = 0) {
  const auto recording = folder.path / "recording";
  std::filesystem::create_directory(recording);
  nlohmann::json table{{"file", "loops.csv"}, {"kind", "trace"}, {"response", "lateral_force"}};
  table["control"] = std::vector<std::string>{"lateral_displacement", "normal_force"};
  nlohmann::json about{{"format", "asperity-recording/1"}, {"title", "slid"}, {"mode", "sliding"}};
  about["particle"] = {{"material", "borosilicate"},
                       {"youngs_modulus", "71 GPa"},
                       {"poissons_ratio", 0.17},
                       {"radius", "8.5 um"}};
  about["substrate"] = {{"material", "silicon"}, {"youngs_modulus", "179 GPa"}, {"poissons_ratio", 0.25}};
  about["tables"] = std::vector<nlohmann::json>{table};
  write_file_atomically(recording / "recording.json", about.dump());
  std::string csv = "run,time [s],normal_force [N],lateral_displacement [m],lateral_force [N],segment\n";
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 0.005 * limit(loads.back()));
  double time = 0;
  for (std::size_t run = 0; run < loads.size(); ++run) {
    const double stiffness = 8 * reduced_shear_modulus(ball_body, plane_body) * radius_under(loads[run]);
    hidden::MasingContact contact(stiffness, limit(loads[run]));
    constexpr double stroke = 100e-9;
    constexpr int count = 100;
    for (int i = 1; i <= 3 * count; ++i) {
      const double part = static_cast<double>(i) / count, x = stroke * (part <= 1   ? part
                                                                        : part <= 2 ? 2 - part
                                                                                    : part - 2);
      const double force = contact.force(x);
      csv += printed("%zu,%g,%.6e,%.9e,%.9e,%s\n", run + 1, time += 0.1, loads[run], x + compliance * force,
                     force + noise(random), part > 1 && part <= 2 ? "back" : "forth");
    }
  }
  write_file_atomically(recording / "loops.csv", csv);
  return recording;
}

/// `mesh`: lines of that section.
nlohmann::json diagnosed_sliding(const TemporaryFolder& folder, const std::filesystem::path& recording,
                                 const std::string& mesh = "") {
  const auto file = folder.write("case.prm", test::smooth_case() +
                                                 "subsection Interface\n  set Friction coefficient = "
                                                 "0.3\nend\nsubsection Mesh\n" +
                                                 mesh + "end\n");
  const auto output = folder.path / "diagnosis";
  const Outcome outcome =
      call("diagnose " + recording.string() + " --case " + file.string() + " --output " + output.string());
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  auto said = nlohmann::json::parse(read_file(output / "diagnosis.json"));
  said["printed"] = outcome.output;
  return said;
}

void expect_entry(const nlohmann::json& said, const std::string& entry, double truth, double within) {
  const auto& corrected = said["forward_model"]["corrected"];
  ASSERT_TRUE(corrected.contains(entry)) << said["printed"].get<std::string>();
  EXPECT_NEAR(corrected[entry]["value"].get<double>() / truth, 1, within);
  EXPECT_LT(corrected[entry]["ci95"][0], truth);
  EXPECT_GT(corrected[entry]["ci95"][1], truth);
}

TEST(DiagnoseSliding_analytic, loops_with_the_case_s_friction_agree_with_it) {
  const TemporaryFolder folder;
  const auto recording = slid_recording(folder, {100e-6}, [](double load) { return 0.3 * load; });
  const auto said =
      diagnosed_sliding(folder, recording, "  set Interface spacing = 40 nm\n  set Layers = 2\n");
  EXPECT_EQ(said["verdict"], "no_mismatch") << said["printed"].get<std::string>();
  EXPECT_EQ(said["forward_model"]["solves"], 1);
  EXPECT_LT(said["forward_model"]["discretisation_error"]["value"].get<double>(), 0.05);
}

TEST(DiagnoseSlidingNightly_analytic, another_local_friction_and_a_compliant_mount_are_named) {
  const TemporaryFolder folder;
  const double compliance = 1e-4;
  const auto said = diagnosed_sliding(
      folder, slid_recording(
                  folder, {40e-6, 100e-6, 300e-6}, [](double load) { return 0.21 * load; }, compliance));
  EXPECT_EQ(said["verdict"], "explained") << said["printed"].get<std::string>();
  EXPECT_EQ(said["left_out"].size(), 2u) << said["printed"].get<std::string>();
  expect_entry(said, "Interface/Friction coefficient", 0.21, 0.02);
  EXPECT_NE(read_file(folder.path / "diagnosis/corrected.prm").find("set Friction coefficient"),
            std::string::npos);
}

/// Friction follows Hertz' area: finite elements sum the strength over what touches of their mesh.
TEST(DiagnoseSlidingNightly_analytic, a_shear_strength_in_place_of_a_coefficient_is_named) {
  constexpr double strength = 150e6;
  const TemporaryFolder folder;
  const auto said = diagnosed_sliding(
      folder, slid_recording(folder, {40e-6, 100e-6, 300e-6},
                             [](double load) { return strength * M_PI * std::pow(radius_under(load), 2); }));
  ASSERT_EQ(said["left_out"].size(), 1u) << said["printed"].get<std::string>();
  EXPECT_EQ(said["left_out"][0]["effect"], "area_proportional_friction");
  expect_entry(said, "Interface/Shear strength", strength, 0.05);
}

}  // namespace
}  // namespace asperity

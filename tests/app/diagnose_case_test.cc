// asperity diagnose --case as a person calls it: finite elements solved under a recording's loads.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>

#include "core/atomic_file.h"
#include "core/csv.h"
#include "core/hertz.h"
#include "core/printed.h"
#include "tests/app/called_program.h"
#include "tests/app/smooth_case.h"
#include "tests/support/shared_files.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::call;
using test::Outcome;
using test::smooth_case;
using test::TemporaryFolder;

/// Loading of a sphere of borosilicate on silicon: `force` of the displacement, noise 0.5 % of the largest.
std::filesystem::path recorded(const TemporaryFolder& folder, double deepest,
                               const std::function<double(double)>& force, const char* modulus = "179 GPa",
                               double poisson = 0.25) {
  const auto recording = folder.path / "recording";
  std::filesystem::create_directory(recording);
  const nlohmann::json glass{{"material", "borosilicate"},
                             {"youngs_modulus", "71 GPa"},
                             {"poissons_ratio", 0.17},
                             {"radius", "8.5 um"}};
  const nlohmann::json wafer{
      {"material", "silicon"}, {"youngs_modulus", modulus}, {"poissons_ratio", poisson}};
  nlohmann::json table{{"file", "loading.csv"}, {"kind", "trace"}, {"response", "normal_force"}};
  table["control"] = std::vector<std::string>{"normal_displacement"};
  nlohmann::json about{{"format", "asperity-recording/1"},
                       {"title", "pressed"},
                       {"mode", "normal"},
                       {"particle", glass},
                       {"substrate", wafer}};
  about["tables"] = std::vector<nlohmann::json>{table};
  write_file_atomically(recording / "recording.json", about.dump());
  std::string csv = "time [s],normal_displacement [m],normal_force [N],segment\n";
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 0.005 * force(deepest));
  for (int i = 1; i <= 200; ++i) {
    const double d = deepest * i / 200;
    csv += printed("%g,%.9e,%.9e,load\n", 0.1 * i, d, force(d) + noise(random));
  }
  write_file_atomically(recording / "loading.csv", csv);
  return recording;
}

TEST(DiagnoseCase_analytic, a_contact_of_Hertz_and_its_elastic_case_agree) {
  const TemporaryFolder folder;
  const Hertz hertz{reduced_modulus({71e9, 0.17}, {179e9, 0.25}), 8.5e-6};
  const auto recording = recorded(folder, 40e-9, [&](double d) { return hertz.force(d); });
  const auto file = folder.write("case.prm", smooth_case());
  const auto output = folder.path / "diagnosis";
  const std::string command =
      "diagnose " + recording.string() + " --case " + file.string() + " --output " + output.string();
  const Outcome outcome = call(command);
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  const auto said = nlohmann::json::parse(read_file(output / "diagnosis.json"));
  EXPECT_EQ(said["verdict"], "no_mismatch") << outcome.output;
  EXPECT_EQ(said["simulation"], "finite elements");
  EXPECT_EQ(said["solutions"]["count"], 1);
  EXPECT_TRUE(std::filesystem::exists(output / "history_before.csv"));
  EXPECT_FALSE(std::filesystem::exists(output / "corrected.prm"));
  EXPECT_NE(read_file(output / "report.html").find("The simulation is the case itself"), std::string::npos);

  // What was solved is taken again.
  const auto solved = said["solutions"]["before"].get<std::string>();
  const auto written = std::filesystem::last_write_time(solved + "/result.json");
  EXPECT_EQ(call(command).status, 0);
  EXPECT_EQ(std::filesystem::last_write_time(solved + "/result.json"), written);
}

/// Loading to ten times the approach of first yield of a sphere that yields at 1 GPa on a rigid plane, by
/// axisymmetric finite elements of another program.
TEST(DiagnoseCaseNightly_other_code,
     yielding_is_named_with_its_yield_stress_and_the_corrected_case_predicts) {
  constexpr double yield = 1e9, poisson = 0.17, radius = 8.5e-6, deepest = 10;
  const double modulus = reduced_modulus({71e9, poisson}, {1e15, 0.3}), pi = std::acos(-1);
  const double factor = 1.295 * std::exp(0.736 * poisson);
  const double approach = std::pow(pi * factor * yield / (2 * modulus), 2) * radius;
  const double at_yield = 4.0 / 3 * modulus * std::sqrt(radius) * std::pow(approach, 1.5);
  const CsvTable table = read_csv(test::reference_table("02_elastoplastic_table_ownFE.csv"));
  const std::vector<double> w = table.numbers("w/wc"), f = table.numbers("F/Fc_nu0.17");
  const auto force = [&](double d) {  // straight in F^(2/3) between the table's rows
    const double depth = d / approach;
    if (depth <= w.front()) return at_yield * std::pow(depth, 1.5);
    std::size_t k = 1;
    while (w[k] < depth) ++k;
    const double part = (depth - w[k - 1]) / (w[k] - w[k - 1]), low = std::pow(f[k - 1], 2.0 / 3);
    return at_yield * std::pow(low + part * (std::pow(f[k], 2.0 / 3) - low), 1.5);
  };
  const TemporaryFolder folder;
  const auto recording = recorded(folder, deepest * approach, force, "1000000 GPa", 0.3);
  const auto file = folder.write("case.prm", smooth_case());
  const auto output = folder.path / "diagnosis";
  const Outcome outcome =
      call("diagnose " + recording.string() + " --case " + file.string() +
           " --set 'Substrate/Young modulus=1000000 GPa' --set 'Substrate/Poisson ratio=0.3' --output " +
           output.string());
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  const auto said = nlohmann::json::parse(read_file(output / "diagnosis.json"));
  EXPECT_EQ(said["verdict"], "explained") << outcome.output;
  const auto& corrected = said["solutions"]["corrected"];
  ASSERT_EQ(corrected.size(), 1u) << outcome.output;
  const auto& entry = corrected["Particle/Yield stress"];
  EXPECT_NEAR(entry["value"].get<double>() / yield, 1, 0.05);
  EXPECT_LT(entry["ci95"][0], yield);
  EXPECT_GT(entry["ci95"][1], yield);
  EXPECT_NE(read_file(output / "corrected.prm").find("set Yield stress"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(output / "history_after.csv"));
}

TEST(DiagnoseCase_behaviour, what_it_cannot_take_is_refused) {
  const TemporaryFolder folder;
  const auto recording = recorded(folder, 40e-9, [](double d) { return d * 1e4; });
  const auto file = folder.write("case.prm", smooth_case());
  const std::string command = "diagnose " + recording.string() + " --output " + (folder.path / "d").string();
  const auto refused = [&](const std::string& more, const char* why) {
    const Outcome outcome = call(command + more);
    EXPECT_EQ(outcome.status, 2) << outcome.output;
    EXPECT_NE(outcome.output.find(why), std::string::npos) << outcome.output;
  };
  refused(" --case " + file.string() +
              " --set 'Interface/Work of adhesion=50 mJ/m^2' --set 'Interface/Adhesion range=1 nm'",
          "cases without adhesion so far");
  refused(" --case " + file.string() + " --set 'Experiment/Type=torsion' --set 'Experiment/Angle=1 mrad'",
          "Experiment/Type is torsion");
  refused(" --set 'Particle/Radius=1 um'", "name it with --case");
  refused(" --case " + (folder.path / "none.prm").string(), "none.prm");
}

}  // namespace
}  // namespace asperity

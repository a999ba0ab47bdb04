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
#include "dem_compare/laws/maugis_dugdale.h"
#include "tests/app/called_program.h"
#include "tests/app/smooth_case.h"
#include "tests/support/tabulated_yielding.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::call;
using test::Outcome;
using test::smooth_case;
using test::TemporaryFolder;

struct RecordedStep {
  double displacement, force;
  const char* segment;
};

/// A sphere of borosilicate on silicon or another plane, noise 0.5 % of the largest force.
std::filesystem::path recorded(const TemporaryFolder& folder, const std::vector<RecordedStep>& steps,
                               const char* modulus = "179 GPa", double poisson = 0.25) {
  const auto recording = folder.path / "recording";
  std::filesystem::create_directory(recording);
  const nlohmann::json glass{{"material", "borosilicate"},
                             {"youngs_modulus", "71 GPa"},
                             {"poissons_ratio", 0.17},
                             {"radius", "8.5 um"}};
  const nlohmann::json wafer{
      {"material", "silicon"}, {"youngs_modulus", modulus}, {"poissons_ratio", poisson}};
  nlohmann::json table{{"file", "pressed.csv"}, {"kind", "trace"}, {"response", "normal_force"}};
  table["control"] = std::vector<std::string>{"normal_displacement"};
  nlohmann::json about{{"format", "asperity-recording/1"},
                       {"title", "pressed"},
                       {"mode", "normal"},
                       {"particle", glass},
                       {"substrate", wafer}};
  about["tables"] = std::vector<nlohmann::json>{table};
  write_file_atomically(recording / "recording.json", about.dump());
  std::string csv = "time [s],normal_displacement [m],normal_force [N],segment\n";
  double largest = 0;
  for (const RecordedStep& step : steps) largest = std::max(largest, step.force);
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 0.005 * largest);
  double time = 0;
  for (const RecordedStep& step : steps)
    csv += printed("%g,%.9e,%.9e,%s\n", time += 0.1, step.displacement, step.force + noise(random),
                   step.segment);
  write_file_atomically(recording / "pressed.csv", csv);
  return recording;
}

/// Loading in 200 samples: `force` of the displacement.
std::vector<RecordedStep> loaded(double deepest, const std::function<double(double)>& force) {
  std::vector<RecordedStep> steps;
  for (int i = 1; i <= 200; ++i) steps.push_back({deepest * i / 200, force(deepest * i / 200), "load"});
  return steps;
}

/// What the program answers.
nlohmann::json diagnosed(const TemporaryFolder& folder, const std::filesystem::path& recording,
                         const std::string& more = "") {
  const auto file = folder.write("case.prm", smooth_case());
  const auto output = folder.path / "diagnosis";
  const Outcome outcome = call("diagnose " + recording.string() + " --case " + file.string() + " --output " +
                               output.string() + more);
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  auto said = nlohmann::json::parse(read_file(output / "diagnosis.json"));
  said["printed"] = outcome.output;
  return said;
}

constexpr double radius = 8.5e-6;
const char* const rigid_plane =
    " --set 'Substrate/Young modulus=1000000 GPa' --set 'Substrate/Poisson ratio=0.3'";

using test::TabulatedYielding;

/// To a depth and back, then to the next: rows `of_peak` of the table of unloadings.
std::vector<RecordedStep> cycles(const TabulatedYielding& truth, const std::vector<std::size_t>& of_peak) {
  std::vector<RecordedStep> steps;
  constexpr int count = 60;
  double from = 0, before = 0;
  for (std::size_t k = 0; k < of_peak.size(); ++k) {
    const std::size_t row = of_peak[k];
    const double deepest = truth.peak(row), back = truth.left(row);
    for (int i = 1; i <= count; ++i) {
      const double d = from + (deepest - from) * i / count;
      steps.push_back({d, d < before ? truth.unloading(d, of_peak[k - 1]) : truth.loading(d), "load"});
    }
    for (int i = 1; i <= count; ++i) {
      const double d = deepest + (back - deepest) * i / count;
      steps.push_back({d, truth.unloading(d, row), "unload"});
    }
    from = back;
    before = deepest;
  }
  return steps;
}

void expect_yielding(const nlohmann::json& said, double yield) {
  EXPECT_EQ(said["verdict"], "explained") << said["printed"].get<std::string>();
  const auto& corrected = said["forward_model"]["corrected"];
  ASSERT_EQ(corrected.size(), 1u) << said["printed"].get<std::string>();
  const auto& entry = corrected["Particle/Yield stress"];
  EXPECT_NEAR(entry["value"].get<double>() / yield, 1, 0.05);
  EXPECT_LT(entry["ci95"][0], yield);
  EXPECT_GT(entry["ci95"][1], yield);
}

TEST(DiagnoseCase_analytic, a_contact_of_Hertz_and_its_elastic_case_agree) {
  const TemporaryFolder folder;
  const Hertz hertz{reduced_modulus({71e9, 0.17}, {179e9, 0.25}), 8.5e-6};
  const auto recording = recorded(folder, loaded(40e-9, [&](double d) { return hertz.force(d); }));
  const auto file = folder.write("case.prm", smooth_case());
  const auto output = folder.path / "diagnosis";
  const std::string command =
      "diagnose " + recording.string() + " --case " + file.string() + " --output " + output.string();
  const Outcome outcome = call(command);
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  const auto said = nlohmann::json::parse(read_file(output / "diagnosis.json"));
  EXPECT_EQ(said["verdict"], "no_mismatch") << outcome.output;
  EXPECT_EQ(said["forward_model"]["kind"], "finite_elements");
  EXPECT_EQ(said["forward_model"]["solves"], 1);
  EXPECT_TRUE(std::filesystem::exists(output / "history_before.csv"));
  EXPECT_FALSE(std::filesystem::exists(output / "corrected.prm"));
  EXPECT_NE(read_file(output / "report.html").find("The simulation is the case itself"), std::string::npos);

  // What was solved is taken again.
  const auto solved = said["forward_model"]["before"].get<std::string>();
  const auto written = std::filesystem::last_write_time(solved + "/result.json");
  EXPECT_EQ(call(command).status, 0);
  EXPECT_EQ(std::filesystem::last_write_time(solved + "/result.json"), written);
  // Rows of the recording with what finite elements give; nothing was left out.
  const CsvTable before = read_csv(output / "before.csv"), after = read_csv(output / "after.csv");
  EXPECT_EQ(before.rows.size(), 200u);
  EXPECT_EQ(before.numbers("simulated_normal_force [N]"), after.numbers("simulated_normal_force [N]"));
  EXPECT_NEAR(after.numbers("simulated_normal_force [N]").back() / hertz.force(40e-9), 1, 0.02);

  // Solved cases are the simulation themselves; a recording can name its case.
  const auto other = folder.path / "other";
  const Outcome of_study = call("diagnose " + recording.string() + " --study " +
                                (output / "solves").string() + " --output " + other.string());
  EXPECT_EQ(of_study.status, 0) << of_study.output;
  EXPECT_FALSE(std::filesystem::exists(other / "solves"));
  const auto again = nlohmann::json::parse(read_file(other / "diagnosis.json"));
  EXPECT_EQ(again["verdict"], "no_mismatch");
  EXPECT_EQ(again["forward_model"]["before"], said["forward_model"]["before"]);
  EXPECT_EQ(read_file(other / "after.csv"), read_file(output / "after.csv"));
  // Less load is a part of the way to more.
  const auto smaller = folder.path / "smaller";
  std::filesystem::create_directory(smaller);
  std::filesystem::rename(recorded(folder, loaded(26e-9, [&](double d) { return hertz.force(d); })),
                          smaller / "recording");
  const Outcome of_less = call("diagnose " + (smaller / "recording").string() + " --study " +
                               (output / "solves").string() + " --output " + (smaller / "out").string());
  EXPECT_EQ(of_less.status, 0) << of_less.output;
  EXPECT_FALSE(std::filesystem::exists(smaller / "out/solves"));
  EXPECT_EQ(nlohmann::json::parse(read_file(smaller / "out/diagnosis.json"))["verdict"], "no_mismatch");
  recorded(folder, loaded(40e-9, [&](double d) { return hertz.force(d); }));
  auto about = nlohmann::json::parse(read_file(recording / "recording.json"));
  about["simulation"] = {{"case", "case.prm"}, {"study", "solved"}};
  write_file_atomically(recording / "recording.json", about.dump());
  std::filesystem::copy(file, recording / "case.prm");
  std::filesystem::rename(output / "solves", recording / "solved");
  const Outcome of_recording = call("diagnose " + recording.string() + " --output " + other.string());
  EXPECT_EQ(of_recording.status, 0) << of_recording.output;
  EXPECT_FALSE(std::filesystem::exists(other / "solves"));
  EXPECT_EQ(read_file(other / "after.csv"), read_file(output / "after.csv"));
  EXPECT_EQ(nlohmann::json::parse(read_file(other / "diagnosis.json"))["forward_model"]["case"],
            (recording / "case.prm").string());
}

/// Hertz' contact in series with a spring, against the elastic case: rivals that yield cost as little as the
/// recording allows.
TEST(DiagnoseCaseNightly_analytic, a_compliance_in_series_is_named_and_no_yielding) {
  constexpr double compliance = 6.77e-6, deepest = 40e-9;
  const Hertz hertz{reduced_modulus({71e9, 0.17}, {179e9, 0.25}), radius};
  std::vector<RecordedStep> steps;
  for (int i = 1; i <= 200; ++i) {
    const double force = hertz.force(deepest * i / 200);
    steps.push_back({deepest * i / 200 + compliance * force, force, "load"});
  }
  const TemporaryFolder folder;
  const auto said = diagnosed(folder, recorded(folder, steps));
  EXPECT_EQ(said["verdict"], "explained") << said["printed"].get<std::string>();
  ASSERT_EQ(said["left_out"].size(), 1u) << said["printed"].get<std::string>();
  EXPECT_EQ(said["left_out"][0]["effect"], "instrument_compliance");
  const auto& found = said["left_out"][0]["parameters"]["compliance"];
  EXPECT_LT(found["ci95"][0], compliance);
  EXPECT_GT(found["ci95"][1], compliance);
}

/// Loading to ten times the approach of first yield.
TEST(DiagnoseCaseNightly_other_code,
     yielding_is_named_with_its_yield_stress_and_the_corrected_case_predicts) {
  constexpr double yield = 1e9, deepest = 10;
  const TabulatedYielding truth(yield);
  const TemporaryFolder folder;
  const auto recording = recorded(
      folder, loaded(deepest * truth.approach_at_yield(), [&](double d) { return truth.loading(d); }),
      "1000000 GPa", 0.3);
  expect_yielding(diagnosed(folder, recording, rigid_plane), yield);
  const auto output = folder.path / "diagnosis";
  EXPECT_NE(read_file(output / "corrected.prm").find("set Yield stress"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(output / "history_after.csv"));
}

/// To five and ten times the approach of first yield, each with unloading; Poisson's ratio 0.17.
TEST(DiagnoseCaseNightly_other_code, yielding_is_named_from_cycles_of_loading_and_unloading) {
  constexpr double yield = 1e9;
  const TabulatedYielding truth(yield);
  const TemporaryFolder folder;
  const auto recording = recorded(folder, cycles(truth, {1, 2}), "1000000 GPa", 0.3);
  expect_yielding(diagnosed(folder, recording, rigid_plane), yield);
}

/// Of Maugis, pressed to 6 nm and pulled off again.
TEST(DiagnoseCaseNightly_analytic, attraction_is_named_with_its_work_of_adhesion) {
  constexpr double work = 0.5, range = 1.5e-9, deepest = 6e-9, back = 4e-9;
  const MaugisDugdale truth{reduced_modulus({71e9, 0.17}, {179e9, 0.25}), radius, work, work / range};
  std::vector<RecordedStep> steps;
  NormalState state;
  for (int i = 0; i < 240; ++i) {
    const double d = -back + (deepest + back) * (i < 120 ? i / 119.0 : (239 - i) / 119.0);
    state = truth.advance(state, d);
    steps.push_back({d, state.force, i < 120 ? "load" : "unload"});
  }
  const TemporaryFolder folder;
  const auto said = diagnosed(folder, recorded(folder, steps));
  EXPECT_NE(said["verdict"], "unexplained") << said["printed"].get<std::string>();
  ASSERT_EQ(said["left_out"].size(), 1u) << said["printed"].get<std::string>();
  EXPECT_EQ(said["left_out"][0]["effect"], "adhesion");
  const auto& entry = said["forward_model"]["corrected"]["Interface/Work of adhesion"];
  EXPECT_NEAR(entry["value"].get<double>() / work, 1, 0.05);
  EXPECT_LT(entry["ci95"][0], work);
  EXPECT_GT(entry["ci95"][1], work);
}

TEST(DiagnoseCase_behaviour, what_it_cannot_take_is_refused) {
  const TemporaryFolder folder;
  const auto recording = recorded(folder, loaded(40e-9, [](double d) { return d * 1e4; }));
  const auto file = folder.write("case.prm", smooth_case());
  const std::string command = "diagnose " + recording.string() + " --output " + (folder.path / "d").string();
  const auto refused = [&](const std::string& more, const char* why) {
    const Outcome outcome = call(command + more);
    EXPECT_EQ(outcome.status, 2) << outcome.output;
    EXPECT_NE(outcome.output.find(why), std::string::npos) << outcome.output;
  };
  refused(" --study " + recording.string(), "no solved case of normal contact");
  refused(" --study " + (folder.path / "nowhere").string(), "there is no folder");
  refused(" --set 'Mesh/Layers=3'", "name it with --case CASE.prm");
  refused(" --case " + file.string() + " --set 'Interface/Attraction force=1 uN'",
          "--case takes attraction over a range");
  refused(" --case " + file.string() + " --set 'Experiment/Type=torsion' --set 'Experiment/Angle=1 mrad'",
          "Experiment/Type is torsion");
  refused(" --case " + file.string() +
              " --set 'Particle/Relaxing share=0.3' --set 'Particle/Relaxation time=1 s'"
              " --set 'Particle/Yield stress=inf' --set 'Substrate/Yield stress=1 GPa'",
          "a body relaxes with time");
  refused(" --set 'Particle/Radius=1 um'", "name it with --case");
  refused(" --case " + (folder.path / "none.prm").string(), "none.prm");
}

TEST(DiagnoseCase_behaviour, a_case_whose_contact_outgrows_its_region_is_refused_with_the_remedy) {
  const TemporaryFolder folder;
  const Hertz bodies{reduced_modulus({71e9, 0.17}, {179e9, 0.25}), 8.5e-6};
  const auto recording = recorded(folder, loaded(60e-9, [&](double d) { return bodies.force(d); }));
  const double radius = bodies.contact_radius(bodies.force(60e-9));
  const auto file = folder.write(
      "case.prm", smooth_case() +
                      "subsection Particle\n set Yield stress = 500 MPa\nend\n"
                      "subsection Experiment\n set Load steps = 5\nend\n" +
                      printed("subsection Mesh\n set Contact region = %.4g nm\n", 1.02e9 * radius) +
                      printed(" set Interface spacing = %.4g nm\n set Layers = 2\nend\n", 1e9 * radius / 5));
  const Outcome outcome = call("diagnose " + recording.string() + " --case " + file.string() + " --output " +
                               (folder.path / "diagnosis").string());
  EXPECT_NE(outcome.status, 0);
  EXPECT_NE(
      outcome.output.find("edge of the finely meshed region; give the case a larger Mesh/Contact region"),
      std::string::npos)
      << outcome.output;
}

}  // namespace
}  // namespace asperity

// asperity diagnose --case where the truth is the solver's own on another mesh: bodies that relax, surfaces
// that attract.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>

#include "core/atomic_file.h"
#include "core/csv.h"
#include "core/printed.h"
#include "tests/app/called_program.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

/// A rough polymer under a silicon plane; `of_polymer`, `experiment`: more entries.
std::string polymer_case(const std::string& of_polymer, const std::string& experiment, double spacing_nm) {
  return "subsection Particle\n set Radius = 8.5 um\n set Young modulus = 3 GPa\n set Poisson ratio = "
         "0.34\n" +
         of_polymer +
         "end\nsubsection Substrate\n set Young modulus = 179 GPa\n set Poisson ratio = 0.25\n"
         " set Topography = generated(rms=2 nm, hurst=0.8, rolloff=400 nm, cutoff=160 nm, seed=4)\nend\n"
         "subsection Experiment\n" +
         experiment +
         printed("end\nsubsection Mesh\n set Interface spacing = %g nm\n set Layers = 2\n", spacing_nm) +
         "end\nsubsection Output\n set Fields = false\nend\n";
}

struct RelaxingTruth {
  std::string rows = "run,segment,time [s],normal_displacement [m],normal_force [N]\n";
  int runs = 0;
};

/// Pressed by 40 nm and drawn back, each in `time` [s], noise of 0.4 % of some 100 uN.
void press(const test::TemporaryFolder& folder, double time, std::mt19937& random, RelaxingTruth& truth) {
  constexpr int steps = 30;
  const std::string name = printed("truth%d", ++truth.runs);
  const auto file = folder.write(
      name + ".prm",
      polymer_case(" set Relaxing share = 0.5\n set Relaxation time = 8 s\n",
                   printed(" set Control = displacement\n set Normal approach = 40 nm\n set Load steps = %d\n"
                           " set Unload steps = %d\n set Load time = %g s\n",
                           steps, steps, time),
                   40));
  const auto solved = test::call("solve " + file.string() + " --output " + (folder.path / name).string());
  ASSERT_EQ(solved.status, 0) << solved.output;
  const CsvTable history = read_csv(folder.path / name / "history.csv");
  const auto times = history.numbers("time [s]"), depths = history.numbers("driven_displacement [m]"),
             forces = history.numbers("normal_force [N]");
  std::normal_distribution<double> noise(0, 0.4e-6);
  for (std::size_t k = 0; k < times.size(); ++k)
    for (const double share : {0.5, 1.0}) {
      const auto between = [&](const std::vector<double>& values) {
        return (1 - share) * (k > 0 ? values[k - 1] : 0) + share * values[k];
      };
      truth.rows += printed("%d,%s,%.6g,%.6e,%.6e\n", truth.runs, k < steps ? "load" : "unload",
                            between(times), between(depths), between(forces) + noise(random));
    }
}

/// A recording with these rows; its folder.
std::filesystem::path recording_of(const test::TemporaryFolder& folder, const std::string& rows) {
  const auto recording = folder.path / "recording";
  std::filesystem::create_directory(recording);
  write_file_atomically(recording / "data.csv", rows);
  const nlohmann::json polymer{
      {"material", "polymer"}, {"youngs_modulus", "3 GPa"}, {"poissons_ratio", 0.34}, {"radius", "8.5 um"}};
  const nlohmann::json silicon{
      {"material", "silicon"}, {"youngs_modulus", "179 GPa"}, {"poissons_ratio", 0.25}};
  nlohmann::json about{{"format", "asperity-recording/1"},
                       {"title", "polymer"},
                       {"mode", "normal"},
                       {"particle", polymer},
                       {"substrate", silicon}};
  nlohmann::json table{{"file", "data.csv"}, {"kind", "trace"}, {"response", "normal_force"}};
  table["control"] = std::vector<std::string>{"normal_displacement"};
  about["tables"] = std::vector<nlohmann::json>{table};
  write_file_atomically(recording / "recording.json", about.dump());
  return recording;
}

TEST(DiagnoseCaseNightly_other_code, a_body_that_relaxes_is_named_and_the_corrected_case_has_its_entries) {
  const test::TemporaryFolder folder;
  std::mt19937 random(3);
  RelaxingTruth truth;
  for (const double time : {2.0, 20.0}) press(folder, time, random, truth);
  const auto recording = recording_of(folder, truth.rows);
  const auto file = folder.write("mine.prm", polymer_case("", " set Normal load = 50 uN\n", 50));
  const auto output = folder.path / "diagnosis";
  const auto outcome = test::call("diagnose " + recording.string() + " --case " + file.string() +
                                  " --output " + output.string());
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  const auto said = nlohmann::json::parse(read_file(output / "diagnosis.json"));
  EXPECT_EQ(said["verdict"], "explained") << outcome.output;
  ASSERT_EQ(said["left_out"].size(), 1u) << outcome.output;
  EXPECT_EQ(said["left_out"][0]["effect"], "viscoelasticity");
  const auto& corrected = said["forward_model"]["corrected"];
  const auto expect_entry = [&](const char* name, double expected) {
    ASSERT_TRUE(corrected.contains(name)) << outcome.output;
    EXPECT_NEAR(corrected[name]["value"].get<double>() / expected, 1, 0.15) << name;
    EXPECT_LT(corrected[name]["ci95"][0], expected) << name;
    EXPECT_GT(corrected[name]["ci95"][1], expected) << name;
  };
  expect_entry("Particle/Relaxing share", 0.5);
  expect_entry("Particle/Relaxation time", 8);
  const auto solved = test::call("solve " + (output / "corrected.prm").string() + " --output " +
                                 (folder.path / "corrected").string());
  EXPECT_EQ(solved.status, 0) << solved.output;
  const auto again =
      test::call("diagnose " + recording.string() + " --case " + (output / "corrected.prm").string() +
                 " --output " + (folder.path / "again").string());
  ASSERT_EQ(again.status, 0) << again.output;
  EXPECT_EQ(nlohmann::json::parse(read_file(folder.path / "again" / "diagnosis.json"))["verdict"],
            "no_mismatch")
      << again.output;
}

/// The case refused for a short recording of normal contact, for a reason that holds `why`.
void expect_refused(const std::string& of_polymer, const std::string& changes, const char* why) {
  const test::TemporaryFolder folder;
  std::string rows = "run,segment,time [s],normal_displacement [m],normal_force [N]\n";
  for (int k = 0; k < 24; ++k) rows += printed("1,load,%d,%.3e,%.3e\n", k, k * 1e-9, k * 1e-6);
  const auto file = folder.write("case.prm", polymer_case(of_polymer, " set Normal load = 50 uN\n", 50));
  const auto outcome = test::call("diagnose " + recording_of(folder, rows).string() + " --case " +
                                  file.string() + changes + " --output " + (folder.path / "out").string());
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.output.find(why), std::string::npos) << outcome.output;
}

TEST(DiagnoseRelaxingCase_behaviour, what_its_law_does_not_hold_for_is_refused_in_a_sentence) {
  const std::string relaxes = " set Relaxing share = 0.5\n set Relaxation time = 8 s\n";
  expect_refused(relaxes, " --set 'Substrate/Relaxing share=0.2' --set 'Substrate/Relaxation time=1 s'",
                 "both bodies relax with time");
  expect_refused(relaxes, " --set 'Substrate/Yield stress=5 GPa'",
                 "only where no body yields and surfaces do not attract");
}

TEST(DiagnoseAttractingCase_behaviour, what_is_not_solved_for_a_recording_is_refused_in_a_sentence) {
  const std::string attracts =
      " --set 'Interface/Work of adhesion=0.1 J/m^2' --set 'Interface/Adhesion range=1 nm'";
  expect_refused("", attracts,
                 "what another realisation of a generated Topography changes in it is not known");
  expect_refused("", attracts + " --set 'Particle/Yield stress=0.1 GPa'",
                 "attraction between bodies that yield is not solved for a recording yet");
  expect_refused("", " --set 'Interface/Attraction force=1 uN'", "--case takes attraction over a range");
}

/// The challenge's history of attraction on a mesh of 14 nm, and its own case on one of 20 nm.
TEST(DiagnoseCaseNightly_other_code, a_case_that_attracts_as_recorded_leaves_nothing_out) {
  const test::TemporaryFolder folder;
  const std::string solved = ASPERITY_SOURCE_DIR "/diagnosis/challenge/data/adhesion_0.3";
  const auto hidden = folder.path / "hidden";
  const auto concealed =
      test::call("conceal --effect adhesion --mode normal --noise 0.01 --seed 4 --from-case " + solved +
                 " --output " + hidden.string());
  ASSERT_EQ(concealed.status, 0) << concealed.output;
  const auto said_of = [&](const std::string& changes, const char* output) {
    const auto outcome = test::call("diagnose " + hidden.string() + " --case " + solved +
                                    "/case.prm --set 'Mesh/Interface spacing=20 nm'" + changes +
                                    " --output " + (folder.path / output).string());
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    return nlohmann::json::parse(read_file(folder.path / output / "diagnosis.json"));
  };
  EXPECT_EQ(said_of("", "same")["verdict"], "no_mismatch");
  const auto other = said_of(
      " --set 'Interface/Work of adhesion=0.2 J/m^2' --set 'Interface/Work of adhesion on separation=0'",
      "other");
  ASSERT_EQ(other["left_out"].size(), 1u) << other.dump();
  EXPECT_EQ(other["left_out"][0]["effect"], "adhesion");
  EXPECT_NEAR(other["forward_model"]["corrected"]["Interface/Work of adhesion"]["value"].get<double>(), 0.3,
              0.015);
}

/// Rough by a scan, on the recorded place: half-spaces would need another solver of attraction.
TEST(DiagnoseCaseNightly_other_code, a_scanned_case_that_attracts_as_recorded_leaves_nothing_out) {
  const test::TemporaryFolder folder;
  const std::string at = folder.path.string(),
                    solver_case = ASPERITY_SOURCE_DIR "/diagnosis/challenge/data/adhesion_0.3/case.prm";
  const auto done = [](const std::string& command) {
    const auto outcome = test::call(command);
    ASSERT_EQ(outcome.status, 0) << outcome.output;
  };
  done(
      "surface generate --rms '1 nm' --size '2.5 um' --pixels 256 --rolloff '400 nm' --cutoff '120 nm' "
      "--seed 5 "
      "--output " +
      at + "/scan.gsf");
  done("solve " + solver_case + " --set 'Substrate/Topography=scan(" + at + "/scan.gsf, cutoff=120 nm)'" +
       " --set 'Interface/Work of adhesion=0.1 J/m^2' --set 'Interface/Work of adhesion on separation=0'"
       " --set 'Interface/Adhesion range=2 nm' --set 'Experiment/Normal approach=7 nm'"
       " --set 'Experiment/Load steps=16' --set 'Experiment/Retract=5 nm' --output " +
       at + "/truth");
  done("conceal --mode normal --noise 0.01 --seed 3 --from-case " + at + "/truth --output " + at +
       "/recording");
  done("diagnose " + at + "/recording --case " + at + "/truth/case.prm --set 'Mesh/Interface spacing=20 nm'" +
       " --output " + at + "/said");
  const auto said = nlohmann::json::parse(read_file(folder.path / "said" / "diagnosis.json"));
  EXPECT_EQ(said["verdict"], "no_mismatch") << said.dump();
}

}  // namespace
}  // namespace asperity

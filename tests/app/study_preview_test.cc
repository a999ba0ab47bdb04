// A study by half-spaces: what is kept, what is written, and means that solved cases correct.
#include "app/study_preview.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/atomic_file.h"
#include "core/csv.h"
#include "tests/app/called_program.h"
#include "tests/app/smooth_case.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::call;
using test::TemporaryFolder;

class StudyPreview_behaviour : public testing::Test {
 protected:
  StudyPreview_behaviour() {
    folder.write("base.prm", test::smooth_case());
    file =
        folder
            .write(
                "study.prm",
                "subsection Study\n  set Base case = base.prm\n  set Realisations = 3\n"
                "  subsection Vary\n    set Experiment/Normal load = 20 uN, 40 uN\n  end\nend\n"
                "subsection Substrate\n"
                "  set Topography = generated(rms=1 nm, hurst=0.8, rolloff=300 nm, cutoff=150 nm, seed=4)\n"
                "end\n")
            .string();
    output = folder.path / "previewed";
  }
  test::Outcome preview(const std::string& more = "") const {
    return call("study " + file + " --preview --output " + output.string() + more);
  }
  nlohmann::json summary() const { return nlohmann::json::parse(read_file(output / "previews.json")); }

  TemporaryFolder folder;
  std::string file;
  std::filesystem::path output;
};

TEST_F(StudyPreview_behaviour, writes_means_over_surfaces_and_keeps_what_is_there) {
  const auto outcome = preview();
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("6 of 6 cases previewed"), std::string::npos) << outcome.output;
  const auto found = summary();
  ASSERT_EQ(found["groups"].size(), 2u);
  EXPECT_EQ(found["cases"].size(), 6u);
  const auto& stiffness = found["groups"][0]["half_spaces"]["normal_stiffness"];
  EXPECT_EQ(stiffness["count"], 3);
  EXPECT_GT(stiffness["realisation_sd"], 0);
  EXPECT_FALSE(stiffness.contains("with_finite_elements"));
  double mean = 0;
  for (const auto& item : found["cases"])
    if (item["values"]["Normal load"] == "20 uN")
      mean += item["half_spaces"]["normal_stiffness"]["value"].get<double>() / 3;
  EXPECT_NEAR(stiffness["value"].get<double>() / mean, 1, 1e-12);
  const CsvTable table = read_csv(output / "previews.csv");
  EXPECT_NEAR(table.numbers("normal_stiffness [N/m]")[0] / mean, 1, 1e-8);
  EXPECT_EQ(table.rows.size(), 2u);

  const auto kept = std::filesystem::last_write_time(output / "previews/20_uN-r1.json");
  EXPECT_EQ(preview(" --set 'Experiment/Normal load=20 uN, 50 uN'").status, 0);
  EXPECT_EQ(std::filesystem::last_write_time(output / "previews/20_uN-r1.json"), kept);
  EXPECT_TRUE(std::filesystem::exists(output / "previews/50_uN-r2.json"));
  // Other inputs under the same name, and a file that was cut off, are not taken for this study's.
  EXPECT_EQ(preview(" --set 'Particle/Young modulus=60 GPa'").status, 0);
  EXPECT_NE(std::filesystem::last_write_time(output / "previews/20_uN-r1.json"), kept);
  for (const char* damaged : {"{\"elastic\": ", "{\"elastic\": [1]}", "7"}) {
    write_file_atomically(output / "previews/20_uN-r1.json", damaged);
    EXPECT_EQ(preview(" --set 'Particle/Young modulus=60 GPa'").status, 0) << damaged;
    EXPECT_EQ(summary()["cases"].size(), 6u);
  }
}

TEST_F(StudyPreview_behaviour, solved_cases_correct_the_means) {
  ASSERT_EQ(preview().status, 0);
  std::vector<double> all;
  const auto before = summary();
  for (const auto& item : before["cases"])
    if (item["values"]["Normal load"] == "20 uN")
      all.push_back(item["half_spaces"]["normal_stiffness"]["value"].get<double>());
  for (int r = 1; r <= 2; ++r) {
    std::filesystem::create_directories(output / ("20_uN-r" + std::to_string(r)));
    write_file_atomically(
        output / ("20_uN-r" + std::to_string(r)) / "result.json",
        nlohmann::json{
            {"format", "asperity-result/1"},
            {"effective", {{"normal_stiffness", {{"value", 1.1 * all[r - 1]}, {"unit", "N/m"}, {"sd", 0}}}}}}
            .dump());
  }
  ASSERT_EQ(preview().status, 0);
  const auto both = summary()["groups"][0]["half_spaces"]["normal_stiffness"]["with_finite_elements"];
  EXPECT_EQ(both["count"], 2);
  // Solved cases of other inputs do not count, and are said.
  const auto others = preview(" --set 'Particle/Young modulus=60 GPa'");
  EXPECT_EQ(others.status, 0);
  EXPECT_EQ(others.output.find("do not count"), std::string::npos);  // these results do not say of which
  write_file_atomically(output / "20_uN-r1/result.json",
                        "{\"format\": \"asperity-result/1\", \"inputs_sha256\": \"0\", \"effective\": {}}");
  EXPECT_NE(preview().output.find("1 solved cases in"), std::string::npos);
  EXPECT_NEAR(both["value"].get<double>() / (1.1 * (all[0] + all[1] + all[2]) / 3), 1, 1e-9);
}

TEST_F(StudyPreview_behaviour, chooses_cases_and_refuses_what_cannot_be_meant) {
  EXPECT_EQ(preview(" --only 20_uN-r1").status, 0);
  EXPECT_EQ(summary()["cases"].size(), 1u);
  EXPECT_EQ(preview(" --plan").status, 2);
  EXPECT_EQ(call("study " + file + " --preview").status, 2);
  const auto refused = preview(" --set 'Experiment/Normal load=20 N'");
  EXPECT_EQ(refused.status, 2) << refused.output;
}

}  // namespace
}  // namespace asperity

// A study by half-spaces: what is kept, what is written, and means that solved cases correct.
#include "app/study_preview.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "core/atomic_file.h"
#include "core/csv.h"
#include "core/error.h"
#include "tests/app/called_program.h"
#include "tests/app/smooth_case.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::call;
using test::TemporaryFolder;

TEST(DoubleSampling_analytic, a_mean_is_that_of_all_times_the_ratio_of_the_solved) {
  const std::vector<double> all{1, 2, 3, 4, 5, 6}, some{1, 2, 3};
  // Both methods in a fixed ratio: what is left is the error of the mean over all.
  const MeanOverSurfaces fixed = mean_by_double_sampling(all, some, {1.1, 2.2, 3.3});
  EXPECT_NEAR(fixed.value, 1.1 * 3.5, 1e-12);
  EXPECT_NEAR(fixed.sd, 1.1 * std::sqrt(3.5 / 6), 1e-12);
  EXPECT_THROW(mean_by_double_sampling(all, {1}, {1}), InputError);
  EXPECT_THROW(mean_by_double_sampling(all, {1, 2}, {1}), InputError);
  EXPECT_THROW(mean_by_double_sampling(all, {0, 0}, {1, 2}), InputError);
}

TEST(DoubleSampling_analytic, its_standard_deviation_is_the_scatter_of_the_estimate) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  constexpr int trials = 4000, surfaces = 40, solved = 8;
  double sum = 0, squares = 0, stated = 0;
  for (int n = 0; n < trials; ++n) {
    std::vector<double> all, half_spaces, elements;
    for (int k = 0; k < surfaces; ++k) {
      all.push_back(3 + normal(random));
      if (k >= solved) continue;
      half_spaces.push_back(all.back());
      elements.push_back(1.05 * all.back() + 0.1 * normal(random));
    }
    const MeanOverSurfaces mean = mean_by_double_sampling(all, half_spaces, elements);
    sum += mean.value / trials, squares += mean.value * mean.value / trials, stated += mean.sd / trials;
  }
  EXPECT_NEAR(sum, 3.15, 0.01);
  EXPECT_NEAR(stated / std::sqrt(squares - sum * sum), 1, 0.1);
}

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
  write_file_atomically(output / "previews/20_uN-r1.json", "{\"elastic\": ");
  EXPECT_EQ(preview(" --set 'Particle/Young modulus=60 GPa'").status, 0);
  EXPECT_EQ(summary()["cases"].size(), 6u);
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

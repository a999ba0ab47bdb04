#include "report/comparison/comparison_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "core/atomic_file.h"
#include "core/error.h"
#include "report/sentences/hertz_words.h"
#include "report/sentences/phrases.h"

namespace asperity::report {
namespace {

namespace fs = std::filesystem;

std::string verdict_of(const Comparison& comparison) {
  return verdict_against_hertz(comparison.groups[0], comparison.tolerance);
}

/// Folders of cases whose force is a known multiple of Hertz's.
class ComparedFolders : public testing::Test {
 protected:
  void SetUp() override {
    root = fs::temp_directory_path() / ("asperity-comparison-" + std::to_string(::getpid()));
    fs::create_directories(root);
  }
  void TearDown() override { fs::remove_all(root); }

  /// A contact that behaves as a sphere of `softness` times the radius, its approach counted from `offset`.
  fs::path write_case(const std::string& name, double softness, double offset = 0,
                      const std::string& seed = "1", const std::string& spacing = "10 nm",
                      bool finished = true) {
    const fs::path folder = root / name;
    fs::create_directories(folder);
    const std::string inputs =
        "subsection Particle\n set Radius = 8.5 um\n set Young modulus = 71 GPa\n set Poisson ratio = 0.17\n"
        " set Topography = generated(rms=1.5 nm, seed=" +
        seed +
        ")\nend\n"
        "subsection Substrate\n set Young modulus = 179 GPa\n set Poisson ratio = 0.25\nend\n"
        "subsection Mesh\n set Interface spacing = " +
        spacing + "\nend\n";
    write_file_atomically(folder / "case.prm", "set Title = " + name + "\n" + inputs);
    const Hertz hertz{reduced_modulus({71e9, 0.17}, {179e9, 0.25}), 8.5e-6 * softness};
    History history;
    for (int i = 1; i <= 8; ++i) {
      for (const auto& column : history_columns())
        if (column.always) (history.*column.values).push_back(0);
      const double force = i * 1.25e-4;
      history.normal_force.back() = force;
      history.normal_displacement.back() = hertz.approach(force) + offset;
      history.contact_area.back() = hertz.contact_area(force);
      history.max_pressure.back() = hertz.peak_pressure(force);
    }
    write_file_atomically(folder / "history.csv", format_history(history));
    if (finished) write_file_atomically(folder / "result.json", R"({"format": "asperity-result/1"})");
    return folder;
  }

  fs::path root;
};

TEST_F(ComparedFolders, hertz_itself_is_hertzian_at_every_load_analytic) {
  const Comparison comparison = compare_with_hertz(collect_cases({write_case("smooth", 1)}), 0.05);
  ASSERT_EQ(comparison.groups.size(), 1u);
  const GroupComparison& group = comparison.groups[0];
  for (const auto& load : group.loads) {
    EXPECT_NEAR(load.force_ratio.mean, 1, 1e-6);
    EXPECT_NEAR(load.stiffness_ratio.mean, 1, 1e-6);
    EXPECT_NEAR(load.area_ratio.mean, 1, 1e-6);
    EXPECT_NEAR(load.pressure_ratio.mean, 1, 1e-6);
  }
  EXPECT_NEAR(group.hertzian_from, 1.25e-4, 1e-10);
  EXPECT_EQ(verdict_of(comparison).find("softer"), std::string::npos);
  EXPECT_NEAR(group.numbers.fitted_radius.mean, 8.5e-6, 1e-11);
  EXPECT_FALSE(group.numbers.loading_stiffness.mesh.has_value());
}

TEST_F(ComparedFolders, a_contact_like_a_smaller_sphere_is_softer_by_the_cube_root_of_its_radius_analytic) {
  const Comparison comparison = compare_with_hertz(collect_cases({write_case("soft", 0.512)}), 0.05);
  // k = 2 E* (R delta)^(1/2) at given load scales with R^(1/3): 0.512^(1/3) = 0.8
  EXPECT_NEAR(comparison.groups[0].loads.back().stiffness_ratio.mean, 0.8, 1e-6);
  EXPECT_TRUE(std::isnan(comparison.groups[0].hertzian_from));
  EXPECT_NE(verdict_of(comparison).find("softer than Hertz by 20 % still at 1 mN"), std::string::npos)
      << verdict_of(comparison);
}

TEST_F(ComparedFolders, two_load_steps_are_too_few_to_judge_a_stiffness_and_said_to_be_behaviour) {
  const fs::path folder = write_case("short", 1);
  History history = read_history(folder / "history.csv");
  for (const auto& column : history_columns())
    if (column.always) (history.*column.values).resize(2);
  write_file_atomically(folder / "history.csv", format_history(history));
  const Comparison comparison = compare_with_hertz(collect_cases({folder}), 0.05);
  EXPECT_NE(verdict_of(comparison).find("too few load steps"), std::string::npos);
  EXPECT_EQ(comparison_markdown(comparison).find("nan"), std::string::npos);
}

TEST_F(ComparedFolders, cases_that_differ_by_their_seed_are_realisations_of_one_contact_behaviour) {
  const Comparison comparison =
      compare_with_hertz(collect_cases({write_case("a", 0.9, 0, "1"), write_case("b", 1.1, 0, "2")}), 0.05);
  ASSERT_EQ(comparison.groups.size(), 1u);
  EXPECT_EQ(comparison.groups[0].realisations, 2);
  const Scatter& ratio = comparison.groups[0].loads.back().stiffness_ratio;
  EXPECT_NEAR(ratio.mean, (std::cbrt(0.9) + std::cbrt(1.1)) / 2, 1e-6);
  EXPECT_NEAR(ratio.sd, (std::cbrt(1.1) - std::cbrt(0.9)) / std::sqrt(2.0), 1e-6);
  // 4.7 %: within a tolerance of 5 % it is not worth a word, above one of 2 % it is.
  EXPECT_EQ(verdict_of(comparison).find("scatter about it"), std::string::npos);
  const Comparison strict = compare_with_hertz(collect_cases({root / "a", root / "b"}), 0.02);
  EXPECT_NE(verdict_of(strict).find("scatter about it by up to 4.7 %"), std::string::npos)
      << verdict_of(strict);
}

TEST_F(ComparedFolders,
       cases_that_differ_by_their_spacing_give_the_mesh_error_and_stay_apart_from_the_scatter_analytic) {
  const Comparison comparison = compare_with_hertz(
      collect_cases({write_case("fine", 1, 0, "1", "5 nm"), write_case("coarse", 1.1, 0, "1", "10 nm")}),
      0.05);
  ASSERT_EQ(comparison.groups.size(), 2u);
  const double limit = 1 - (std::cbrt(1.1) - 1);  // first order: the step from 10 to 5 nm once more
  for (const auto& estimate :
       {comparison.groups[0].numbers.loading_stiffness, comparison.groups[0].loads.front().stiffness}) {
    ASSERT_TRUE(estimate.mesh.has_value());
    EXPECT_TRUE(estimate.mesh->order_is_assumed);
    EXPECT_NEAR(estimate.mesh->relative_error, 1 - limit, 1e-6);
    EXPECT_TRUE(std::isnan(estimate.mesh->standard_error));
  }
  EXPECT_NEAR(comparison.groups[1].numbers.loading_stiffness.mesh->relative_error, 1 - limit / std::cbrt(1.1),
              1e-6);
  EXPECT_TRUE(comparison.groups[0].is_finest);
  EXPECT_FALSE(comparison.groups[1].is_finest);
  EXPECT_TRUE(std::isnan(comparison.groups[0].loads.back().stiffness_ratio.sd));
}

TEST_F(ComparedFolders, realisations_that_one_spacing_lacks_do_not_pass_for_a_mesh_error_behaviour) {
  // Two realisations that differ by far and do not depend on the mesh; the coarse spacing has but one of
  // them.
  const std::vector<fs::path> folders{write_case("fine-1", 0.8, 0, "1", "5 nm"),
                                      write_case("fine-2", 1.2, 0, "2", "5 nm"),
                                      write_case("coarse-1", 0.8, 0, "1", "10 nm")};
  const Comparison comparison = compare_with_hertz(collect_cases(folders), 0.05);
  ASSERT_EQ(comparison.groups.size(), 2u);
  const Estimate& fine = comparison.groups[0].loads.back().stiffness;
  EXPECT_EQ(fine.count, 2);
  EXPECT_GT(fine.sd, 0);
  EXPECT_NEAR(fine.mesh->relative_error, 0, 1e-9);
}

TEST_F(ComparedFolders, a_mesh_error_carries_the_scatter_that_realisations_give_it_analytic) {
  const std::vector<fs::path> folders{
      write_case("fine-1", 1, 0, "1", "5 nm"), write_case("fine-2", 1, 0, "2", "5 nm"),
      write_case("coarse-1", 1.331, 0, "1", "10 nm"), write_case("coarse-2", 0.729, 0, "2", "10 nm")};
  const Comparison comparison = compare_with_hertz(collect_cases(folders), 0.05);
  // Errors of -10 % and +10 % of the stiffness: none on average, 10 % of standard error.
  const MeshError error = *comparison.groups[0].loads.back().stiffness.mesh;
  EXPECT_NEAR(error.relative_error, 0, 1e-6);
  EXPECT_NEAR(error.standard_error, 0.1, 1e-6);
  EXPECT_EQ(mesh_error_text(comparison.groups[0].loads.back().stiffness), "0 ± 10 %");
}

TEST_F(ComparedFolders,
       the_path_of_one_case_gives_stiffness_area_and_pressure_at_each_of_its_loads_analytic) {
  const Comparison comparison = compare_with_hertz(collect_cases({write_case("smooth", 1)}), 0.05);
  const GroupComparison& group = comparison.groups[0];
  ASSERT_EQ(group.loads.size(), 8u);
  for (const auto& load : group.loads) {
    const Hertz& hertz = group.numbers.hertz;
    EXPECT_NEAR(load.stiffness.mean / hertz.normal_stiffness(load.force), 1, 1e-6);
    EXPECT_NEAR(load.approach.mean / hertz.approach(load.force), 1, 1e-6);
    EXPECT_NEAR(load.mean_pressure.mean / hertz.peak_pressure(load.force), 2.0 / 3, 1e-6);
    EXPECT_LT(load.step_error, 1e-4);
  }
  const std::string csv = comparison_csv(comparison);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 9);
  EXPECT_NE(csv.find("stiffness [N/m],stiffness_sd [N/m],stiffness_mesh_error"), std::string::npos);
}

/// Three realisations of 0.99 +- 0.22: the mean lies within 5 %, its interval does not.
TEST_F(ComparedFolders,
       a_mean_whose_interval_reaches_beyond_the_tolerance_is_not_known_to_be_within_behaviour) {
  const std::vector<double> ratios{0.77, 0.99, 1.21};
  std::vector<fs::path> folders;
  for (std::size_t i = 0; i < ratios.size(); ++i)
    folders.push_back(write_case("r" + std::to_string(i), std::pow(ratios[i], 3), 0, std::to_string(i + 1)));
  const Comparison comparison = compare_with_hertz(collect_cases(folders), 0.05);
  ASSERT_EQ(comparison.groups.size(), 1u);
  const GroupComparison& group = comparison.groups[0];
  EXPECT_NEAR(group.loads.back().stiffness_ratio.mean, 0.99, 1e-6);
  EXPECT_NEAR(group.loads.back().stiffness_ratio.sd, 0.22, 1e-6);
  // Student's t with two degrees of freedom: 4.53 standard errors hold as much as two standard deviations of
  // a normal distribution.
  EXPECT_NEAR(group.loads.back().stiffness_half_width, 4.527 * 0.22 / std::sqrt(3.0), 2e-3);
  EXPECT_EQ(group.judged_at_all_loads, Judged::not_known);
  EXPECT_TRUE(std::isnan(group.hertzian_from));
  EXPECT_NE(verdict_of(comparison).find("is not known at 1 mN: softer by 1 % (-58 to +56 %)"),
            std::string::npos)
      << verdict_of(comparison);
}

TEST_F(ComparedFolders, a_mesh_error_beyond_the_tolerance_leaves_a_verdict_open_behaviour) {
  const Comparison comparison = compare_with_hertz(
      collect_cases({write_case("fine", 1, 0, "1", "5 nm"), write_case("coarse", 1.331, 0, "1", "10 nm")}),
      0.05);
  EXPECT_EQ(comparison.groups[0].judged_at_all_loads, Judged::not_known);
  EXPECT_NEAR(comparison.groups[0].loads.back().stiffness_half_width, 0.1, 1e-3);
}

/// Stiffer with the load: from 0.9499 of Hertz's to Hertz's.
TEST_F(ComparedFolders, a_verdict_does_not_contradict_itself_where_the_tolerance_is_crossed_behaviour) {
  const fs::path folder = write_case("crossing", 1);
  History history = read_history(folder / "history.csv");
  const Hertz hertz{reduced_modulus({71e9, 0.17}, {179e9, 0.25}), 8.5e-6};
  for (std::size_t i = 0; i < history.size(); ++i)
    history.normal_displacement[i] =
        hertz.approach(history.normal_force[i]) + 1.1e-9 * std::log(history.normal_force[i] / 1e-3);
  write_file_atomically(folder / "history.csv", format_history(history));
  for (const double tolerance : {0.02, 0.03, 0.04, 0.05, 0.06}) {
    const GroupComparison group = compare_with_hertz(collect_cases({folder}), tolerance).groups[0];
    const std::string words = verdict_against_hertz(group, tolerance);
    const std::string by = "by " + std::to_string(static_cast<int>(std::lround(100 * tolerance))) + " %";
    EXPECT_EQ(words.find(by), std::string::npos) << words;
    if (std::isnan(group.hertzian_from)) continue;
    bool is_a_load = false;
    for (const auto& load : group.loads) is_a_load = is_a_load || load.force == group.hertzian_from;
    EXPECT_TRUE(is_a_load);
    const std::string from = format_quantity(group.hertzian_from, Dimension::force, 3);
    if (group.hertzian_from > group.loads.front().force) {
      EXPECT_EQ(words.find("at " + from + ", within"), std::string::npos) << words;
    }
  }
}

TEST_F(ComparedFolders, a_smooth_elastic_contact_is_a_control_behaviour) {
  const fs::path folder = write_case("smooth", 1);
  EXPECT_FALSE(compare_with_hertz(collect_cases({folder}), 0.05)
                   .groups[0]
                   .is_control);  // rough, as the other tests have it
  std::string text = read_file(folder / "case.prm");
  text.erase(text.find(" set Topography"),
             text.find(")", text.find(" set Topography")) + 2 - text.find(" set Topography"));
  write_file_atomically(folder / "case.prm", text);
  EXPECT_TRUE(compare_with_hertz(collect_cases({folder}), 0.05).groups[0].is_control);
}

TEST_F(ComparedFolders, a_study_says_which_of_its_cases_are_missing_behaviour) {
  write_case("rough-r1", 0.9);
  write_case("rough-r2", 0.9, 0, "2", "10 nm", false);
  const auto entry = [](const std::string& name, const std::string& state) {
    return R"({"name": ")" + name + R"(", "folder": ")" + name +
           R"(", "values": {"Surface": "rough"}, "state": ")" + state + R"("})";
  };
  write_file_atomically(root / "study.json",
                        R"({"format": "asperity-study/1", "title": "S", "axes": [{"name": "Surface",
      "values": ["rough"]}], "cases": [)" +
                            entry("rough-r1", "done") + "," + entry("rough-r2", "stopped") + "," +
                            entry("rough-r3", "done") + "]}");
  Comparison comparison = compare_with_hertz(collect_cases({root}), 0.05);
  EXPECT_EQ(comparison.planned, 3u);
  ASSERT_EQ(comparison.missing.size(), 2u);
  EXPECT_EQ(comparison.missing[0].state, "stopped");
  EXPECT_EQ(comparison.missing[1].state, "its folder is gone");
  ASSERT_EQ(comparison.groups.size(), 1u);
  EXPECT_EQ(comparison.groups[0].label, "rough");
  comparison.remarks.push_back("2.3 % of its energy is not accounted for");
  const std::string markdown = comparison_markdown(comparison);
  EXPECT_NE(markdown.find("In doubt:\n- 2.3 % of its energy"), std::string::npos);
  EXPECT_EQ(comparison_json(comparison)["in_doubt"].size(), 1u);
  EXPECT_EQ(comparison_json(comparison).dump().find("nan"), std::string::npos);
  EXPECT_NE(markdown.find("rough-r2: stopped"), std::string::npos);
  EXPECT_EQ(comparison_json(comparison)["missing"].size(), 2u);
}

TEST_F(ComparedFolders, a_folder_that_is_neither_case_nor_study_is_refused_behaviour) {
  EXPECT_THROW(collect_cases({root}), InputError);
}

TEST(PlusMinus_behaviour, shows_as_many_digits_as_the_scatter_deserves) {
  EXPECT_EQ(plus_minus({3, 0.93123, 0.0213, 0.01}), "0.931 ± 0.021");
  EXPECT_EQ(plus_minus({3, 24321.0, 512.0, 300}, 1000), "24.32 ± 0.51");
  EXPECT_EQ(plus_minus({3, 0, 0, 0}), "0");
  EXPECT_EQ(plus_minus({1, 0.93123, std::nan(""), std::nan("")}), "0.931");
}

}  // namespace
}  // namespace asperity::report

// Pages of studies of moving contacts, made from known powers.
#include "report/motion/resistance_section.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "core/atomic_file.h"
#include "report/motion/resistance_charts.h"
#include "report/report.h"
#include "tests/dem_compare/resistance/moving_study.h"
#include "tests/report/synthetic_case.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using test::MovingFolder;
using test::StudyEntry;
using test::TemporaryFolder;

/// Three surfaces, three motions, two loads; rolling of one on three radii and without yielding.
std::vector<StudyEntry> moving_contacts() {
  std::vector<StudyEntry> entries;
  unsigned random = 0;
  const auto add = [&](const std::string& label, MovingFolder made) {
    for (const char* type : {"sliding", "rolling", "torsion"})
      for (const double load : {1e-4, 3e-4}) {
        made.experiment = type, made.load = load, made.noise = 0.05, made.hills = 2, made.random = ++random;
        const double length = std::string(type) == "sliding" ? 1 : made.contact_radius();
        made.friction = 0.2 * load * length,
        made.plastic = made.yield_stress == "inf" ? 0 : 0.1 * load * length * (1 - 0.1 * made.rms);
        entries.push_back({label, made});
      }
  };
  for (const double rms : {0.3, 1.5, 2.7}) {
    MovingFolder made;
    made.rms = rms;
    std::ostringstream label;
    label << rms << " nm";
    add(label.str(), made);
  }
  MovingFolder elastic, small, large;
  elastic.yield_stress = "inf", small.radius = 2.5e-6, large.radius = 50e-6;
  add("elastic", elastic), add("R 2.5 um", small), add("R 50 um", large);
  return entries;
}

std::string report_of(const fs::path& root) {
  write_report(root);
  const std::string page = read_file(root / "report.html");
  if (const char* kept = std::getenv("ASPERITY_KEEP_REPORTS")) {
    fs::create_directories(kept);
    write_file_atomically(
        fs::path(kept) /
            (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".html"),
        page);
  }
  return page;
}

TEST(ResistancePage_behaviour,
     a_study_of_moving_contacts_alone_answers_both_questions_without_words_on_unloading) {
  const TemporaryFolder root;
  const std::string html = report_of(test::write_moving_study(root.path, moving_contacts()));
  for (const char* part :
       {"Length of rolling resistance: λ = a", "Length of torsion resistance: λ = a",
        "Sliding: dissipation by mechanism", "Rolling: dissipation by mechanism",
        "Torsion: dissipation by mechanism", "With roughness", "With a mechanism switched off",
        "Beside the measurement", "The fall of rolling friction with roughness is due to yielding",
        "R 2.5 µm", "how much does each mechanism dissipate?", "Largest relative errors"})
    EXPECT_TRUE(test::has(html, part)) << part;
  for (const char* part :
       {"Against Hertz", "imprint", "unloading", "There is nothing to judge", "lambda", "+-"})
    EXPECT_FALSE(test::has(html, part)) << part;
  const std::string csv = read_file(root.path / "resistance.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 6 * 3 * 2);
  const auto json = nlohmann::json::parse(read_file(root.path / "resistance.json"));
  EXPECT_EQ(json["contacts"].size(), 6u);
}

TEST(ResistancePage_behaviour, what_relaxing_bodies_dissipate_is_called_relaxation) {
  const TemporaryFolder root;
  MovingFolder relaxing;
  relaxing.friction = 20e-6, relaxing.plastic = 5e-6, relaxing.yield_stress = "inf";
  relaxing.relaxing_share = 0.4;
  const std::string html = report_of(test::write_moving_study(root.path, {{"relaxing", relaxing}}));
  EXPECT_TRUE(test::has(html, "relaxation [%]"));
  EXPECT_FALSE(test::has(html, "yielding [%]"));
}

TEST(ResistancePage_behaviour, pressed_and_moving_cases_in_one_study_have_both_parts) {
  const TemporaryFolder root;
  test::write_moving_study(root.path, {{"rough", MovingFolder()}});
  test::SyntheticCase pressed;
  pressed.fields = false;
  test::write_synthetic_case(pressed, root.path / "pressed");
  auto study = nlohmann::ordered_json::parse(read_file(root.path / "study.json"));
  study["axes"][0]["values"].push_back("normal");
  study["cases"].push_back({{"name", "pressed"},
                            {"folder", "pressed"},
                            {"values", {{"Type", "normal"}, {"Normal load", "1 mN"}, {"Variant", "rough"}}},
                            {"realisation", 1},
                            {"state", "done"}});
  write_file_atomically(root.path / "study.json", study.dump());
  const std::string html = report_of(root.path);
  for (const char* part :
       {"Sliding: dissipation by mechanism", "Against Hertz", "Stiffness, load by load", "not identifiable"})
    EXPECT_TRUE(test::has(html, part)) << part;
  EXPECT_FALSE(test::has(html, "Rolling: dissipation"));
}

TEST(ResistancePage_behaviour, a_study_that_was_only_pressed_has_no_words_on_motion) {
  const TemporaryFolder root;
  MovingFolder pressed;
  pressed.experiment = "normal";
  const std::string html = report_of(test::write_moving_study(root.path, {{"one", pressed}}));
  EXPECT_FALSE(test::has(html, "dissipation by mechanism"));
  EXPECT_FALSE(fs::exists(root.path / "resistance.csv"));
}

TEST(ResistancePage_analytic, charts_show_what_went_in) {
  const TemporaryFolder root;
  const auto findings =
      find_resistances(collect_cases({test::write_moving_study(root.path, moving_contacts())}));
  const auto over_load =
      report::resistance_over_load(findings.study, rolling_mode(), report::ResistanceUnit::contact);
  ASSERT_EQ(over_load.series.size(), 6u);
  EXPECT_NEAR(over_load.series[1].x[0], 100, 1e-6);
  EXPECT_NEAR(over_load.series[1].y[0], 0.2 + 0.085, 3 * over_load.series[1].error[0]);
  ASSERT_EQ(findings.trends.size(), 3u);
  const auto parts = report::parts_over_rms(findings.trends[1], findings.trends[1].loads[0]);
  ASSERT_EQ(parts.series.size(), 2u);  // nothing adheres
  EXPECT_NEAR(parts.series[1].y[2], 0.073, 3 * parts.series[1].error[2]);
}

TEST(ResistancePage_behaviour, labels_cannot_break_the_page) {
  const TemporaryFolder root;
  MovingFolder other;
  other.rms = 2.7;  // one contact alone is "the contact"
  const std::string html =
      report_of(test::write_moving_study(root.path, {{"rough <b>", MovingFolder()}, {"rougher <b>", other}}));
  EXPECT_FALSE(test::has(html, "<b>"));
  EXPECT_TRUE(test::has(html, "rough &lt;b&gt;"));
}

}  // namespace
}  // namespace asperity

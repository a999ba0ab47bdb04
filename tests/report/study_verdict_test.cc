// The headline of a study: by intervals, and without its smooth control.
#include "report/study/study_verdict.h"

#include <gtest/gtest.h>

#include "report/report.h"
#include "tests/report/synthetic_case.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

namespace asperity {
namespace {

std::string rough(int seed) {
  return "generated(rms=1.5 nm, hurst=0.8, rolloff=200 nm, cutoff=40 nm, seed=" + std::to_string(seed) + ")";
}

std::string entry_of(const std::string& name, const std::string& surface, int realisation) {
  return R"({"name": ")" + name + R"(", "folder": ")" + name + R"(", "values": {"Surface": ")" + surface +
         R"("}, "realisation": )" + std::to_string(realisation) + R"(, "state": "done"})";
}

/// The smooth control, one surface 15 % softer, one that agrees, one whose three realisations are 0.99 +-
/// 0.22.
TEST(StudyVerdict_behaviour, counts_by_intervals_and_leaves_out_the_smooth_control) {
  const test::TemporaryFolder root;
  std::string cases;
  const auto add = [&](const std::string& name, const std::string& surface, double stiffness, int seed) {
    test::SyntheticCase made;
    made.imprint = 0, made.fields = false, made.yield_stress = "inf";
    made.softness = std::pow(stiffness, 3);
    if (seed > 0) made.topography = rough(seed);
    test::write_synthetic_case(made, root.path / name);
    cases += (cases.empty() ? "" : ",") + entry_of(name, surface, std::max(seed, 1));
  };
  add("s", "smooth", 1, 0);
  add("soft", "soft", 0.85, 1), add("same", "same", 1, 1);
  add("w1", "wide", 0.77, 1), add("w2", "wide", 0.99, 2), add("w3", "wide", 1.21, 3);
  write_file_atomically(root.path / "study.json",
                        R"({"format": "asperity-study/1", "title": "S", "realisations": 3, "axes": [{"name":
      "Surface", "values": ["smooth", "soft", "same", "wide"]}], "cases": [)" +
                            cases + "]}");
  const CaseCollection collection = collect_cases({root.path});
  const Comparison comparison = compare_with_hertz(collection, 0.05);
  const std::string html = report::study_verdict(collection, report::curves_of(collection, comparison));
  EXPECT_TRUE(test::has(
      html, "1 of 3 contacts is as stiff as Hertz within 5 % at every load, 1 is not, of 1 it is not known"))
      << html;
  EXPECT_FALSE(test::has(html, "of 4 contacts"));
  EXPECT_TRUE(test::has(html, "Error of the computation, where the truth is known")) << html;
}

TEST(Report_behaviour,
     of_a_case_whose_energy_does_not_balance_says_so_and_gives_no_verdict_beyond_five_per_cent) {
  const test::TemporaryFolder root;
  test::SyntheticCase made;
  made.fields = false;
  for (const auto& [energy, part] :
       {std::pair{"0.023", "2.3 % of its energy is not accounted for"}, std::pair{"0.16", "No verdict"}}) {
    test::write_synthetic_case(made, root.path);
    std::string result = read_file(root.path / "result.json");
    result.replace(result.find("0.0042"), 6, energy);
    write_file_atomically(root.path / "result.json", result);
    write_report(root.path);
    EXPECT_TRUE(test::has(read_file(root.path / "report.html"), part)) << energy;
  }
}

}  // namespace
}  // namespace asperity

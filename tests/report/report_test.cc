#include "report/report.h"

#include <gtest/gtest.h>

#include <unistd.h>
#include <regex>

#include <cstdlib>

#include "core/error.h"
#include "report/fields/virtual_display.h"
#include "tests/report/synthetic_case.h"
#include "tests/support/text.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

class ReportFolder_behaviour : public testing::Test {
 protected:
  void SetUp() override {
    const char* kept = std::getenv("ASPERITY_KEEP_REPORTS");  // a folder, to look at the pages
    root = kept ? fs::path(kept) / testing::UnitTest::GetInstance()->current_test_info()->name()
                : fs::temp_directory_path() / ("asperity-report-" + std::to_string(::getpid()));
    fs::create_directories(root);
  }
  void TearDown() override {
    if (!std::getenv("ASPERITY_KEEP_REPORTS")) fs::remove_all(root);
  }
  std::string report() const {
    write_report(root);
    return read_file(root / "report.html");
  }
  static std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
  }
  /// Nothing is fetched from anywhere.
  static void expect_self_contained(const std::string& html) {
    EXPECT_FALSE(test::has(html, "http://"));
    EXPECT_FALSE(test::has(html, "https://"));
    EXPECT_FALSE(test::has(html, "<script"));
    EXPECT_FALSE(test::has(html, "<link"));
    EXPECT_FALSE(test::has(html, "@import"));
    EXPECT_FALSE(test::has(html, "url("));
    EXPECT_EQ(count(html, "href='"), count(html, "href='data:image/png;base64,"));
  }

  static std::string study_json(const std::string& cases) {
    return R"({"format": "asperity-study/1", "title": "Three surfaces", "realisations": 2,
      "axes": [{"name": "Normal load", "values": ["500 uN", "1 mN"]}, {"name": "Surface",
          "values": ["smooth", "rough"]}],
      "cases": [)" +
           cases + "]}";
  }
  static std::string entry(const std::string& name, const std::string& load, const std::string& surface,
                           int realisation, const std::string& state) {
    return R"({"name": ")" + name + R"(", "folder": ")" + name + R"(", "values": {"Normal load": ")" + load +
           R"(", "Surface": ")" + surface + R"("}, "realisation": )" + std::to_string(realisation) +
           R"(, "state": ")" + state + R"("})";
  }
  fs::path root;
};

TEST_F(ReportFolder_behaviour,
       a_solved_case_has_verdict_surfaces_curves_pressure_section_and_tables_in_one_file) {
  test::SyntheticCase made;
  made.softness = 0.7;
  made.topography = "generated(rms=1.5 nm, hurst=0.8, rolloff=200 nm, cutoff=40 nm, seed=1)";
  test::write_synthetic_case(made, root);
  const std::string html = report();
  expect_self_contained(html);
  // 0.7^(1/3) = 0.888, with the interval of what the mesh leaves.
  EXPECT_TRUE(std::regex_search(html, std::regex("softer than Hertz by 11 %( \\([^)]*\\))? still at 1 mN")))
      << html.substr(html.find("Loading: "), 200);
  for (const char* part :
       {"RMS 1.5 nm", "Load against approach", "Real contact area", "Contact pressure",
        "Gap, and what is closed", "5.95 µm", "8.5 µm", "4 cells over its shortest wave of 40 nm",
        "facets miss 5.2 % of its slope variance", "with 3.1 % of the scan's slope variance", "energy",
        "0.42 %", "1 min 23 s", "1.77 GiB", "9.4.1", "Particle/Radius"})
    EXPECT_TRUE(test::has(html, part)) << part;
}

TEST_F(ReportFolder_behaviour,
       sections_are_drawn_where_there_is_a_display_server_and_else_said_to_be_missing) {
  test::write_synthetic_case({}, root);
  const bool can_draw = report::VirtualDisplay().available();
  const std::string html = report();
  EXPECT_EQ(test::has(html, "equivalent plastic strain [%]"), can_draw);
  EXPECT_EQ(test::has(html, "could not be drawn"), !can_draw);
}

TEST_F(ReportFolder_behaviour, without_a_display_server_the_report_says_so_and_is_written_all_the_same) {
  test::write_synthetic_case({}, root);
  const std::string path = std::getenv("PATH");
  const char* display = std::getenv("DISPLAY");
  const std::string kept_display = display ? display : "";
  setenv("PATH", root.c_str(), 1);
  unsetenv("DISPLAY");
  const std::string html = report();
  setenv("PATH", path.c_str(), 1);
  if (display) setenv("DISPLAY", kept_display.c_str(), 1);
  EXPECT_TRUE(test::has(html, "install the package xvfb"));
  EXPECT_TRUE(test::has(html, "Gap, and what is closed"));
}

TEST_F(ReportFolder_behaviour, a_display_that_does_not_answer_does_not_take_the_report_with_it) {
  test::write_synthetic_case({}, root);
  const std::string path = std::getenv("PATH");
  const char* display = std::getenv("DISPLAY");
  const std::string kept_display = display ? display : "";
  setenv("PATH", root.c_str(), 1);
  setenv("DISPLAY", ":4711", 1);
  const std::string html = report();
  setenv("PATH", path.c_str(), 1);
  display ? setenv("DISPLAY", kept_display.c_str(), 1) : unsetenv("DISPLAY");
  EXPECT_TRUE(test::has(html, "VTK could not draw on display :4711"));
}

TEST_F(ReportFolder_behaviour,
       a_smooth_elastic_case_is_told_that_its_departure_is_the_error_of_the_computation) {
  test::SyntheticCase made;
  made.yield_stress = "inf";
  made.imprint = 0;
  test::write_synthetic_case(made, root);
  const std::string html = report();
  EXPECT_TRUE(test::has(html, "must follow Hertz"));
  EXPECT_TRUE(test::has(html, "as stiff as Hertz within 5 %"));
  EXPECT_TRUE(test::has(html, "No material has yielded"));
  EXPECT_TRUE(test::has(html, "nothing has yielded"));
  EXPECT_FALSE(test::has(html, "shortest wave"));
}

TEST_F(ReportFolder_behaviour, bodies_that_relax_are_said_to_and_need_not_follow_Hertz) {
  test::SyntheticCase made;
  made.yield_stress = "inf\n set Relaxing share = 0.4\n set Relaxation time = 2 s";
  made.imprint = 0;
  test::write_synthetic_case(made, root);
  const std::string html = report();
  EXPECT_TRUE(test::has(html, "40 % of its shear modulus relax with 2 s"));
  EXPECT_TRUE(test::has(html, "Hertz' curves are those of fast loading"));
  EXPECT_FALSE(test::has(html, "must follow Hertz"));
}

TEST_F(ReportFolder_behaviour, an_unfinished_case_is_shown_as_far_as_it_came) {
  test::SyntheticCase made;
  made.finished = false;
  made.fields = false;
  test::write_synthetic_case(made, root);
  const std::string html = report();
  EXPECT_TRUE(test::has(html, "This case is not finished"));
  EXPECT_TRUE(test::has(html, "There are no fields"));
  EXPECT_TRUE(test::has(html, "Load against approach"));
}

TEST_F(ReportFolder_behaviour, a_study_shows_scatter_over_realisations_and_names_what_is_missing) {
  test::SyntheticCase made;
  made.imprint = 0;
  made.title = "smooth";
  made.yield_stress = "inf";
  test::write_synthetic_case(made, root / "s1");
  made.load = 5e-4;
  made.fields = false;
  test::write_synthetic_case(made, root / "s05");
  made.load = 1e-3;
  made.topography = "generated(rms=1.5 nm, hurst=0.8, rolloff=200 nm, cutoff=40 nm, seed=1)";
  made.softness = 0.85;
  test::write_synthetic_case(made, root / "r1");
  made.softness = 0.75;
  made.fields = true;
  test::write_synthetic_case(made, root / "r2");
  write_file_atomically(root / "study.json", study_json(entry("s05", "500 uN", "smooth", 1, "done") + "," +
                                                        entry("s1", "1 mN", "smooth", 1, "done") + "," +
                                                        entry("r1", "1 mN", "rough", 1, "done") + "," +
                                                        entry("r2", "1 mN", "rough", 2, "done") + "," +
                                                        entry("r05", "500 uN", "rough", 1, "waiting")));
  const std::string html = report();
  expect_self_contained(html);
  EXPECT_TRUE(test::has(html, "1 of 5 cases are not in this report"));
  EXPECT_TRUE(test::has(html, "r05: waiting"));
  // 52.2 kN/m times 0.85^(1/3) and 0.75^(1/3): mean 48.46, sd 1.44
  EXPECT_TRUE(test::has(html, "48.5 ± 1.4"));
  EXPECT_TRUE(test::has(html, "Error of the computation, where the truth is known"));
  EXPECT_TRUE(test::has(html, "mesh error"));
}

TEST_F(ReportFolder_behaviour, a_study_shows_stiffness_against_load_rms_and_spectrum_on_the_finest_mesh) {
  const auto rough = [](const char* rms, const char* rolloff, int seed) {
    return std::string("generated(rms=") + rms + " nm, window=2.5 um, hurst=0.8, rolloff=" + rolloff +
           " nm, cutoff=80 nm, seed=" + std::to_string(seed) + ")";
  };
  struct Contact {
    std::string surface, topography;
    double softness;
  };
  const std::vector<Contact> contacts{{"smooth", "smooth", 1},
                                      {"low", rough("0.5", "500", 1), 0.9},
                                      {"high", rough("1.5", "500", 1), 0.7},
                                      {"high, short waves", rough("1.5", "200", 1), 0.6}};
  std::string cases;
  for (const auto& contact : contacts)
    for (const char* spacing : {"10 nm", "20 nm"}) {
      test::SyntheticCase made;
      made.imprint = 0;
      made.fields = false;
      made.topography = contact.topography;
      made.softness = contact.softness * (std::string(spacing) == "10 nm" ? 1 : 1.05);
      made.spacing = std::string(spacing) == "10 nm" ? 10e-9 : 20e-9;
      const std::string name = contact.surface + spacing;
      test::write_synthetic_case(made, root / name);
      cases +=
          (cases.empty() ? "" : ",") +
          (R"({"name": ")" + name + R"(", "folder": ")" + name + R"(", "values": {"Interface spacing": ")" +
           spacing + R"(", "Surface": ")" + contact.surface + R"("}, "realisation": 1, "state": "done"})");
    }
  write_file_atomically(root / "study.json",
                        R"({"format": "asperity-study/1", "title": "Spectra", "realisations": 1,
      "axes": [{"name": "Interface spacing", "values": ["10 nm", "20 nm"]}, {"name": "Surface",
      "values": ["smooth", "low", "high", "high, short waves"]}], "cases": [)" +
                            cases + "]}");
  const std::string html = report();
  expect_self_contained(html);
  for (const char* part :
       {"Stiffness against load", "Stiffness against roughness", "Stiffness against spectrum",
        "scans of 2.5 µm", "Results are those of the finest mesh (10 nm"})
    EXPECT_TRUE(test::has(html, part)) << part;
  EXPECT_FALSE(test::has(html, "10 nm, high"));  // the mesh is no property of a contact
  // From 20 to 10 nm the stiffness falls by 1.05^(1/3) - 1 = 1.64 %: as much again to the limit.
  EXPECT_TRUE(test::has(html, "+1.6 %"));
}

TEST_F(ReportFolder_behaviour, a_study_without_any_result_yet_lists_its_cases) {
  write_file_atomically(root / "study.json", study_json(entry("a", "1 mN", "smooth", 1, "running")));
  EXPECT_TRUE(test::has(report(), "a: running"));
}

TEST_F(ReportFolder_behaviour, a_title_cannot_break_the_page) {
  test::SyntheticCase made;
  made.title = "<b>\"1\" & 'x'";
  made.fields = false;
  test::write_synthetic_case(made, root);
  EXPECT_TRUE(test::has(report(), "&lt;b&gt;&quot;1&quot; &amp;"));
}

TEST_F(ReportFolder_behaviour, a_folder_that_is_neither_case_nor_study_is_refused) {
  EXPECT_THROW(write_report(root), InputError);
}

}  // namespace
}  // namespace asperity

#include "app/study.h"

#include <map>
#include <set>

#include "app/case_file.h"
#include "core/error.h"
#include "core/renamed_entries.h"
#include "core/topography_spec.h"
#include "tests/app/smooth_case.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::message_of;
using test::smooth_case;
using test::TemporaryFolder;

#define EXPECT_CONTAINS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

Study study_of(const std::string& study_section, const std::string& base = smooth_case()) {
  const TemporaryFolder folder;
  return read_study(folder.write("study.prm", base + study_section));
}

std::string study_refusal(const std::string& study_section) {
  return message_of<InputError>([&] { study_of(study_section); });
}

std::string value_of(const StudyCase& cell, const std::string& path) {
  for (const auto& setting : cell.settings)
    if (setting.path() == path) return setting.value;
  return "";
}

}  // namespace

TEST(Study_behaviour, is_every_combination_of_the_varied_values) {
  const Study study = study_of(
      "subsection Study\n subsection Vary\n"
      "  set Experiment/Normal load = 300 uN, 1 mN, 2 mN\n"
      "  set Substrate/Topography = flat: smooth, rough: generated(rms=1.5 nm, rolloff=200 nm, seed=3)\n"
      " end\nend\n");
  ASSERT_EQ(study.axes.size(), 2u);
  EXPECT_EQ(study.axes[0].name, "Normal load");
  EXPECT_EQ(study.axes[1].labels, (std::vector<std::string>{"flat", "rough"}));
  ASSERT_EQ(study.cases.size(), 6u);
  std::set<std::string> names;
  for (const auto& cell : study.cases) names.insert(cell.name);
  EXPECT_EQ(names.size(), 6u);
  EXPECT_EQ(study.cases[3].name, "1_mN-rough");
  EXPECT_EQ(value_of(study.cases[3], "Experiment/Normal load"), "1 mN");
  EXPECT_EQ(value_of(study.cases[3], "Substrate/Topography"),
            "generated(rms=1.5 nm, rolloff=200 nm, seed=3)");
}

TEST(Study_behaviour, realisations_differ_by_the_seeds_of_generated_surfaces_only) {
  const Study study = study_of(
      "subsection Study\n set Realisations = 3\n subsection Vary\n"
      "  set Substrate/Topography = flat: smooth, rough: generated(rms=1.5 nm, rolloff=200 nm, seed=3)\n"
      " end\nend\n");
  // The smooth case has one realisation: there is nothing to draw.
  ASSERT_EQ(study.cases.size(), 4u);
  std::set<std::uint64_t> seeds;
  for (const auto& cell : study.cases) {
    const std::string topography = value_of(cell, "Substrate/Topography");
    if (topography == "smooth") continue;
    const auto generator = parse_generator(topography);
    EXPECT_DOUBLE_EQ(generator.spectrum.rms, 1.5e-9);
    EXPECT_DOUBLE_EQ(generator.spectrum.rolloff, 200e-9);
    seeds.insert(generator.seed);
  }
  EXPECT_EQ(seeds.size(), 3u);
  EXPECT_EQ(seeds.count(3), 1u);
}

TEST(Study_behaviour, a_variant_may_have_realisations_of_its_own) {
  const std::string section =
      "subsection Study\n set Realisations = 2\n subsection Variants\n"
      "  set pressed = Substrate/Topography = generated(rms=1.5 nm, rolloff=200 nm, seed=3)\n"
      "  set slid = Substrate/Topography = generated(rms=1.5 nm, rolloff=200 nm, seed=3); "
      "Experiment/Type = sliding; Experiment/Distance = 100 nm; Interface/Friction coefficient = 0.2\n"
      " end\n subsection Realisations of variants\n  set ";
  const Study study = study_of(section + "pressed = 4\n end\nend\n");
  std::map<std::string, std::set<std::uint64_t>> seeds;
  for (const auto& cell : study.cases) {
    seeds[cell.labels.front()].insert(parse_generator(value_of(cell, "Substrate/Topography")).seed);
    EXPECT_EQ(cell.name, cell.labels.front() + "-r" + std::to_string(cell.realisation));
  }
  EXPECT_EQ(study.cases.size(), 6u);
  EXPECT_EQ(seeds["pressed"].size(), 4u);
  EXPECT_EQ(seeds["slid"].size(), 2u);
  EXPECT_CONTAINS(study_refusal(section + "presed = 4\n end\nend\n"),
                  "there is no variant 'presed'; did you mean 'pressed'?");
}

TEST(Study_behaviour, variants_set_several_entries_together) {
  const Study study = study_of(
      "subsection Study\n set Name of variants = Material\n subsection Variants\n"
      "  set elastic =\n"
      "  set yielding = Particle/Yield stress=3 GPa; Substrate/Yield stress=4 GPa\n"
      " end\nend\n");
  ASSERT_EQ(study.cases.size(), 2u);
  EXPECT_EQ(study.axes[0].name, "Material");
  EXPECT_EQ(value_of(study.cases[0], "Particle/Yield stress"), "inf");
  EXPECT_EQ(value_of(study.cases[1], "Particle/Yield stress"), "3 GPa");
  EXPECT_EQ(value_of(study.cases[1], "Substrate/Yield stress"), "4 GPa");
}

TEST(Study_behaviour, a_varied_value_may_bring_further_entries) {
  const Study study = study_of(
      "subsection Study\n subsection Vary\n"
      "  set Experiment/Type = sliding, turned: torsion; Experiment/Reverse = false; Experiment/Load "
      "steps=3\n"
      " end\nend\n");
  ASSERT_EQ(study.cases.size(), 2u);
  EXPECT_EQ(study.axes[0].labels, (std::vector<std::string>{"sliding", "turned"}));
  EXPECT_EQ(value_of(study.cases[0], "Experiment/Reverse"), "true");
  EXPECT_EQ(value_of(study.cases[1], "Experiment/Type"), "torsion");
  EXPECT_EQ(value_of(study.cases[1], "Experiment/Reverse"), "false");
  EXPECT_EQ(value_of(study.cases[1], "Experiment/Load steps"), "3");
}

TEST(Study_behaviour, an_entry_set_on_the_command_line_replaces_it_or_the_values_it_is_varied_by) {
  const TemporaryFolder folder;
  const auto file = folder.write(
      "study.prm",
      smooth_case() +
          "subsection Study\n subsection Vary\n  set Experiment/Normal load = 1 mN, 2 mN\n end\nend\n");
  const Study study =
      read_study(file, {"Experiment/Normal load=10 uN", "Mesh/Layers=2", "Study/Parallel cases=3"});
  ASSERT_EQ(study.cases.size(), 1u);
  EXPECT_EQ(study.cases[0].name, "10_uN");
  EXPECT_EQ(value_of(study.cases[0], "Experiment/Normal load"), "10 uN");
  EXPECT_EQ(value_of(study.cases[0], "Mesh/Layers"), "2");
  EXPECT_EQ(study.parallel_cases, 3);
}

TEST(Study_behaviour, reads_former_names_of_entries_where_it_varies_them_and_says_so) {
  const Study study = study_of(
      "subsection Study\n subsection Vary\n"
      "  set Experiment/Way back = 100 nm, 200 nm; Interface/Opening work = 0.1 J/m^2\n end\nend\n");
  ASSERT_EQ(study.cases.size(), 2u);
  EXPECT_EQ(study.axes[0].name, "Return distance");
  EXPECT_EQ(value_of(study.cases[1], "Experiment/Return distance"), "200 nm");
  EXPECT_EQ(value_of(study.cases[1], "Interface/Work of adhesion on separation"), "0.1 J/m^2");
  const auto hints = hints_of_former_names(study.cases[1].settings);
  ASSERT_EQ(hints.size(), 2u);
  EXPECT_CONTAINS(hints[0] + hints[1], "'Way back' is now called 'Return distance'");
  EXPECT_CONTAINS(hints[0] + hints[1], "'Opening work' is now called 'Work of adhesion on separation'");
  EXPECT_CONTAINS(study_refusal("subsection Study\n subsection Vary\n  set Experiment/Way back = 100 nm\n"
                                "  set Experiment/Return distance = 200 nm\n end\nend\n"),
                  "former name");
}

TEST(Study_behaviour, takes_a_base_case_from_another_file_and_overrides_it) {
  const TemporaryFolder folder;
  folder.write("cases/scan.gsf", "x");
  folder.write("cases/base.prm", smooth_case() + "subsection Mesh\n set Layers = 6\nend\n");
  const Study study = read_study(
      folder.write("study.prm",
                   "subsection Study\n set Base case = cases/base.prm\n"
                   " subsection Vary\n set Substrate/Topography = smooth, cases/scan.gsf\n end\nend\n"
                   "subsection Experiment\n set Normal load = 2 mN\nend\n"));
  ASSERT_EQ(study.cases.size(), 2u);
  EXPECT_EQ(value_of(study.cases[0], "Mesh/Layers"), "6");
  EXPECT_EQ(value_of(study.cases[0], "Experiment/Normal load"), "2 mN");
  EXPECT_EQ(value_of(study.cases[1], "Substrate/Topography"), (folder.path / "cases/scan.gsf").string());
}

TEST(Study_behaviour, what_it_cannot_mean_is_refused_with_its_line) {
  EXPECT_CONTAINS(study_refusal("subsection Study\n set Realisation = 3\nend\n"), "study.prm:14:");
  EXPECT_CONTAINS(study_refusal("subsection Study\n set Realisation = 3\nend\n"),
                  "did you mean 'Realisations'?");
  EXPECT_CONTAINS(study_refusal("subsection Study\n set Realisations = 0\nend\n"), "whole number, 1 or more");
  EXPECT_CONTAINS(
      study_refusal("subsection Study\n subsection Vary\n set Experiment/Normal laod = 1 mN\n end\nend\n"),
      "did you mean 'Normal load'?");
  EXPECT_CONTAINS(
      study_refusal(
          "subsection Study\n subsection Vary\n set Experiment/Normal load = 1 mN, 1 mm\n end\nend\n"),
      "study.prm:15:");
  EXPECT_CONTAINS(
      study_refusal(
          "subsection Study\n subsection Vary\n set Experiment/Normal load = 1 mN, , 2 mN\n end\nend\n"),
      "remove the comma");
  EXPECT_CONTAINS(
      study_refusal(
          "subsection Study\n subsection Vary\n set Experiment/Normal load = 1 mN, 1 mN\n end\nend\n"),
      "write a label");
  EXPECT_CONTAINS(
      study_refusal(
          "subsection Study\n subsection Vary\n set Experiment/Normal load = 1 mN; sideways\n end\nend\n"),
      "lacks '='");
  EXPECT_CONTAINS(study_refusal("subsection Study\n subsection Varied\n set a = b\n end\nend\n"),
                  "Vary, Variants and Realisations of variants");
  EXPECT_CONTAINS(study_refusal("subsection Study\n set Base case = none.prm\nend\n"),
                  "there is no base case");
}

}  // namespace asperity

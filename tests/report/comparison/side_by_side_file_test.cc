// Finite elements, laws, engine and measurement side by side, in numbers, words and files.
#include <gtest/gtest.h>

#include <algorithm>

#include "paper/published_column.h"
#include "report/comparison/comparison_file.h"
#include "report/sentences/verdict_words.h"
#include "tests/dem_compare/compare/solved_folders.h"
#include "tests/engines/engine_support.h"

namespace asperity::report {
namespace {

using test::paper_run;
using test::SolvedFolder;
using test::TemporaryFolder;
using test::write_solved;

const std::string silicon = "parameters_silicon.json";

struct Compared {
  TemporaryFolder folder;
  SideBySide result;
};

void compare(Compared& compared, const std::vector<SolvedFolder>& cases,
             const std::vector<std::string>& parameters, const std::string& engine = "") {
  std::vector<std::filesystem::path> folders;
  for (const auto& solved : cases)
    folders.push_back(write_solved(compared.folder.path / ("case" + std::to_string(folders.size())), solved));
  const CaseCollection collection = collect_cases(folders);
  const Comparison with_hertz = compare_with_hertz(collection, 0.05);
  SideBySideInput input{collection, with_hertz};
  for (const auto& file : parameters) input.parameters.push_back(read_contact_parameters(paper_run(file)));
  EngineColumn column(engine, compared.folder.path / "engine");
  compared.result =
      compare_side_by_side(input, PublishedColumn(read_published(paper_run("published"))), column, 0.05);
}

const ComparisonRow* row_of(const SideBySide& result, Quantity quantity, double load) {
  for (const auto& row : result.rows)
    if (row.quantity == quantity && std::abs(row.load / load - 1) < 1e-6) return &row;
  return nullptr;
}

std::string verdict_of(const SideBySide& result, Quantity quantity, const std::string& law) {
  for (const auto& verdict : result.verdicts)
    if (verdict.quantity == quantity && verdict.law.find(law) != std::string::npos &&
        verdict.reference == "finite elements")
      return verdict_text(verdict, result.tolerance);
  return "";
}

bool says(const SideBySide& result, const std::string& part) {
  return std::any_of(result.remarks.begin(), result.remarks.end(),
                     [&](const auto& text) { return text.find(part) != std::string::npos; });
}

TEST(SideBySide_other_code, the_papers_case_has_all_four_columns) {
  ASPERITY_ENGINE_OR_SKIP(Lammps());
  Compared compared;
  compare(compared, {SolvedFolder{}}, {silicon}, "lammps");
  for (const Quantity quantity : {Quantity::lateral_stiffness, Quantity::sliding_friction}) {
    const ComparisonRow* row = row_of(compared.result, quantity, 1e-4);
    ASSERT_TRUE(row);
    EXPECT_TRUE(row->finite_elements.known() && row->reduced_law.known() && row->engine.known() &&
                row->published.known())
        << display_of(quantity).words;
    EXPECT_NEAR(engine_over_law(*row), 1, 0.01);
  }
  // Rolling has not been solved by finite elements: the other three stand, and the dash has its reason.
  const ComparisonRow* rolling = row_of(compared.result, Quantity::rolling_friction, 3e-3);
  ASSERT_TRUE(rolling);
  EXPECT_TRUE(rolling->reduced_law.known() && rolling->engine.known() && rolling->published.known());
  EXPECT_NE(rolling->finite_elements.reason.find("not solved by finite elements: no case of rolling"),
            std::string::npos);
  EXPECT_EQ(std::count_if(compared.result.rows.begin(), compared.result.rows.end(),
                          [](const auto& row) {
                            return row.mode() == Motion::rail && row.engine.known() && row.published.known();
                          }),
            18);  // three rails at three loads each, with offsets and without
  const auto good_without_offset = std::find_if(
      compared.result.verdicts.begin(), compared.result.verdicts.end(), [](const LawVerdict& verdict) {
        return verdict.law == "Coulomb without offset" && verdict.reference == "measurement";
      });
  ASSERT_NE(good_without_offset, compared.result.verdicts.end());
  // 1/(1 + 12 uN/f) is 5 % short at 228 uN, beyond the loads of sliding; at the largest of them the
  // measurement's error leaves it open.
  EXPECT_EQ(good_words(*good_without_offset).rfind("at no load for which it is known", 0), 0u)
      << good_words(*good_without_offset);
  for (const Motion mode : {Motion::sliding, Motion::rolling, Motion::torsion, Motion::rail})
    EXPECT_TRUE(std::any_of(compared.result.verdicts.begin(), compared.result.verdicts.end(),
                            [&](const LawVerdict& verdict) {
                              return display_of(verdict.quantity).mode == mode &&
                                     verdict.reference == "measurement" && !verdict.is_own_fit;
                            }))
        << name_of(mode);
  const std::string markdown = side_by_side_markdown(compared.result);
  EXPECT_NE(markdown.find("LAMMPS ("), std::string::npos);
  EXPECT_EQ(markdown.find("nan"), std::string::npos);
}

TEST(SideBySide_analytic, the_no_slip_law_overstates_partial_slip_by_a_fifth) {
  Compared compared;
  compare(compared, {SolvedFolder{}}, {});
  EXPECT_EQ(verdict_of(compared.result, Quantity::lateral_stiffness_to_sliding, "Mindlin without slip"),
            "Mindlin without slip overstates the lateral stiffness up to sliding of the finite elements by "
            "20 ± 4 % at 100 uN.");
  EXPECT_EQ(verdict_of(compared.result, Quantity::lateral_stiffness_to_sliding, "Deresiewicz"),
            "Mindlin-Deresiewicz with equal work may or may not give the lateral stiffness up to sliding of "
            "the finite elements within 5 % "
            "at 100 uN (too little by 0.0 ± 3.0 %).");
}

TEST(SideBySide_behaviour, cases_at_several_loads_make_one_verdict) {
  SolvedFolder low, high;
  low.roughness = high.roughness = "smooth";
  low.stiffness = 1 / 1.12;
  high.load = 4e-4;
  Compared compared;
  compare(compared, {low, high}, {});
  // 12 % at 100 uN, none at 400 uN, each known to 3 %.
  EXPECT_EQ(verdict_of(compared.result, Quantity::lateral_stiffness, "Mindlin"),
            "Mindlin without slip overstates the lateral stiffness from rest of the finite elements by 12 ± "
            "3 % at 100 uN; "
            "whether within 5 % is not known at 400 uN (too much by 0.0 ± 3.0 %).");
  EXPECT_NE(
      side_by_side_markdown(compared.result).find("at no load for which it is known (100 uN to 400 uN)"),
      std::string::npos);
}

TEST(SideBySide_behaviour, a_contact_at_several_loads_goes_by_what_its_labels_have_in_common) {
  SolvedFolder low, high;
  low.title = "sliding, 1.5 nm";
  high.title = "sliding, 1.5 nm 400 uN";
  high.load = 4e-4;
  low.roughness = high.roughness = "smooth";
  Compared compared;
  compare(compared, {low, high}, {});
  for (const double load : {1e-4, 4e-4})
    EXPECT_EQ(row_of(compared.result, Quantity::lateral_stiffness, load)->contact, "sliding, 1.5 nm");
}

TEST(SideBySide_analytic,
     the_papers_torsion_stiffness_is_a_thousand_times_that_of_finite_elements_without_slip) {
  SolvedFolder torsion;
  torsion.experiment = "torsion";
  Compared compared;
  compare(compared, {torsion}, {silicon});
  EXPECT_NE(
      verdict_of(compared.result, Quantity::torsion_stiffness, "8 G* a r^2").find("by a factor of 1141 ± 34"),
      std::string::npos)
      << verdict_of(compared.result, Quantity::torsion_stiffness, "8 G* a r^2");
  EXPECT_NE(verdict_of(compared.result, Quantity::torsion_stiffness, "Reissner").find("within 5 % at 100 uN"),
            std::string::npos);
}

TEST(SideBySide_behaviour, a_contact_of_other_roughness_does_not_borrow_the_records_numbers) {
  SolvedFolder rough;
  rough.roughness = "generated(rms=1.5 nm, seed=1)";
  rough.friction = 0.4;
  Compared compared;
  compare(compared, {rough}, {silicon});
  const auto& rows = compared.result.rows;
  const auto own = std::find_if(rows.begin(), rows.end(), [](const auto& row) {
    return row.quantity == Quantity::sliding_friction && row.finite_elements.known();
  });
  ASSERT_NE(own, rows.end());
  EXPECT_DOUBLE_EQ(own->reduced_law.value, 0.4);
  EXPECT_NEAR(own->published.value, 0.53 * (1 + 4.45 / 100), 1e-9);  // Table 2, etched 1600 W
  EXPECT_TRUE(says(compared.result, "None of the solved cases is the contact of"));
}

TEST(SideBySide_other_code, each_roughness_has_the_numbers_given_for_it) {
  SolvedFolder smoother, rougher;
  rougher.roughness = "generated(rms=1.5 nm, seed=1)";
  rougher.friction = 0.53;
  Compared compared;
  compare(compared, {smoother, rougher}, {silicon, "parameters_silicon_1600W.json"});
  int sliding = 0, rolling = 0;
  for (const auto& row : compared.result.rows) {
    if (row.mode() == Motion::rail) {
      EXPECT_NE(row.contact.find("untreated"), std::string::npos);
    }
    if (std::abs(row.load / 1e-4 - 1) > 1e-6) continue;
    const bool is_smoother = row.rms < 1e-9;
    // Table 2: mu (1 + h/f) of the untreated surface, and of that etched at 1600 W.
    if (row.reduced_law.source == "Coulomb with offset") {
      ++sliding;
      EXPECT_NEAR(row.reduced_law.value, is_smoother ? 0.23 * 1.12 : 0.53 * 1.0445, 1e-9);
      EXPECT_NEAR(row.published.value, row.reduced_law.value, 1e-9);
      EXPECT_NEAR(row.finite_elements.value, is_smoother ? 0.23 : 0.53, 1e-6);
    } else if (row.reduced_law.source == "slider with offset") {
      ++rolling;
      EXPECT_NEAR(row.reduced_law.value, is_smoother ? 7.9e-4 * 6.714 : 4.6e-4 * 14.98, 1e-9);
      EXPECT_NEAR(row.published.value, row.reduced_law.value, 1e-9);
    }
  }
  EXPECT_EQ(sliding, 2);
  EXPECT_EQ(rolling, 2);
  EXPECT_FALSE(says(compared.result, "None of the solved cases"));
}

TEST(SideBySide_behaviour, without_parameters_says_what_to_add) {
  Compared compared;
  compare(compared, {SolvedFolder{}}, {});
  EXPECT_TRUE(says(compared.result, "add --parameters FILE"));
  EXPECT_TRUE(says(compared.result, "without finite elements: rolling, torsion"));
}

TEST(SideBySide_behaviour, json_and_csv_have_values_reasons_ratios_and_verdicts) {
  Compared compared;
  compare(compared, {SolvedFolder{}}, {silicon});
  const auto json = side_by_side_json(compared.result);
  ASSERT_EQ(json["rows"].size(), compared.result.rows.size());
  for (const auto& row : json["rows"])
    for (const char* column : {"finite_elements", "reduced_law", "engine", "published"})
      EXPECT_TRUE(row[column]["value"].is_number() || !row[column]["reason"].get<std::string>().empty())
          << row.dump();
  EXPECT_FALSE(json["verdicts"].empty());
  const std::string csv = side_by_side_csv(compared.result);
  EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')),
            compared.result.rows.size() + 1);
  // The same number of cells in every line; texts in quotation marks have commas of their own.
  std::size_t cells = 0, line_cells = 0;
  bool quoted = false;
  for (const char c : csv) {
    if (c == '"') quoted = !quoted;
    if (c == ',' && !quoted) ++line_cells;
    if (c != '\n') continue;
    if (cells == 0) cells = line_cells;
    EXPECT_EQ(line_cells, cells);
    line_cells = 0;
  }
}

}  // namespace
}  // namespace asperity::report

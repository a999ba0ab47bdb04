#include "report/comparison/comparison_page.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

ComparisonRow friction_at(double load, double computed, double law) {
  ComparisonRow row;
  row.contact = "glass on silicon";
  row.quantity = Quantity::sliding_friction;
  row.load = load;
  row.finite_elements.value = computed;
  row.finite_elements.sd = 0.01;
  row.reduced_law = {law, NAN, "Coulomb", ""};
  row.engine = absent("none was asked for");
  row.published = absent("not measured <here>");
  return row;
}

TEST(ComparisonPage_behaviour, draws_each_source_that_has_values_and_says_why_others_have_none) {
  SideBySide comparison;
  comparison.tolerance = 0.05;
  comparison.rows = {friction_at(100e-6, 0.30, 0.23), friction_at(1e-3, 0.29, 0.23)};
  const auto chart = report::quantity_chart({&comparison.rows[0], &comparison.rows[1]});
  ASSERT_EQ(chart.series.size(), 2u);
  EXPECT_EQ(chart.series[0].label, "law: Coulomb");
  EXPECT_NEAR(chart.series[1].x[1], 1000, 1e-9);
  EXPECT_NEAR(chart.series[1].y[0], 0.30, 1e-12);
  EXPECT_NEAR(chart.series[1].error[0], 0.01, 1e-12);
  comparison.rows.push_back(friction_at(100e-6, 0.17, 0.23));  // 35 +- 8 %
  comparison.rows.back().contact = "glass on quartz";
  comparison.verdicts = verdicts(comparison.rows, comparison.tolerance);
  const std::string page = report::comparison_page(comparison);
  // Each contact has its own verdicts.
  const auto quartz = page.find("<h2>glass on quartz</h2>");
  ASSERT_NE(quartz, std::string::npos);
  EXPECT_LT(page.find("Coulomb understates"), quartz);
  EXPECT_NE(page.find("Coulomb overstates", quartz), std::string::npos);
  for (const char* part : {"<svg", "0.3 ± 0.01", "glass on silicon", "none was asked for",
                           "not measured &lt;here&gt;", "within 5 %"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  EXPECT_EQ(page.find("http://"), std::string::npos);
}

TEST(ComparisonPage_behaviour, gives_each_law_a_line_of_its_own) {
  std::vector<ComparisonRow> rows;
  for (const double load : {1e-4, 1e-3})
    for (const auto& [law, value] : {std::pair{"Coulomb", 0.23}, std::pair{"Coulomb without offset", 0.2}}) {
      rows.push_back(friction_at(load, 0.3, value));
      rows.back().reduced_law.source = law;
    }
  const auto chart = report::quantity_chart({&rows[0], &rows[1], &rows[2], &rows[3]});
  ASSERT_EQ(chart.series.size(), 3u);
  EXPECT_EQ(chart.series[1].label, "law: Coulomb without offset");
  EXPECT_EQ(chart.series[2].label, "finite elements");
  EXPECT_EQ(chart.series[1].y, (std::vector<double>{0.2, 0.2}));
  EXPECT_NE(chart.series[0].colour, chart.series[1].colour);
  SideBySide comparison;
  comparison.rows = rows;
  EXPECT_NE(report::comparison_page(comparison).find("<td>Coulomb without offset</td>"), std::string::npos);
}

}  // namespace
}  // namespace asperity

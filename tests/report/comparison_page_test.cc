#include "report/comparison_page.h"

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

TEST(ComparisonPage, draws_each_source_that_has_values_and_says_why_others_have_none) {
  SideBySide comparison;
  comparison.tolerance = 0.05;
  comparison.rows = {friction_at(100e-6, 0.30, 0.23), friction_at(1e-3, 0.29, 0.23)};
  const auto chart = report::quantity_chart({&comparison.rows[0], &comparison.rows[1]});
  ASSERT_EQ(chart.series.size(), 2u);
  EXPECT_EQ(chart.series[0].label, "law: Coulomb");
  EXPECT_NEAR(chart.series[1].x[1], 1000, 1e-9);
  EXPECT_NEAR(chart.series[1].y[0], 0.30, 1e-12);
  EXPECT_NEAR(chart.series[1].error[0], 0.01, 1e-12);
  const std::string page = report::comparison_page(comparison);
  for (const char* part : {"<svg", "0.3 ± 0.01", "glass on silicon", "none was asked for", "not measured &lt;here&gt;", "within 5 %"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  EXPECT_EQ(page.find("http://"), std::string::npos);
}

}  // namespace
}  // namespace asperity

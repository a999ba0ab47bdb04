// How a law says its numbers.
#include "dem_compare/derive/law_report.h"

#include <gtest/gtest.h>

#include <limits>

namespace asperity {
namespace {

TEST(LawReport_behaviour, numbers_have_their_error_and_their_unit) {
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(with_error(0.25, 0.012, ""), "0.25 +- 0.012");
  EXPECT_EQ(with_error(0.25, unknown, ""), "0.25");
  EXPECT_EQ(with_error(0.25, 0.012, "rad"), "0.25 +- 0.012 rad");
  EXPECT_EQ(with_error(2.5e5, 1e4, "N/m"), "250 +- 10 kN/m");
  EXPECT_EQ(with_error(3e-11, 1e-12, "N m/rad"), "30 +- 1 pN m/rad");
}

}  // namespace
}  // namespace asperity

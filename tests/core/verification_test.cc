// The record of what is asserted and measured.
#include "tests/support/verification.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "core/csv.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

TEST(Verification_behaviour, asserts_what_it_writes_down) {
  const test::TemporaryFolder folder;
  const char* before = std::getenv("ASPERITY_VERIFICATION");
  const std::string kept = before ? before : "";
  ::setenv("ASPERITY_VERIFICATION", folder.path.c_str(), 1);
  EXPECT_TRUE((test::Verified{"A topic", "a force, \"fine\" mesh", "a formula"}.within(1.019, 1, 0.02)));
  EXPECT_FALSE((test::Verified{"A topic", "a force", "a formula"}.within(0.979, 1, 0.02)));
  EXPECT_FALSE((test::Verified{"A topic", "not a number", "a formula"}.within(NAN, 1, 0.02)));
  EXPECT_TRUE((test::Verified{"A topic", "a gap", "none"}.below(-2e-9, 3e-9, "m")));
  EXPECT_FALSE((test::Verified{"A topic", "a gap", "none"}.below(-4e-9, 3e-9, "m")));
  EXPECT_TRUE((test::Verified{"A topic", "a share", "none"}.between(0.7, 0.5, 0.9)));
  EXPECT_FALSE((test::Verified{"A topic", "a share", "none"}.between(0.4, 0.5, 0.9)));
  EXPECT_TRUE((test::Verified{"A topic", "contacts", "none"}.above(28, 28, "of 30")));
  EXPECT_FALSE((test::Verified{"A topic", "contacts", "none"}.above(NAN, 28)));
  before ? ::setenv("ASPERITY_VERIFICATION", kept.c_str(), 1) : ::unsetenv("ASPERITY_VERIFICATION");
  const CsvTable table = read_csv(folder.path / "Verification_behaviour.asserts_what_it_writes_down.csv");
  ASSERT_EQ(table.rows.size(), 9u);
  EXPECT_EQ(table.rows[0][table.column("asked")], "2 %");
  EXPECT_EQ(table.rows[0][table.column("measured")], "+1.9 %");
  EXPECT_EQ(table.rows[0][table.column("met")], "yes");
  EXPECT_EQ(table.rows[1][table.column("met")], "no");
  EXPECT_EQ(table.rows[2][table.column("met")], "no");
  EXPECT_EQ(table.rows[3][table.column("measured")], "-2e-09 m");
  EXPECT_EQ(table.rows[4][table.column("test")], "Verification_behaviour.asserts_what_it_writes_down");
  EXPECT_EQ(table.rows[5][table.column("asked")], "0.5 to 0.9");
  EXPECT_EQ(table.rows[7][table.column("asked")], "at least 28 of 30");
}

TEST(Verification_behaviour,
     the_largest_error_keeps_its_sign_and_is_none_without_any_and_with_one_that_is_none) {
  test::Largest errors;
  EXPECT_TRUE(std::isnan(errors));
  for (const double error : {0.1, -0.3, 0.2}) errors.count(error);
  EXPECT_EQ(errors, -0.3);
  errors.count(NAN);
  errors.count(1.0);
  EXPECT_TRUE(std::isnan(errors));
}

}  // namespace
}  // namespace asperity

// What a test asserts and what it measured, as one row of a table: tests/verification/table makes docs/verification_measured.md from
// the rows, so that what is asked there is what is asserted here.
#pragma once

#include <gtest/gtest.h>

#include <string>

namespace asperity::test {

/// A quantity that is verified. Use: EXPECT_TRUE(Verified{"Torsion", "stiffness, a/h 8", "16/3 G a^3"}.within(measured, expected, 0.03)).
struct Verified {
  std::string topic;     ///< heading of the table
  std::string quantity;  ///< what is measured, on which mesh
  std::string source;    ///< of the expected value: formula, author, code

  /// |measured / expected - 1| is at most `asked`; the row says both in per cent.
  testing::AssertionResult within(double measured, double expected, double asked) const;
  /// |measured| is at most `asked`; `unit` is written behind both.
  testing::AssertionResult below(double measured, double asked, const std::string& unit = "") const;

 private:
  testing::AssertionResult judged(bool met, const std::string& measured, const std::string& asked) const;
};

}  // namespace asperity::test

// What a test asserts and what it measured, as one row of a table: tests/verification/table makes
// docs/verification.md from the rows, so that what is asked there is what is asserted here.
#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace asperity::test {

/// A quantity that is verified. Use: EXPECT_TRUE(Verified{"Torsion", "stiffness, a/h 8", "16/3 G
/// a^3"}.within(measured, expected, 0.03)).
struct Verified {
  std::string topic;     ///< heading of the table: one of those in tests/verification/notes.md
  std::string quantity;  ///< what is measured, on which mesh; not how much it was
  std::string source;    ///< of the expected value: formula, author, code

  /// |measured / expected - 1| is at most `asked`; the row says both in per cent.
  testing::AssertionResult within(double measured, double expected, double asked) const;
  /// |measured| is at most `asked`; `unit` is written behind both.
  testing::AssertionResult below(double measured, double asked, const std::string& unit = "") const;
  /// measured is `low` at least and `high` at most.
  testing::AssertionResult between(double measured, double low, double high,
                                   const std::string& unit = "") const;
  /// measured is `low` at least.
  testing::AssertionResult above(double measured, double low, const std::string& unit = "") const;

 private:
  testing::AssertionResult judged(bool met, const std::string& measured, const std::string& asked) const;
};

/// Of errors that are counted, the largest one, with its sign: a row for what a test asserts in a loop. Not a
/// number before any is counted, and from one on that is none.
class Largest {
 public:
  void count(double error);
  operator double() const { return error_; }

 private:
  double error_ = std::numeric_limits<double>::quiet_NaN();
  bool is_counted_ = false;
};

}  // namespace asperity::test

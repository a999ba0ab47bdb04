#include "tests/support/verification.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace asperity::test {
namespace {

std::string text(const char* format, double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

std::string quoted(const std::string& cell) {
  std::string result = "\"";
  for (const char c : cell) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

/// Suite and test without what parameters add before and behind.
std::string name_of_test() {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  if (!info) return "none";
  const std::string suite = info->test_suite_name(), name = info->name();
  return suite.substr(suite.find('/') + 1) + "." + name;
}

/// ", 2 ranks" where several ranks of MPI run the test, which one alone runs too.
std::string ranks() {
  const char* count = std::getenv("OMPI_COMM_WORLD_SIZE");
  return count && std::string(count) != "1" ? ", " + std::string(count) + " ranks" : "";
}

/// Adds a line to this test's file in the folder that ASPERITY_VERIFICATION names; the first of a run begins
/// the file anew. Of several ranks the first writes.
void write_row(const std::string& test, const std::string& row) {
  const char *folder = std::getenv("ASPERITY_VERIFICATION"), *rank = std::getenv("OMPI_COMM_WORLD_RANK");
  if (!folder || (rank && std::string(rank) != "0")) return;
  static std::string last;
  std::string file = test + ranks();
  for (char& c : file)
    if (c == '/' || c == ',' || c == ' ') c = '_';
  std::filesystem::create_directories(folder);
  std::ofstream out(std::filesystem::path(folder) / (file + ".csv"),
                    test == last ? std::ios::app : std::ios::trunc);
  if (test != last) out << "topic,quantity,source,asked,measured,met,test\n";
  last = test;
  out << row << "\n";
}

}  // namespace

testing::AssertionResult Verified::within(double measured, double expected, double asked) const {
  const double error = measured / expected - 1;
  return judged(std::abs(error) <= asked, text("%+.3g %%", 100 * error), text("%.3g %%", 100 * asked));
}

testing::AssertionResult Verified::below(double measured, double asked, const std::string& unit) const {
  const std::string behind = unit.empty() ? "" : " " + unit;
  return judged(std::abs(measured) <= asked, text("%.2g", measured) + behind, text("%.2g", asked) + behind);
}

testing::AssertionResult Verified::between(double measured, double low, double high,
                                           const std::string& unit) const {
  const std::string behind = unit.empty() ? "" : " " + unit;
  return judged(low <= measured && measured <= high, text("%.3g", measured) + behind,
                text("%.3g to ", low) + text("%.3g", high) + behind);
}

testing::AssertionResult Verified::above(double measured, double low, const std::string& unit) const {
  const std::string behind = unit.empty() ? "" : " " + unit;
  return judged(measured >= low, text("%.3g", measured) + behind, text("at least %.3g", low) + behind);
}

testing::AssertionResult Verified::judged(bool met, const std::string& measured,
                                          const std::string& asked) const {
  const std::string test = name_of_test(), what = quantity + ranks();
  std::string row;
  for (const auto& cell : {topic, what, source, asked, measured, std::string(met ? "yes" : "no"), test})
    row += (row.empty() ? "" : ",") + quoted(cell);
  write_row(test, row);
  std::printf("%s: %s (asked: %s)\n", what.c_str(), measured.c_str(), asked.c_str());
  return (met ? testing::AssertionSuccess() : testing::AssertionFailure())
         << topic << ", " << quantity << ": " << measured << " where " << asked << " is asked (" << source
         << ")";
}

void Largest::count(double error) {
  if (!is_counted_ || std::isnan(error) || std::abs(error) > std::abs(error_)) error_ = error;
  is_counted_ = true;
}

}  // namespace asperity::test

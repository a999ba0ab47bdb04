#include "core/csv.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

/// Reads a table of that text from a file of its own, for tests run side by side.
CsvTable read_text(const std::string& text) {
  const test::TemporaryFolder folder;
  return read_csv(folder.write("table.csv", text));
}

}  // namespace

TEST(Csv_behaviour, gives_back_what_was_written) {
  const auto table = read_text(format_csv({"load [N]", "approach [m]"}, {{1, 2}, {1e-9, 2.5e-9}}));
  EXPECT_EQ(table.numbers("load [N]"), (std::vector<double>{1, 2}));
  EXPECT_EQ(table.numbers("approach [m]"), (std::vector<double>{1e-9, 2.5e-9}));
}

TEST(Csv_behaviour, keeps_commas_in_quotes_and_reads_empty_cells_as_missing) {
  const auto table = read_text("# comment\na,b\n\"x,y\",\n");
  EXPECT_EQ(table.rows[0][0], "x,y");
  EXPECT_TRUE(std::isnan(table.numbers("b")[0]));
}

TEST(Csv_behaviour, names_file_and_line_of_a_short_row) {
  try {
    read_text("a,b\n1,2\n3\n");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("csv:3"), std::string::npos) << error.what();
  }
}

}  // namespace asperity

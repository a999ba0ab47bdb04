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

TEST(Csv_behaviour, is_written_in_nine_digits_row_by_row) {
  EXPECT_EQ(format_csv({"a", "b"}, {{1, -2.5}, {1.0 / 3, 1e-9}}), "a,b\n1,0.333333333\n-2.5,1e-09\n");
  EXPECT_EQ(format_csv({"a"}, {}), "a\n");
}

TEST(Csv_behaviour, line_ends_of_windows_and_lines_without_content_are_no_cells) {
  const auto table = read_text("a,b\r\n\r\n1,2\r\n\n3,4");
  EXPECT_EQ(table.names, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(table.numbers("a"), (std::vector<double>{1, 3}));
  EXPECT_EQ(table.numbers("b"), (std::vector<double>{2, 4}));
  EXPECT_TRUE(table.has("b"));
  EXPECT_FALSE(table.has("c"));
}

TEST(Csv_behaviour, says_which_row_and_column_holds_no_number_and_which_columns_there_are) {
  const auto message = [](const std::string& text, const std::string& column) {
    return test::message_of<InputError>([&] { read_text(text).numbers(column); });
  };
  EXPECT_EQ(message("a,b\n1,2\n3,4x\n", "b"), "row 2 of column 'b' holds '4x', not a number");
  EXPECT_EQ(message("a,b\n1,2\n", "c"), "no column 'c' among: a, b");
  EXPECT_NE(message("a,b\n1,2,3\n", "a").find("3 cells where the header has 2"), std::string::npos);
  EXPECT_NE(message("# only a remark\n", "a").find("the table is empty"), std::string::npos);
}

}  // namespace asperity

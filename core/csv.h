// Comma-separated tables with one header row, as asperity writes them (history.csv, study.csv).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

/// Columns by name; '#' lines are comments, empty cells are NaN. Quoted cells may hold commas; text cells are
/// kept.
struct CsvTable {
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows;

  /// Index of a column; throws InputError listing the columns there are.
  std::size_t column(const std::string& name) const;
  bool has(const std::string& name) const;
  /// Numbers of a column; throws InputError naming row and text of a cell that is not a number.
  std::vector<double> numbers(const std::string& name) const;
};

/// Reads a table; throws InputError naming file and line.
CsvTable read_csv(const std::filesystem::path& path);

/// One row per entry of each column (all of equal length), numbers to 9 significant digits.
std::string format_csv(const std::vector<std::string>& names,
                       const std::vector<std::vector<double>>& columns);

/// A number to 9 significant digits, empty where it is not finite; a text in quotation marks, those within
/// doubled.
/// The number is written as it is, in the unit of its column.
std::string csv_cell(double value);
std::string csv_cell(const std::string& text);

}  // namespace asperity

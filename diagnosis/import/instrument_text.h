// The text of an instrument: UTF-8 or Latin-1, any line ends, tables between other lines, decimal commas.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

struct InstrumentText {
  std::string file;
  std::vector<std::string> lines;  ///< in UTF-8, without ends

  /// Index of the first line from `from` on that begins with `start`; none: empty.
  std::optional<std::size_t> line_with(const std::string& start, std::size_t from = 0) const;
  /// The number behind "key: 1.5 unit", "key = 1.5" or "key<tab>1.5", as it stands.
  std::optional<double> number_behind(const std::string& key) const;
};

/// Throws InputError for a file that cannot be read, is larger than 256 MB, or is not text.
InstrumentText read_instrument_text(const std::filesystem::path& file);

/// Columns of numbers under a header row.
struct InstrumentTable {
  std::vector<std::string> names;
  std::vector<std::string>
      units;  ///< by column, from a row under the names or brackets behind them; may be empty
  std::vector<std::vector<double>> columns;
  std::size_t first_line = 0;  ///< of the numbers, from 1

  std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
  /// By name, or by the beginning of one; throws InputError listing the columns.
  const std::vector<double>& column(const std::string& name, const std::string& file) const;
  std::optional<std::size_t> find(const std::string& name) const;
};

/// Splits at tabs, else at semicolons, else at commas.
std::vector<std::string> cells_of_line(const std::string& line);
/// Reads "1.5", "1,5" (decimal comma), "nan"; none if the whole text is not a number.
std::optional<double> number_in(std::string text);

/// Whether line `index` says units under the names of line `header`: as many cells at most, none of them a
/// number, and numbers under it.
bool is_row_of_units(const InstrumentText& text, std::size_t header, std::size_t index);

/// The table whose header stands in line `header` (index), a row of units under it or not, until a line that
/// is not numbers. Throws InputError naming a line whose cells are too few or hold text.
InstrumentTable table_under(const InstrumentText& text, std::size_t header);

/// "um" for "µm" or "micron", "uN" for "µN".
std::string instrument_unit(const std::string& unit);

}  // namespace asperity

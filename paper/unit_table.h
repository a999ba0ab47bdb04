// A table whose columns carry their unit, "rms [nm]", read in SI.
#pragma once

#include <filesystem>
#include <string>

#include "core/csv.h"
#include "core/error.h"
#include "core/quantity.h"
#include "dem_compare/numbers/uncertain.h"

namespace asperity {

/// Columns are asked for by their name without unit.
class UnitTable {
 public:
  explicit UnitTable(const std::filesystem::path& file) : file_(file), table_(read_csv(file)) {}

  /// Whether there is a column `name` or `name [unit]`.
  bool has(const std::string& name) const {
    for (const std::string& column : table_.names)
      if (column == name || column.rfind(name + " [", 0) == 0) return true;
    return false;
  }
  std::size_t rows() const { return table_.rows.size(); }
  std::string text(const std::string& name, std::size_t row) const {
    return table_.rows[row][table_.column(name)];
  }

  /// The column `name` or `name [unit]` [SI].
  /// Throws InputError naming column and unit.
  double number(const std::string& name, Dimension dimension, std::size_t row) const {
    for (const std::string& column : table_.names) {
      if (column == name) return table_.numbers(column)[row];
      if (column.rfind(name + " [", 0) != 0) continue;
      const std::string unit = column.substr(name.size() + 2, column.size() - name.size() - 3);
      return table_.numbers(column)[row] * unit_factor(unit, dimension);
    }
    throw InputError(file_.string() + ": there is no column '" + name + "'");
  }

  Uncertain uncertain(const std::string& name, Dimension dimension, std::size_t row) const {
    return {number(name, dimension, row), number(name + "_sd", dimension, row)};
  }

 private:
  std::filesystem::path file_;
  CsvTable table_;
};

}  // namespace asperity

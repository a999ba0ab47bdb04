#include "core/csv.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "core/error.h"
#include "core/printed.h"
#include "core/read_limits.h"
#include "core/text_file.h"

namespace asperity {
namespace {

std::vector<std::string> split_row(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      cells.emplace_back();
    else if (c != '\r')
      cells.back() += c;
  }
  return cells;
}

}  // namespace

bool CsvTable::has(const std::string& name) const {
  for (const auto& known : names)
    if (known == name) return true;
  return false;
}

std::size_t CsvTable::column(const std::string& name) const {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return i;
  std::string known;
  for (const auto& n : names) known += (known.empty() ? "" : ", ") + n;
  throw InputError("no column '" + name + "' among: " + known);
}

std::vector<double> CsvTable::numbers(const std::string& name) const {
  const std::size_t index = column(name);
  std::vector<double> values;
  values.reserve(rows.size());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const std::string& cell = rows[r][index];
    if (cell.empty()) {
      values.push_back(std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    char* end = nullptr;
    values.push_back(std::strtod(cell.c_str(), &end));
    if (end == cell.c_str() || *end != '\0')
      throw InputError("row " + std::to_string(r + 1) + " of column '" + name + "' holds '" + cell +
                       "', not a number");
  }
  return values;
}

CsvTable read_csv(const std::filesystem::path& path) {
  const std::string text = read_text_file(path);
  CsvTable table;
  table.rows.reserve(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')));
  std::string line;
  int number = 0;
  for (std::size_t from = 0; from < text.size(); from += line.size() + 1) {
    line = text.substr(from, text.find('\n', from) - from);
    ++number;
    if (line.size() > read_limits::longest_line)
      throw InputError(path.string() + ":" + std::to_string(number) + ": this line is longer than " +
                       std::to_string(read_limits::longest_line) +
                       " characters; this is no table of asperity");
    if (line.empty() || line[0] == '#' || line == "\r") continue;
    std::vector<std::string> cells = split_row(line);
    if (table.names.empty()) {
      table.names = std::move(cells);
      continue;
    }
    if (cells.size() != table.names.size())
      throw InputError(path.string() + ":" + std::to_string(number) + ": " + std::to_string(cells.size()) +
                       " cells where the header has " + std::to_string(table.names.size()));
    table.rows.push_back(std::move(cells));
  }
  if (table.names.empty()) throw InputError(path.string() + ": the table is empty; it needs a header row");
  return table;
}

std::string format_csv(const std::vector<std::string>& names,
                       const std::vector<std::vector<double>>& columns) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ",") + name;
  text += '\n';
  const std::size_t rows = columns.empty() ? 0 : columns.front().size();
  char buffer[32];
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      std::snprintf(buffer, sizeof buffer, "%s%.9g", c ? "," : "", columns[c][r]);
      text += buffer;
    }
    text += '\n';
  }
  return text;
}

std::string csv_cell(double value) { return std::isfinite(value) ? printed("%.9g", value) : ""; }

std::string csv_cell(const std::string& text) {
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? "\"\"" : std::string(1, c);
  return cell + "\"";
}

}  // namespace asperity

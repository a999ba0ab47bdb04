#include "diagnosis/import/instrument_text.h"

#include <algorithm>
#include <cstdlib>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/joined.h"
#include "core/read_limits.h"
#include "core/text_file.h"
#include "diagnosis/recording/cell_text.h"
#include "diagnosis/recording/file_size.h"

namespace asperity {

InstrumentText read_instrument_text(const std::filesystem::path& file) {
  check_file_size(file, "cut it into experiments");
  const std::string bytes = plain_text(read_file(file));
  if (bytes.find('\0') != std::string::npos)
    throw InputError(file.string() +
                     ": is binary, not text; export it as text from the instrument's program");
  InstrumentText text;
  text.file = file.string();
  text.lines.reserve(static_cast<std::size_t>(std::count(bytes.begin(), bytes.end(), '\n')) + 1);
  std::string line;
  for (const char c : bytes) {
    if (line.size() > read_limits::longest_line)
      throw InputError(text.file + ":" + std::to_string(text.lines.size() + 1) +
                       ": this line is longer than " + std::to_string(read_limits::longest_line) +
                       " characters; this is no table of an instrument");
    if (c == '\n') {
      text.lines.push_back(line);
      line.clear();
    } else {
      line += c;
    }
  }
  if (!line.empty()) text.lines.push_back(line);
  return text;
}

std::optional<std::size_t> InstrumentText::line_with(const std::string& start, std::size_t from) const {
  for (std::size_t i = from; i < lines.size(); ++i)
    if (lines[i].rfind(start, 0) == 0) return i;
  return std::nullopt;
}

std::optional<double> InstrumentText::number_behind(const std::string& key) const {
  const auto line = line_with(key);
  if (!line) return std::nullopt;
  std::string rest = cell_text(lines[*line].substr(key.size()));
  if (!rest.empty() && (rest[0] == ':' || rest[0] == '=')) rest = cell_text(rest.substr(1));
  return number_in(rest.substr(0, rest.find_first_of(" \t")));
}

std::vector<std::string> cells_of_line(const std::string& line) {
  const char separator = line.find('\t') != std::string::npos  ? '\t'
                         : line.find(';') != std::string::npos ? ';'
                                                               : ',';
  std::vector<std::string> cells;
  for (std::size_t from = 0;;) {
    const auto at = line.find(separator, from);
    cells.push_back(cell_text(line.substr(from, at == std::string::npos ? at : at - from)));
    if (at == std::string::npos) break;
    from = at + 1;
  }
  while (cells.size() > 1 && cells.back().empty()) cells.pop_back();
  return cells;
}

std::optional<double> number_in(std::string text) {
  // A comma that is not a separator of cells is one of decimals.
  std::replace(text.begin(), text.end(), ',', '.');
  if (text.empty()) return std::nullopt;
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return *end == '\0' ? std::optional<double>(value) : std::nullopt;
}

namespace {

/// "nm" of "Depth (nm)" or "Depth [nm]", and of "(nm)".
std::string bracketed(const std::string& name) {
  if (name.empty()) return "";
  const char close = name.back(), open = close == ')' ? '(' : close == ']' ? '[' : '\0';
  const auto at = open ? name.rfind(open) : std::string::npos;
  return at == std::string::npos ? "" : cell_text(name.substr(at + 1, name.size() - at - 2));
}

}  // namespace

bool is_row_of_units(const InstrumentText& text, std::size_t header, std::size_t index) {
  if (index + 1 >= text.lines.size()) return false;
  const auto names = cells_of_line(text.lines[header]), units = cells_of_line(text.lines[index]);
  const auto numbers = cells_of_line(text.lines[index + 1]);
  if (units.size() > names.size() || numbers.size() < names.size() || !number_in(numbers[0])) return false;
  return std::none_of(units.begin(), units.end(),
                      [](const auto& unit) { return number_in(unit).has_value(); }) &&
         std::any_of(units.begin(), units.end(), [](const auto& unit) { return !unit.empty(); });
}

InstrumentTable table_under(const InstrumentText& text, std::size_t header) {
  InstrumentTable table;
  table.names = cells_of_line(text.lines[header]);
  table.columns.resize(table.names.size());
  table.units.resize(table.names.size());
  for (std::size_t c = 0; c < table.names.size(); ++c) table.units[c] = bracketed(table.names[c]);
  std::size_t first = header + 1;
  if (is_row_of_units(text, header, first)) {
    const auto units = cells_of_line(text.lines[first++]);
    for (std::size_t c = 0; c < units.size(); ++c) {
      const std::string inner = bracketed(units[c]);
      if (!units[c].empty()) table.units[c] = inner.empty() ? units[c] : inner;
    }
  }
  table.first_line = first + 1;
  for (std::size_t i = first; i < text.lines.size(); ++i) {
    const auto cells = cells_of_line(text.lines[i]);
    if (cells.size() == 1 && cells[0].empty()) continue;  // some leave a line out between segments
    if (!number_in(cells[0])) {
      // A text line ends the table, unless it is one of its rows gone wrong.
      if (table.rows() > 0 && cells.size() == table.names.size() && cells.size() > 1 && number_in(cells[1]))
        throw InputError(text.file + ":" + std::to_string(i + 1) + ": '" + cells[0] + "' in column '" +
                         table.names[0] + "' is not a number");
      break;
    }
    if (cells.size() < table.names.size())
      throw InputError(text.file + ":" + std::to_string(i + 1) + ": " + std::to_string(cells.size()) +
                       " cells where the header has " + std::to_string(table.names.size()) +
                       "; the file may be cut short");
    for (std::size_t c = 0; c < table.names.size(); ++c) {
      const auto value = number_in(cells[c]);
      if (!value)
        throw InputError(text.file + ":" + std::to_string(i + 1) + ": '" + cells[c] + "' in column '" +
                         table.names[c] + "' is not a number");
      table.columns[c].push_back(*value);
    }
  }
  if (table.rows() == 0)
    throw InputError(text.file + ":" + std::to_string(header + 1) + ": no numbers follow this header");
  return table;
}

std::optional<std::size_t> InstrumentTable::find(const std::string& name) const {
  for (std::size_t c = 0; c < names.size(); ++c)
    if (names[c] == name) return c;
  for (std::size_t c = 0; c < names.size(); ++c)
    if (names[c].rfind(name, 0) == 0) return c;
  return std::nullopt;
}

const std::vector<double>& InstrumentTable::column(const std::string& name, const std::string& file) const {
  if (const auto c = find(name)) return columns[*c];
  throw InputError(file + ": there is no column '" + name + "' among " + joined(names, ", "));
}

std::string instrument_unit(const std::string& unit) {
  std::string plain = unit;
  for (const char* mu : {"\xC2\xB5", "\xCE\xBC"})  // micro sign, Greek mu
    for (std::size_t at = 0; (at = plain.find(mu)) != std::string::npos;) plain.replace(at, 2, "u");
  return plain == "micron" || plain == "microns" ? "um" : plain;
}

}  // namespace asperity

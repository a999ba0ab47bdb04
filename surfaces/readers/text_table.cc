#include "surfaces/readers/text_table.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "core/error.h"
#include "core/quantity.h"
#include "surfaces/readers/height_unit.h"
#include "surfaces/readers/text_names.h"
#include "surfaces/readers/text_parts.h"

namespace asperity {
namespace {

const std::string byte_order_mark = "\xEF\xBB\xBF";
constexpr std::size_t most_header_lines = 500;

/// Goes through the lines of a file.
class Lines {
 public:
  explicit Lines(const std::string& bytes) : bytes_(bytes) {
    if (bytes.compare(0, byte_order_mark.size(), byte_order_mark) == 0) at_ = byte_order_mark.size();
  }
  bool next(std::string& line) {
    if (at_ >= bytes_.size()) return false;
    const auto end = bytes_.find_first_of("\n\r", at_);
    line = bytes_.substr(at_, end == std::string::npos ? end : end - at_);
    at_ = end == std::string::npos ? bytes_.size() : end + 1;
    if (end != std::string::npos && bytes_[end] == '\r' && at_ < bytes_.size() && bytes_[at_] == '\n') ++at_;
    ++number_;
    return true;
  }
  std::size_t number() const { return number_; }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0, number_ = 0;
};

bool is_separator(char c) { return c == ' ' || c == '\t' || c == ',' || c == ';'; }

bool means_missing(const std::string& word) {
  static const std::vector<std::string> words{"nan",  "na", "n/a", "bad", "missing", "void",
                                              "null", "-",  "--",  "---", "***"};
  return std::find(words.begin(), words.end(), lower_case(word)) != words.end();
}

/// "1,5\t2,5" and "1,5;2,5": the comma is the decimal mark where another separator parts the numbers.
bool has_decimal_comma(const std::string& line) {
  if (line.find('.') != std::string::npos || line.find(',') == std::string::npos) return false;
  if (line.find_first_of("\t;") != std::string::npos) return true;
  return line.find(' ') != std::string::npos && line.find(", ") == std::string::npos;
}

/// Appends the numbers of a line; false if it holds anything else (or nothing).
bool append_numbers(std::string line, bool decimal_comma, std::vector<double>& values) {
  if (decimal_comma) std::replace(line.begin(), line.end(), ',', '.');
  const std::size_t before = values.size();
  const char* at = line.c_str();
  const char* const end = at + line.size();
  while (at < end) {
    if (is_separator(*at)) {
      ++at;
      continue;
    }
    char* after = nullptr;
    const double number = std::strtod(at, &after);
    if (after != at && (after == end || is_separator(*after))) {
      values.push_back(number);
      at = after;
      continue;
    }
    const char* word_end = std::find_if(at, end, is_separator);
    if (!means_missing(std::string(at, word_end))) {
      values.resize(before);
      return false;
    }
    values.push_back(std::numeric_limits<double>::quiet_NaN());
    at = word_end;
  }
  return values.size() > before;
}

bool is_comment(const std::string& line) {
  return line[0] == '#' || line[0] == '%' || line.rfind("//", 0) == 0 || line[0] == '!';
}

void add_header_line(const std::string& line, TextTable& table) {
  const std::string content =
      trimmed_text(line.substr(std::min(line.find_first_not_of("#%/! \t"), line.size())));
  const auto mark = content.find_first_of(":=");
  if (mark == std::string::npos || mark == 0) {
    if (!content.empty()) table.titles.push_back(content);
    return;
  }
  table.header.emplace(lower_case(trimmed_text(content.substr(0, mark))),
                       trimmed_text(content.substr(mark + 1)));
}

/// Reads the header and the first row of numbers, and leaves `lines` behind it.
TextTable read_beginning(Lines& lines, bool& decimal_comma) {
  TextTable table;
  std::string line;
  for (std::size_t seen = 0; seen < most_header_lines && lines.next(line); ++seen) {
    line = trimmed_text(line);
    if (line.empty()) continue;
    if (!is_comment(line)) {
      decimal_comma = has_decimal_comma(line);
      if (append_numbers(line, decimal_comma, table.values)) {
        table.columns = table.values.size();
        table.rows = 1;
        return table;
      }
    }
    add_header_line(line, table);
  }
  return table;
}

/// "height conversion factor (-> m)=2.9e-8": what numbers are to be multiplied by, and the unit they have
/// then.
std::optional<NumberWithUnit> height_factor(const TextTable& table) {
  const std::string name = "height conversion factor (->";
  const auto found = table.header.lower_bound(name);
  if (found == table.header.end() || found->first.rfind(name, 0) != 0) return std::nullopt;
  const auto number = whole_number_text(found->second);
  if (!number) return std::nullopt;
  const auto close = found->first.find(')');
  return NumberWithUnit{*number, trimmed_text(found->first.substr(name.size(), close - name.size()))};
}

}  // namespace

std::string TextTable::find(const std::vector<std::string>& names) const {
  for (const auto& name : names)
    if (const auto found = header.find(name); found != header.end()) return found->second;
  return "";
}

TextTable text_beginning(const SourceFile& file) {
  constexpr std::size_t examined = 1 << 16;
  if (file.bytes.substr(0, examined).find('\0') != std::string::npos) return {};
  Lines lines(file.bytes);
  bool decimal_comma = false;
  return read_beginning(lines, decimal_comma);
}

TextTable text_table(const SourceFile& file) {
  Lines lines(file.bytes);
  bool decimal_comma = false;
  TextTable table = read_beginning(lines, decimal_comma);
  std::string line;
  while (lines.next(line)) {
    line = trimmed_text(line);
    if (line.empty() || is_comment(line)) continue;
    const std::size_t before = table.values.size();
    if (!append_numbers(line, decimal_comma, table.values)) {
      const std::string shown = line.substr(0, 20) + (line.size() > 20 ? "..." : "");
      throw InputError("line " + std::to_string(lines.number()) + " of " + file.name() +
                       " is no row of numbers ('" + shown +
                       "'): it is damaged or of another kind; export it again");
    }
    if (table.values.size() - before != table.columns)
      throw InputError("line " + std::to_string(lines.number()) + " of " + file.name() + " has " +
                       std::to_string(table.values.size() - before) + " numbers where the first row has " +
                       std::to_string(table.columns) + ": it is cut off or damaged; copy or export it again");
    ++table.rows;
  }
  return table;
}

double text_height_unit(const SourceFile& file, const TextTable& table, const ReadOptions& options,
                        StoredMap& map) {
  std::string unit = table.find(text_names::value_unit);
  if (unit.empty()) unit = table.find(text_names::any_unit);
  if (const auto factor = height_factor(table)) {
    const double metres = factor->number * height_unit(file, factor->unit, options, map);
    map.scale = "heights in " + format_quantity(metres, Dimension::length, 6) + " by the header's conversion";
    return metres;
  }
  return height_unit(file, unit, options, map);
}

}  // namespace asperity

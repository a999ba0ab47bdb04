#include "diagnosis/recording/recording_table_file.h"

#include <cmath>
#include <cstdlib>
#include <string_view>

#include "core/error.h"
#include "core/printed.h"
#include "core/read_limits.h"
#include "core/text_file.h"
#include "diagnosis/recording/cell_text.h"
#include "diagnosis/recording/file_size.h"

namespace asperity {
namespace {

struct Column {
  std::string channel;  ///< "segment" for the text column; empty: nameless, and its cells must be empty
  double factor = 1;    ///< to SI

  bool is_number() const { return !channel.empty() && channel != "segment"; }
};

std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells;
  for (std::size_t from = 0;;) {
    const auto comma = line.find(',', from);
    cells.push_back(cell_text(line.substr(from, comma == std::string_view::npos ? comma : comma - from)));
    if (comma == std::string_view::npos) return cells;
    from = comma + 1;
  }
}

/// "normal_force [uN]" -> channel and factor.
Column column_of(const std::string& head) {
  const auto bracket = head.find('['), round = head.find('(');
  Column column{cell_text(head.substr(0, bracket)), 1};
  if (column.channel.empty() && bracket == std::string::npos) return column;
  if (bracket == std::string::npos && round != std::string::npos)
    throw InputError("the unit of column '" + head +
                     "' stands in round brackets; write it in square ones, as '" +
                     cell_text(head.substr(0, round)) + " [...]'");
  if (column.channel == "segment") return column;
  const Dimension dimension = dimension_of_channel(column.channel);
  if (bracket == std::string::npos) return column;
  const auto end = head.find(']', bracket);
  if (end == std::string::npos)
    throw InputError("column '" + head + "' lacks the closing bracket of its unit");
  const std::string unit = cell_text(head.substr(bracket + 1, end - bracket - 1));
  const bool is_plain = dimension == Dimension::none && (unit == "-" || unit == "–");
  try {
    if (!is_plain) column.factor = unit_factor(unit, dimension);
  } catch (const InputError& error) {
    throw InputError("in column '" + head + "' the " + error.what());
  }
  return column;
}

bool is_unit_of(const std::string& cell, const std::string& channel) {
  try {
    unit_factor(cell, dimension_of_channel(channel));
    return true;
  } catch (const InputError&) {
    return false;
  }
}

double number_of(const std::string& cell, const Column& column) {
  if (cell.empty()) return std::numeric_limits<double>::quiet_NaN();
  char* end = nullptr;
  const double value = std::strtod(cell.c_str(), &end);
  if (end == cell.c_str() || *end != '\0')
    throw InputError("'" + cell + "' in column '" + column.channel + "' is not a number; " +
                     (is_unit_of(cell, column.channel)
                          ? "write units behind the names, as '" + column.channel + " [" + cell + "]'"
                          : "leave the cell empty if the value is missing"));
  if (!std::isfinite(value))
    throw InputError("'" + cell + "' in column '" + column.channel +
                     "' is not finite; leave the cell empty if the value is missing");
  return value * column.factor;
}

std::vector<Column> header_of(const std::vector<std::string>& cells) {
  for (const char separator : {';', '\t'})
    if (cells.size() == 1 && cells[0].find(separator) != std::string::npos)
      throw InputError(std::string("cells are separated by ") + (separator == ';' ? "';'" : "tabs") +
                       " here; separate them by commas, with points in the numbers");
  std::vector<Column> columns;
  for (const auto& head : cells) {
    columns.push_back(column_of(head));
    for (std::size_t i = 0; i + 1 < columns.size(); ++i)
      if (columns[i].channel == columns.back().channel && !columns[i].channel.empty())
        throw InputError("column '" + columns.back().channel + "' stands there twice; remove one");
  }
  return columns;
}

void append_row(const std::vector<std::string>& cells, const std::vector<Column>& columns,
                const std::vector<std::vector<double>*>& targets, std::vector<std::string>& segments) {
  if (cells.size() != columns.size())
    throw InputError(std::to_string(cells.size()) + " cells where the header has " +
                     std::to_string(columns.size()));
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (targets[c])
      targets[c]->push_back(number_of(cells[c], columns[c]));
    else if (!columns[c].channel.empty())
      segments.push_back(cells[c]);
    else if (!cells[c].empty())
      throw InputError("column " + std::to_string(c + 1) + " holds '" + cells[c] +
                       "' and has no name; name it or remove it");
  }
}

}  // namespace

void read_table_file(const std::filesystem::path& path, RecordingTable& table) {
  check_file_size(path, "thin it or split it into recordings");
  const std::string text = read_text_file(path);
  std::vector<Column> columns;
  std::vector<std::vector<double>*> targets;
  std::size_t number = 0;
  for (std::size_t from = 0; from < text.size();) {
    const auto end = std::min(text.find('\n', from), text.size());
    const std::string_view line(text.data() + from, end - from);
    from = end + 1;
    ++number;
    if (cell_text(line).empty() || line.front() == '#') continue;
    try {
      if (line.size() > read_limits::longest_line)
        throw InputError("this line is longer than " + std::to_string(read_limits::longest_line) +
                         " characters; this is no table of samples");
      const std::vector<std::string> cells = cells_of(line);
      if (columns.empty()) {
        columns = header_of(cells);
        for (const auto& column : columns)
          targets.push_back(column.is_number() ? &table.columns[column.channel] : nullptr);
        continue;
      }
      append_row(cells, columns, targets, table.segment);
    } catch (const InputError& refusal) {
      throw InputError(path.string() + ":" + std::to_string(number) + ": " + refusal.what());
    }
  }
  if (columns.empty()) throw InputError(path.string() + ": the table is empty; it needs a header row");
}

std::vector<std::string> channels_in_order(const RecordingTable& table) {
  std::vector<std::string> names;
  for (const auto& channel : known_channels())
    for (const auto& name : {channel, channel + "_sd"})
      if (table.has(name)) names.push_back(name);
  return names;
}

std::string heading_of(const std::string& channel) {
  const std::string unit = unit_of_channel(channel);
  return channel + (unit.empty() ? "" : " [" + unit + "]");
}

std::string cell_of(double value) { return std::isnan(value) ? "" : printed("%.10g", value); }

std::string format_table_file(const RecordingTable& table) {
  std::string text;
  std::vector<const std::vector<double>*> columns;
  for (const auto& name : channels_in_order(table)) {
    text += (text.empty() ? "" : ",") + heading_of(name);
    columns.push_back(&table.columns.at(name));
  }
  const bool has_segments = !table.segment.empty();
  if (has_segments) text += ",segment";
  text += '\n';
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t c = 0; c < columns.size(); ++c) text += (c ? "," : "") + cell_of((*columns[c])[row]);
    if (has_segments) text += "," + table.segment[row];
    text += '\n';
  }
  return text;
}

}  // namespace asperity

// A table with a header row, its columns mapped to channels: "channel [unit] = factor * column * column". A
// constant alone fills the column. "channel:forward" and "channel:backward" hold the two directions of a scan
// side by side: each run becomes a loop, there and back.
#include <algorithm>
#include <map>

#include "core/error.h"
#include "core/joined.h"
#include "diagnosis/import/segments.h"
#include "diagnosis/import/text_formats.h"
#include "diagnosis/recording/cell_text.h"

namespace asperity {
namespace {

/// One entry of the map.
struct MappedColumn {
  std::string channel, direction, unit, expression;  ///< direction: "", "forward", "backward"
};

MappedColumn parsed(const std::string& entry) {
  const auto equals = entry.find('=');
  const std::string refusal = "the column map '" + entry + "' is not of the form \"channel [unit] = column\"";
  if (equals == std::string::npos) throw InputError(refusal);
  std::string left = cell_text(entry.substr(0, equals));
  MappedColumn mapped;
  mapped.expression = cell_text(entry.substr(equals + 1));
  const auto bracket = left.find('[');
  if (bracket != std::string::npos) {
    const auto end = left.find(']', bracket);
    if (end == std::string::npos) throw InputError(refusal);
    mapped.unit = cell_text(left.substr(bracket + 1, end - bracket - 1));
    left = cell_text(left.substr(0, bracket));
  }
  const auto colon = left.find(':');
  if (colon != std::string::npos) {
    mapped.direction = left.substr(colon + 1);
    left = left.substr(0, colon);
    if (mapped.direction != "forward" && mapped.direction != "backward")
      throw InputError("the column map '" + entry + "' has the direction '" + mapped.direction +
                       "'; it is forward or backward");
  }
  mapped.channel = left;
  if (left.empty() || mapped.expression.empty()) throw InputError(refusal);
  dimension_of_channel(left);  // refuses what is none
  return mapped;
}

/// factor * column * column, or a constant.
std::vector<double> evaluated(const std::string& expression, const InstrumentTable& source,
                              const std::string& file) {
  std::vector<double> values(source.rows(), 1.0);
  for (std::size_t from = 0; from <= expression.size();) {
    const auto star = std::min(expression.find('*', from), expression.size());
    const std::string factor = cell_text(expression.substr(from, star - from));
    from = star + 1;
    const auto number = number_in(factor);
    if (number && !source.find(factor)) {
      for (double& value : values) value *= *number;
    } else {
      const auto& column = source.column(factor, file);
      for (std::size_t i = 0; i < values.size(); ++i) values[i] *= column[i];
    }
  }
  return values;
}

/// The unit of a channel: what the map says, else what the file says of a column that is taken as it is, else
/// the SI unit.
std::string unit_of(const MappedColumn& mapped, const InstrumentTable& source) {
  if (!mapped.unit.empty()) return mapped.unit;
  const auto column = source.find(mapped.expression);
  if (column && !source.units[*column].empty() && dimension_of_channel(mapped.channel) != Dimension::none)
    return source.units[*column];
  return unit_of_channel(mapped.channel);
}

/// The first line whose successor, or that under a row of units, is numbers under as many names.
std::size_t header_line(const InstrumentText& text) {
  for (std::size_t i = 0; i + 1 < text.lines.size(); ++i) {
    const auto names = cells_of_line(text.lines[i]);
    const auto numbers = cells_of_line(text.lines[is_row_of_units(text, i, i + 1) ? i + 2 : i + 1]);
    if (names.size() < 2 || numbers.size() < names.size() || number_in(names[0]) || text.lines[i][0] == '#')
      continue;
    if (number_in(numbers[0]) && number_in(numbers[1])) return i;
  }
  throw InputError(text.file + ": there is no row of names with a row of as many numbers under it");
}

}  // namespace

bool is_csv(const InstrumentText&) { return true; }

Recording read_mapped_csv(const InstrumentText& text, const ImportOptions& options) {
  const InstrumentTable source = table_under(text, header_line(text));
  if (options.columns.empty())
    throw InputError(text.file +
                     ": say what its columns are with --column \"channel [unit] = column\"; there are " +
                     joined(source.names, ", "));
  const bool is_normal = options.mode == Motion::normal;
  RecordingTable table;
  table.file = is_normal ? "loading.csv" : "loops.csv";
  table.control = is_normal ? std::vector<std::string>{"normal_displacement"}
                            : std::vector<std::string>{"lateral_displacement", "normal_force"};
  table.response = is_normal ? "normal_force" : "lateral_force";
  std::map<std::string, std::vector<double>> by_direction[2];
  bool has_directions = false;
  for (const auto& entry : options.columns) {
    const MappedColumn mapped = parsed(entry);
    const std::vector<double> values = evaluated(mapped.expression, source, text.file);
    has_directions = has_directions || !mapped.direction.empty();
    RecordingTable one;
    add_channel(one, mapped.channel, values, unit_of(mapped, source));
    for (int direction = 0; direction < 2; ++direction)
      if (mapped.direction.empty() || (mapped.direction == "forward") == (direction == 0))
        by_direction[direction][mapped.channel] = one.columns.at(mapped.channel);
  }
  if (!has_directions) {
    table.columns = by_direction[0];
    if (!table.has("run")) table.columns["run"].assign(source.rows(), 1);
    const std::string driven = options.control.empty() ? table.control.front() : options.control.front();
    if (is_normal && table.has(driven)) table.segment = find_segments(table.column(driven)).segment;
  } else {
    // Rows of one run (line of a scan): there in order, back in the reverse.
    const std::vector<double> runs =
        by_direction[0].count("run") ? by_direction[0]["run"] : std::vector<double>(source.rows(), 1);
    for (std::size_t from = 0, to = 0; from < runs.size(); from = to) {
      while (to < runs.size() && runs[to] == runs[from]) ++to;
      for (int direction = 0; direction < 2; ++direction)
        for (std::size_t k = from; k < to; ++k) {
          const std::size_t i = direction == 0 ? k : from + to - 1 - k;
          for (const auto& [channel, values] : by_direction[direction])
            table.columns[channel].push_back(values[i]);
          table.segment.push_back(direction == 0 ? "forward" : "backward");
        }
    }
  }
  Recording recording;
  recording.title = std::filesystem::path(text.file).stem().string();
  recording.tables = {table};
  return recording;
}

}  // namespace asperity

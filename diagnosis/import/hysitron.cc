// Hysitron: "File Version: Hysitron ..." with "Test Data Points: N", or "Number of Points = N"; displacement,
// force and time. The header's "Disp Shift" and "Force Shift" (its zero at contact) are taken off; its
// machine compliance is left to the diagnosis.
#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "diagnosis/import/segments.h"
#include "diagnosis/import/text_formats.h"

namespace asperity {
namespace {

constexpr const char* points_of_text = "Number of Points";
constexpr const char* test_of_hld = "Test Data Points";

/// Unit in "Depth (nm)" or "Force_µN".
std::string unit_in(const std::string& name) {
  const auto open = name.find('(');
  if (open != std::string::npos)
    return instrument_unit(name.substr(open + 1, name.find(')', open) - open - 1));
  return instrument_unit(name.substr(name.rfind('_') + 1));
}

}  // namespace

bool is_hysitron(const InstrumentText& text) {
  constexpr std::size_t first_lines = 5;
  for (std::size_t i = 0; i < std::min(first_lines, text.lines.size()); ++i)
    if (text.lines[i].find("Hysitron") != std::string::npos || text.lines[i].rfind(points_of_text, 0) == 0)
      return true;
  return false;
}

Recording read_hysitron(const InstrumentText& text, const ImportOptions&) {
  const auto points = text.line_with(test_of_hld);
  const auto announced = points ? points : text.line_with(points_of_text);
  if (!announced || *announced + 1 >= text.lines.size())
    throw InputError(text.file + ": says it is Hysitron's but has neither '" + test_of_hld + "' nor '" +
                     points_of_text + "'; it may be cut short");
  const InstrumentTable source = table_under(text, *announced + 1);
  const auto count = text.number_behind(points ? test_of_hld : points_of_text);
  if (count && static_cast<double>(source.rows()) < *count)
    throw InputError(text.file + ": announces " + std::to_string(std::lround(*count)) + " points and holds " +
                     std::to_string(source.rows()) + "; it is cut short");
  RecordingTable table;
  table.file = "loading.csv";
  // The instrument drives the force, but before contact only the displacement says where it is.
  table.control = {"normal_displacement"};
  table.response = "normal_force";
  for (const auto& [channel, names] : {std::pair<std::string, std::vector<std::string>>{"time", {"Time"}},
                                       {"normal_displacement", {"Disp_", "Depth ("}},
                                       {"normal_force", {"Force_", "Load ("}}}) {
    for (const auto& name : names)
      if (const auto c = source.find(name)) {
        add_channel(table, channel, source.columns[*c], unit_in(source.names[*c]));
        break;
      }
    if (!table.has(channel)) source.column(names.front(), text.file);  // says what there is
  }
  // What the instrument's program found as zero at contact, where it says so.
  if (const auto shift = text.number_behind("Disp Shift"))
    for (double& d : table.columns["normal_displacement"]) d -= *shift * unit_factor("nm", Dimension::length);
  if (const auto shift = text.number_behind("Force Shift"))
    for (double& f : table.columns["normal_force"]) f -= *shift * unit_factor("uN", Dimension::force);
  table.columns["run"].assign(source.rows(), 1);
  table.segment = find_segments(table.column("normal_force")).segment;
  Recording recording;
  recording.title = "Hysitron, " + text.lines.front();
  recording.tables = {table};
  return recording;
}

}  // namespace asperity

// Points "x y z" line by line (.xyz) on a regular grid, in any order; y grows upwards. Units from the header
// ("# Lateral units: um", "# Value units: nm", or titles "x [um] y [um] z [nm]"), else metres if that is
// plausible. A grid place without a point is missing.
#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>

#include "core/error.h"
#include "surfaces/readers/channels.h"
#include "surfaces/readers/length_unit.h"
#include "surfaces/readers/text_names.h"
#include "surfaces/readers/text_parts.h"
#include "surfaces/readers/text_table.h"

namespace asperity {
namespace {

constexpr std::size_t coordinates = 3;

/// Equidistant places along one axis.
struct GridAxis {
  double first = 0, spacing = 0;
  int points = 0;

  int index(double position) const { return static_cast<int>(std::lround((position - first) / spacing)); }
};

[[noreturn]] void refuse_grid(const SourceFile& file) {
  throw InputError(file.name() +
                   " has points that lie on no regular grid; interpolate them to a grid, for example in "
                   "Gwyddion, and pass a .gsf");
}

/// The grid whose places the positions take: the median gap between neighbours is its spacing.
GridAxis find_axis(const SourceFile& file, std::vector<double> positions) {
  constexpr double same_place = 1e-6;      // relative to the range
  constexpr double largest_offset = 0.25;  // of the spacing: rounded coordinates
  constexpr double most_points = 1 << 20;
  std::sort(positions.begin(), positions.end());
  const double range = positions.back() - positions.front();
  std::vector<double> gaps;
  for (std::size_t i = 1; i < positions.size(); ++i)
    if (positions[i] - positions[i - 1] > same_place * range) gaps.push_back(positions[i] - positions[i - 1]);
  if (gaps.empty())
    throw InputError(file.name() +
                     " has all its points on one line, a profile and not a map; pass a height map");
  std::nth_element(gaps.begin(), gaps.begin() + gaps.size() / 2, gaps.end());
  GridAxis axis;
  const double intervals = std::round(range / gaps[gaps.size() / 2]);
  if (!(intervals + 1 <= most_points)) refuse_grid(file);  // also where the range overflows
  axis.first = positions.front();
  axis.points = static_cast<int>(intervals) + 1;
  axis.spacing = range / intervals;
  for (const double position : positions)
    if (std::abs(position - axis.first - axis.index(position) * axis.spacing) > largest_offset * axis.spacing)
      refuse_grid(file);
  return axis;
}

/// Units in brackets of a title line "x [um], y [um], z (nm)": empty unless there are three.
std::vector<std::string> title_units(const TextTable& table) {
  static const std::regex bracketed(R"([\[(]\s*([^\])]+?)\s*[\])])");
  constexpr std::size_t longest = 1000;  // characters: std::regex recurses from one to the next
  for (const auto& title : table.titles) {
    if (title.size() > longest) continue;
    std::vector<std::string> units;
    for (std::sregex_iterator it(title.begin(), title.end(), bracketed), end; it != end; ++it)
      units.push_back((*it)[1]);
    if (units.size() == coordinates) return units;
  }
  return {};
}

double lateral_unit(const SourceFile& file, const TextTable& table, StoredMap& map) {
  std::string unit = table.find(text_names::lateral_unit);
  if (unit.empty()) unit = table.find(text_names::any_unit);
  if (unit.empty()) {
    map.lateral_unit_assumed = true;
    map.note += std::string(map.note.empty() ? "" : "; ") + "no unit of length given, metres taken";
    return 1.0;
  }
  if (const auto factor = length_unit_factor(unit)) return *factor;
  throw InputError(file.name() + " has coordinates in '" + unit +
                   "', which is no length; pass points with lengths");
}

StoredMap read(const SourceFile& file, const ReadOptions& options) {
  TextTable table = text_table(file);
  if (const auto units = title_units(table); !units.empty()) {
    table.header.emplace("lateral units", units[0]);
    table.header.emplace("value units", units[2]);
  }
  StoredMap map;
  const double height_unit = text_height_unit(file, table, options, map);
  const double unit = lateral_unit(file, table, map);
  map.channel = table.find(text_names::channel);
  choose_channel(file, {{map.channel, "", true}}, options);
  std::vector<double> x(table.rows), y(table.rows);
  for (std::size_t i = 0; i < table.rows; ++i) {
    x[i] = table.values[coordinates * i] * unit;
    y[i] = table.values[coordinates * i + 1] * unit;
    if (!std::isfinite(x[i]) || !std::isfinite(y[i]))
      throw InputError(file.name() + " has a point without x or y (row " + std::to_string(i + 1) +
                       " of numbers); export it again");
  }
  const GridAxis along_x = find_axis(file, x), along_y = find_axis(file, y);
  constexpr double least_filled = 0.25;  // of the grid; fewer points mean scattered positions
  const std::size_t places = static_cast<std::size_t>(along_x.points) * along_y.points;
  if (static_cast<double>(table.rows) < least_filled * static_cast<double>(places)) refuse_grid(file);
  map.nx = along_x.points;
  map.ny = along_y.points;
  map.heights.assign(places, std::numeric_limits<double>::quiet_NaN());
  std::vector<bool> taken(places, false);
  for (std::size_t i = 0; i < table.rows; ++i) {
    const std::size_t place = static_cast<std::size_t>(along_y.index(y[i])) * map.nx + along_x.index(x[i]);
    if (taken[place])
      throw InputError(file.name() + " has two points at one place of its grid (row " +
                       std::to_string(i + 1) + " of numbers); export it again");
    taken[place] = true;
    map.heights[place] = table.values[coordinates * i + 2] * height_unit;
  }
  map.lx = map.nx * along_x.spacing;
  map.ly = map.ny * along_y.spacing;
  map.first_row = FirstRow::bottom;
  return map;
}

/// Three columns; a header that gives a size or a pixel size announces a matrix.
bool recognises(const SourceFile& file) {
  const TextTable beginning = text_beginning(file);
  if (beginning.columns != coordinates) return false;
  for (const auto& names : {text_names::width, text_names::size, text_names::pixel})
    if (!beginning.find(names).empty()) return false;
  return true;
}

}  // namespace

namespace formats {
TopographyFormat make_xyz() {
  return {"points (.xyz)", {".xyz"}, "rows of three numbers", recognises, read, Tried::particular_text};
}
}  // namespace formats

}  // namespace asperity

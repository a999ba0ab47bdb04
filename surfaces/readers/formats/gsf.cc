// Gwyddion Simple Field (.gsf), read and written. Format: Gwyddion user guide, "Simple Field Files": the
// magic line, lines "name = value", one to four NUL bytes up to a multiple of four, then 32-bit floats, top
// row first; NaN where missing. Numbers are in base SI units. Checked against the real maps of the tests.
#include <cmath>
#include <map>
#include <sstream>

#include "core/atomic_file.h"
#include "core/error.h"
#include "surfaces/readers/format.h"
#include "surfaces/readers/length_unit.h"
#include "surfaces/readers/text_parts.h"

namespace asperity {
namespace {

const std::string magic = "Gwyddion Simple Field 1.";
constexpr std::size_t alignment = 4;

std::map<std::string, std::string> header_fields(const std::string& header) {
  std::map<std::string, std::string> fields;
  std::istringstream lines(header);
  std::string line;
  while (std::getline(lines, line)) {
    const auto equals = line.find('=');
    if (equals != std::string::npos)
      fields[trimmed_text(line.substr(0, equals))] = trimmed_text(line.substr(equals + 1));
  }
  return fields;
}

int pixels(const SourceFile& file, const std::map<std::string, std::string>& fields,
           const std::string& name) {
  const auto found = fields.find(name);
  const auto number = found == fields.end() ? std::nullopt : whole_number_text(found->second);
  constexpr double most = 1 << 20;
  if (!number || !(*number >= 1) || *number > most || *number != std::floor(*number))
    throw InputError(file.name() + " has no valid '" + name +
                     "' in its header, so it is damaged; export it again");
  return static_cast<int>(*number);
}

/// Factor to metres of a unit field; lengths without a unit are metres by the format's use of base units.
double unit_of(const SourceFile& file, const std::map<std::string, std::string>& fields,
               const std::string& name, bool& assumed, std::string& note) {
  const auto found = fields.find(name);
  if (found == fields.end() || found->second.empty()) {
    note += (note.empty() ? "" : "; ") + name + " not given, metres taken";
    assumed = true;
    return 1.0;
  }
  if (const auto factor = length_unit_factor(found->second)) return *factor;
  throw InputError(file.name() + " has " + name + " '" + found->second +
                   "', which is no length; export the channel of the topography");
}

std::optional<double> size_of(const std::map<std::string, std::string>& fields, const std::string& name,
                              double unit) {
  const auto found = fields.find(name);
  const auto number = found == fields.end() ? std::nullopt : whole_number_text(found->second);
  return number ? std::optional<double>(*number * unit) : std::nullopt;
}

StoredMap read(const SourceFile& file, const ReadOptions&) {
  const auto header_end = file.bytes.find('\0');
  if (header_end == std::string::npos)
    throw InputError(file.name() + " ends inside its header: it is cut off; copy or export it again");
  const auto fields = header_fields(file.bytes.substr(0, header_end));
  StoredMap map;
  map.nx = pixels(file, fields, "XRes");
  map.ny = pixels(file, fields, "YRes");
  const std::size_t data_begin = header_end + alignment - header_end % alignment;
  const std::size_t points = static_cast<std::size_t>(map.nx) * map.ny;
  const std::size_t expected = data_begin + points * sizeof(float);
  if (file.bytes.size() < expected)
    throw InputError(file.name() + " has " + std::to_string(file.bytes.size()) + " of the " +
                     std::to_string(expected) + " bytes that " + std::to_string(map.nx) + " x " +
                     std::to_string(map.ny) + " pixels take: it is cut off; copy or export it again");
  if (file.bytes.size() > expected)
    throw InputError(file.name() + " has more bytes than its " + std::to_string(map.nx) + " x " +
                     std::to_string(map.ny) + " pixels take: its header is wrong; export it again");
  const double height_unit = unit_of(file, fields, "ZUnits", map.height_unit_assumed, map.note);
  map.heights.resize(points);
  for (std::size_t i = 0; i < points; ++i)
    map.heights[i] = height_unit * little_endian<float>(file.bytes, data_begin + i * sizeof(float));
  if (fields.count("XReal") || fields.count("YReal")) {
    const double lateral_unit = unit_of(file, fields, "XYUnits", map.lateral_unit_assumed, map.note);
    map.lx = size_of(fields, "XReal", lateral_unit);
    map.ly = size_of(fields, "YReal", lateral_unit);
  }
  const auto title = fields.find("Title");
  if (title != fields.end()) map.channel = title->second;
  const auto unit = fields.find("ZUnits");
  map.scale = "heights in " + (unit == fields.end() || unit->second.empty() ? "m" : plain_unit(unit->second));
  map.first_row = FirstRow::top;
  return map;
}

bool recognises(const SourceFile& file) { return file.bytes.compare(0, magic.size(), magic) == 0; }

}  // namespace

namespace formats {
TopographyFormat make_gsf() {
  return {"Gwyddion Simple Field (.gsf)", {".gsf"}, "the line 'Gwyddion Simple Field 1.0'", recognises, read};
}
}  // namespace formats

void write_gsf(const std::filesystem::path& path, const Topography& map) {
  std::ostringstream header;
  header.precision(17);
  header << "Gwyddion Simple Field 1.0\nXRes = " << map.nx << "\nYRes = " << map.ny << "\nXReal = " << map.lx
         << "\nYReal = " << map.ly << "\nXYUnits = m\nZUnits = m\n";
  if (!map.channel.empty()) {
    std::string title = map.channel;
    for (char& c : title)
      if (c == '\n' || c == '\0') c = ' ';
    header << "Title = " << title << "\n";
  }
  std::string bytes = header.str();
  bytes.append(alignment - bytes.size() % alignment, '\0');
  std::vector<float> row(map.nx);
  for (int iy = map.ny - 1; iy >= 0; --iy) {
    for (int ix = 0; ix < map.nx; ++ix) {
      const bool missing = !map.missing.empty() && map.missing[static_cast<std::size_t>(iy) * map.nx + ix];
      row[ix] = missing ? std::nanf("") : static_cast<float>(map.at(ix, iy));
    }
    bytes.append(reinterpret_cast<const char*>(row.data()), row.size() * sizeof(float));
  }
  write_file_atomically(path, bytes);
}

}  // namespace asperity

#include <array>
#include <utility>

#include "core/entry_call.h"
#include "core/error.h"
#include "core/quantity.h"
#include "core/topography_spec.h"

namespace asperity {
namespace {

constexpr std::array<std::pair<Level, const char*>, 6> level_names{{{Level::mean, "mean"},
                                                                    {Level::plane, "plane"},
                                                                    {Level::quadratic, "quadratic"},
                                                                    {Level::rows0, "rows0"},
                                                                    {Level::rows1, "rows1"},
                                                                    {Level::rows2, "rows2"}}};
const std::string call = "scan";
const std::string example =
    "scan(FILE, size=2.5 um, channel=Height, unit=nm, level=plane, cutoff=20 nm, outside=mirror)";

void set_argument(ScanParameters& scan, const std::string& key, const std::string& value) {
  if (value.empty()) throw InputError("there is no value");
  if (key.empty()) {
    if (!scan.file.empty())
      throw InputError("a file is named already, and other arguments are written key=value");
    scan.file = value;
  } else if (key == "size") {
    scan.options.size_x_m = parse_quantity(value, Dimension::length);
    if (!(*scan.options.size_x_m > 0)) throw InputError("'" + value + "' is no length above 0");
  } else if (key == "channel") {
    scan.options.channel = value;
  } else if (key == "unit") {
    unit_factor(value, Dimension::length);
    scan.options.height_unit = value;
  } else if (key == "level") {
    scan.level = parse_level(value);
  } else if (key == "cutoff") {
    scan.cutoff = parse_quantity(value, Dimension::length);
    if (!(scan.cutoff > 0)) throw InputError("'" + value + "' is no wavelength above 0");
  } else if (key == "outside") {
    if (value != "refuse" && value != "mirror")
      throw InputError("'" + value + "' is neither refuse nor mirror");
    scan.outside = value == "mirror" ? Outside::mirror : Outside::refuse;
  } else {
    throw InputError(
        "there is no such argument; those known are size, channel, unit, level, cutoff, outside");
  }
}

}  // namespace

Level parse_level(const std::string& name) {
  std::string known;
  for (const auto& [level, known_name] : level_names) {
    if (name == known_name) return level;
    known += (known.empty() ? "" : ", ") + std::string(known_name);
  }
  throw InputError("there is no levelling '" + name + "'; choose one of " + known);
}

std::string level_name(Level level) {
  for (const auto& [known, name] : level_names)
    if (known == level) return name;
  return "";
}

std::string ScanParameters::text() const {
  std::string arguments;
  if (options.size_x_m) arguments += ", size=" + format_quantity(*options.size_x_m, Dimension::length, 6);
  if (options.channel) arguments += ", channel=" + *options.channel;
  if (options.height_unit) arguments += ", unit=" + *options.height_unit;
  if (level != Level::plane) arguments += ", level=" + level_name(level);
  if (cutoff > 0) arguments += ", cutoff=" + format_quantity(cutoff, Dimension::length, 6);
  if (outside == Outside::mirror) arguments += ", outside=mirror";
  return arguments.empty() ? file : call + "(" + file + arguments + ")";
}

ScanParameters parse_scan(const std::string& text) {
  const std::string entry = without_outer_blanks(text);
  ScanParameters scan;
  // A file may well be called "scan(1).gsf".
  if (!is_entry_call(entry, call) || entry.back() != ')') {
    scan.file = entry;
    return scan;
  }
  read_entry_call(entry, call, example,
                  [&](const std::string& key, const std::string& value) { set_argument(scan, key, value); });
  if (scan.file.empty()) throw InputError("'" + text + "' names no file; write for example " + example);
  return scan;
}

}  // namespace asperity

// From a path to a Topography: recognise, read, settle size, rows and missing points, and say back what was
// done.
#include "surfaces/read_topography.h"

#include <algorithm>
#include <cmath>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/quantity.h"
#include "core/text_file.h"
#include "core/utf8.h"
#include "surfaces/readers/foreign_kinds.h"
#include "surfaces/readers/format.h"
#include "surfaces/readers/gzip.h"
#include "surfaces/readers/text_parts.h"

namespace asperity {
namespace {

std::string kinds_read() {
  std::string list;
  for (const auto& format : topography_formats()) list += (list.empty() ? "" : ", ") + format.name;
  return list;
}

[[noreturn]] void refuse_unknown_kind(const SourceFile& file) {
  const std::string ending = lower_case(file.path.extension().string());
  for (const auto& format : topography_formats())
    if (std::find(format.extensions.begin(), format.extensions.end(), ending) != format.extensions.end())
      throw InputError(file.name() + " is named like " + format.name + " but does not begin with " +
                       format.begins_with +
                       ": it is damaged or of another kind; export it again, for example as .gsf");
  throw InputError(file.name() + " is of a kind that is not read; pass one of " + kinds_read() +
                   " (Gwyddion exports .gsf from most others)");
}

const TopographyFormat& format_of(const SourceFile& file) {
  if (trimmed_text(file.bytes.substr(0, 4096)).empty() && trimmed_text(file.bytes).empty())
    throw InputError(file.name() + " is empty; copy or export it again");
  for (const auto& format : topography_formats())
    if (format.recognises(file)) return format;
  refuse_foreign_kind(file);
  refuse_unknown_kind(file);
}

/// The user's size wins; where one side is given, pixels are taken as square.
void settle_size(const SourceFile& file, const ReadOptions& options, StoredMap& map) {
  const auto check = [](const std::optional<double>& size) {
    if (size && !(*size > 0 && std::isfinite(*size)))
      throw InputError("the size of a topography is a length above 0; pass for example --size \"2.5 um\"");
  };
  check(options.size_x_m);
  check(options.size_y_m);
  if (options.size_x_m || options.size_y_m) {
    const double x = options.size_x_m ? *options.size_x_m : *options.size_y_m * map.nx / map.ny;
    const double y = options.size_y_m ? *options.size_y_m : *options.size_x_m * map.ny / map.nx;
    const bool differs =
        map.lx && map.ly && (std::abs(*map.lx - x) > 1e-6 * x || std::abs(*map.ly - y) > 1e-6 * y);
    map.note += std::string(map.note.empty() ? "" : "; ") + "size as passed";
    if (differs)
      map.note += " instead of the file's " + format_quantity(*map.lx, Dimension::length, 6) + " x " +
                  format_quantity(*map.ly, Dimension::length, 6);
    map.lx = x;
    map.ly = y;
    map.lateral_unit_assumed = false;
  }
  if (!map.lx || !map.ly)
    throw InputError(file.name() +
                     " does not say how wide the map is; pass its size, for example --size \"2.5 um\"");
  if (!(*map.lx > 0 && *map.ly > 0 && std::isfinite(*map.lx) && std::isfinite(*map.ly)))
    throw InputError(file.name() +
                     " gives a size that is no length above 0; pass it, for example --size \"2.5 um\"");
}

/// A unit that was assumed must at least give a map as scanning instruments measure it.
void check_assumed_units(const SourceFile& file, const StoredMap& map) {
  constexpr double widest_scan = 0.1;  // [m]
  if (map.lateral_unit_assumed && *map.lx > widest_scan)
    throw InputError(file.name() + " names no unit of length, and in metres the map would be " +
                     format_quantity(*map.lx, Dimension::length) +
                     " wide; pass its size, for example --size \"2.5 um\", or name the unit in its header");
  double lowest = INFINITY, highest = -INFINITY;
  for (const double height : map.heights) {
    if (!std::isfinite(height)) continue;
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  if (map.height_unit_assumed && highest - lowest > std::min(*map.lx, *map.ly))
    throw InputError(
        file.name() + " names no unit of height, and in metres the map would be higher than wide (" +
        format_quantity(highest - lowest, Dimension::length) +
        "); name the unit in its header, in a text file by a first line such as '# Value units: nm'");
}

bool has_mark_of_a_format(const SourceFile& file) {
  const auto& formats = topography_formats();
  return std::any_of(formats.begin(), formats.end(), [&](const TopographyFormat& format) {
    return format.tried == Tried::by_mark && format.recognises(file);
  });
}

Topography settled(const SourceFile& file, const TopographyFormat& format, const ReadOptions& options,
                   StoredMap map) {
  if (map.nx < 2 || map.ny < 2)
    throw InputError(file.name() + " holds " + std::to_string(map.nx) + " x " + std::to_string(map.ny) +
                     " points, a profile and not a map; pass a height map of at least 2 x 2 pixels");
  settle_size(file, options, map);
  check_assumed_units(file, map);
  Topography topography;
  topography.nx = map.nx;
  topography.ny = map.ny;
  topography.lx = *map.lx;
  topography.ly = *map.ly;
  topography.periodic = map.periodic;
  topography.channel = as_utf8(map.channel);
  if (map.first_row == FirstRow::top)
    for (int low = 0, high = map.ny - 1; low < high; ++low, --high)
      std::swap_ranges(map.heights.begin() + static_cast<std::ptrdiff_t>(low) * map.nx,
                       map.heights.begin() + static_cast<std::ptrdiff_t>(low + 1) * map.nx,
                       map.heights.begin() + static_cast<std::ptrdiff_t>(high) * map.nx);
  topography.heights = std::move(map.heights);
  std::size_t known = 0;
  for (double& height : topography.heights) {
    if (!std::isfinite(height)) height = std::nan("");
    known += std::isfinite(height);
  }
  if (known == 0) throw InputError(file.name() + " holds no valid height; pass a map that was measured");
  if (known < topography.heights.size())
    for (const double height : topography.heights) topography.missing.push_back(std::isnan(height));
  topography.source =
      as_utf8(file.path.string() + " (" + format.name + "; " + map.scale + "; first row stored is the " +
              (map.first_row == FirstRow::top ? "top" : "bottom") + " of the image" +
              (map.note.empty() ? "" : "; " + map.note) + ")");
  return topography;
}

}  // namespace

Topography topography_from(const SourceFile& file, const ReadOptions& options) {
  const bool packed = is_gzip(file);
  const SourceFile unpacked = packed ? unpacked_gzip(file) : SourceFile{};
  const SourceFile& stored = packed ? unpacked : file;
  const auto text = has_mark_of_a_format(stored) ? std::nullopt : text_of_utf16(stored.bytes);
  const SourceFile recoded = text ? SourceFile{stored.path, *text} : SourceFile{};
  const SourceFile& source = text ? recoded : stored;
  const TopographyFormat& format = format_of(source);
  StoredMap map = format.read(source, options);
  if (packed) map.note += std::string(map.note.empty() ? "" : "; ") + "unpacked from gzip";
  if (text) map.note += std::string(map.note.empty() ? "" : "; ") + "text in UTF-16";
  return settled(source, format, options, std::move(map));
}

Topography read_topography(const std::filesystem::path& path, const ReadOptions& options) {
  return topography_from({path, read_file(path)}, options);
}

std::string describe(const Topography& map) {
  const auto length = [](double value) { return format_quantity(value, Dimension::length, 4); };
  double lowest = INFINITY, highest = -INFINITY;
  for (const double height : map.heights) {
    if (std::isnan(height)) continue;
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  std::string line = std::to_string(map.nx) + " x " + std::to_string(map.ny) + " pixels, " + length(map.lx) +
                     " x " + length(map.ly) + " (x right, y up), heights from " + length(lowest) + " to " +
                     length(highest);
  if (!map.channel.empty()) line += ", channel '" + map.channel + "'";
  const std::size_t missing = map.missing_count();
  line += missing ? ", " + std::to_string(missing) + " missing points" : ", no missing points";
  if (map.periodic) line += ", periodic";
  return map.source.empty() ? line : line + "; from " + map.source;
}

}  // namespace asperity

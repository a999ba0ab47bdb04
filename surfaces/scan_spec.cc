#include "surfaces/scan_spec.h"

#include <cmath>

#include "core/quantity.h"
#include "surfaces/entry_call.h"
#include "surfaces/fft2d.h"
#include "surfaces/fill_missing.h"
#include "surfaces/generate.h"

namespace asperity {
namespace {

const std::string call = "scan";
const std::string example = "scan(FILE, size=2.5 um, channel=Height, unit=nm, level=plane, cutoff=20 nm, outside=mirror)";

void set_argument(ScanParameters& scan, const std::string& key, const std::string& value) {
  if (value.empty()) throw InputError("there is no value");
  if (key.empty()) {
    if (!scan.file.empty()) throw InputError("a file is named already, and other arguments are written key=value");
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
    if (value != "refuse" && value != "mirror") throw InputError("'" + value + "' is neither refuse nor mirror");
    scan.outside = value == "mirror" ? Outside::mirror : Outside::refuse;
  } else {
    throw InputError("there is no such argument; those known are size, channel, unit, level, cutoff, outside");
  }
}

/// The map, without missing points, in the middle of its own mirror images: periodic with twice its size. Where it has an odd number
/// of pixels, its centre lies half a pixel off.
Topography mirrored(const Topography& map) {
  Topography image = map;
  image.nx = 2 * map.nx;
  image.ny = 2 * map.ny;
  image.lx = 2 * map.lx;
  image.ly = 2 * map.ly;
  image.periodic = true;
  const auto source = [](int i, int n) {
    const int from_edge = (i - n / 2 + 2 * n) % (2 * n);
    return from_edge < n ? from_edge : 2 * n - 1 - from_edge;
  };
  image.heights.resize(4 * map.heights.size());
  for (int iy = 0; iy < image.ny; ++iy)
    for (int ix = 0; ix < image.nx; ++ix) {
      const auto to = static_cast<std::size_t>(iy) * image.nx + ix;
      const auto from = static_cast<std::size_t>(source(iy, map.ny)) * map.nx + source(ix, map.nx);
      image.heights[to] = map.heights[from];
    }
  return image;
}

/// The map without waves shorter than `cutoff` [m]; at its edges as if continued by its mirror images.
Topography without_short_waves(const Topography& map, double cutoff) {
  Topography periodic = map.missing_count() > 0 ? fill_missing(map) : map;
  if (!map.periodic) periodic = mirrored(periodic);
  const int nx = periodic.nx, ny = periodic.ny, columns = nx / 2 + 1;
  HalfSpectrum waves = forward_fft(periodic.heights, nx, ny);
  const double normalisation = 1 / (static_cast<double>(nx) * ny);
  for (int iy = 0; iy < ny; ++iy)
    for (int ix = 0; ix < columns; ++ix) {
      const double waves_per_metre = std::hypot(ix / periodic.lx, signed_wave_number(iy, ny) / periodic.ly);
      waves[static_cast<std::size_t>(iy) * columns + ix] *= waves_per_metre * cutoff > 1 ? 0 : normalisation;
    }
  periodic.heights = inverse_fft(std::move(waves), nx, ny);
  return map.periodic ? periodic : cut_window(periodic, map.nx / 2, map.ny / 2, map.nx, map.ny);
}

}  // namespace

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

ScanParameters parse_scan(const std::string& spec) {
  const std::string text = without_outer_blanks(spec);
  ScanParameters scan;
  // A file may well be called "scan(1).gsf".
  if (!is_entry_call(text, call) || text.back() != ')') {
    scan.file = text;
    return scan;
  }
  read_entry_call(text, call, example,
                  [&](const std::string& key, const std::string& value) { set_argument(scan, key, value); });
  if (scan.file.empty()) throw InputError("'" + spec + "' names no file; write for example " + example);
  return scan;
}

Topography prepared_scan(const std::string& spec) {
  const ScanParameters scan = parse_scan(spec);
  Topography map;
  try {
    map = levelled(read_topography(scan.file, scan.options), scan.level);
  } catch (const InputError& error) {
    throw ScanError(spec, std::string(error.what()) + " (in a case file: Topography = " + example + ")");
  }
  map.source += ", levelled: " + level_name(scan.level);
  if (scan.cutoff > 0) {
    map = without_short_waves(map, scan.cutoff);
    map.source += ", without waves shorter than " + format_quantity(scan.cutoff, Dimension::length);
  }
  return map;
}

void require_cover(const std::string& spec, const Topography& map, double size) {
  const ScanParameters scan = parse_scan(spec);
  if ((map.lx >= size && map.ly >= size) || map.periodic || scan.outside == Outside::mirror) return;
  ScanParameters continued = scan;
  continued.outside = Outside::mirror;
  throw ScanError(spec, "the scan '" + scan.file + "' covers " + format_quantity(map.lx, Dimension::length) + " x " +
                            format_quantity(map.ly, Dimension::length) + " but the contact needs a square of " +
                            format_quantity(size, Dimension::length) +
                            "; take a larger scan, lower the load or Mesh/Contact region, or have it continued by its mirror "
                            "images: Topography = " +
                            continued.text());
}

}  // namespace asperity

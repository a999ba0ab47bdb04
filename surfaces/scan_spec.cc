#include "surfaces/scan_spec.h"

#include <cmath>

#include "core/quantity.h"
#include "surfaces/fft2d.h"
#include "surfaces/fill_missing.h"
#include "surfaces/generate.h"

namespace asperity {
namespace {

/// The map, without missing points, in the middle of its own mirror images: periodic with twice its size.
/// Where it has an odd number of pixels, its centre lies half a pixel off.
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

Topography prepared_scan(const ScanParameters& scan) {
  Topography map;
  try {
    map = levelled(read_topography(scan.file, scan.options), scan.level);
  } catch (const InputError& error) {
    throw ScanError(scan.text(), std::string(error.what()) +
                                     " (in a case file: Topography = scan(FILE, size=2.5 um, channel=Height, "
                                     "unit=nm, level=plane, cutoff=20 nm, outside=mirror))");
  }
  map.source += ", levelled: " + level_name(scan.level);
  if (scan.cutoff > 0) {
    map = without_short_waves(map, scan.cutoff);
    map.source += ", without waves shorter than " + format_quantity(scan.cutoff, Dimension::length);
  }
  return map;
}

void require_cover(const ScanParameters& scan, const Topography& map, double size) {
  if ((map.lx >= size && map.ly >= size) || map.periodic || scan.outside == Outside::mirror) return;
  ScanParameters continued = scan;
  continued.outside = Outside::mirror;
  throw ScanError(scan.text(),
                  "the scan '" + scan.file + "' covers " + format_quantity(map.lx, Dimension::length) +
                      " x " + format_quantity(map.ly, Dimension::length) +
                      " but the contact needs a square of " + format_quantity(size, Dimension::length) +
                      "; take a larger scan, lower the load or Mesh/Contact region, or have it continued by "
                      "its mirror images: Topography = " +
                      continued.text());
}

}  // namespace asperity

// A measured or generated height map: the type that flows from surfaces/ into meshing/.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace asperity {

/// Heights on a regular grid of pixels, SI units. Pixel (ix, iy) covers the cell whose centre is at
/// ((ix + 1/2) dx, (iy + 1/2) dy); x runs along a row to the right, y from row to row upwards; heights grow
/// out of the material. Missing points are a mask, never zeros.
struct Topography {
  int nx = 0, ny = 0;                 ///< pixels
  double lx = 0, ly = 0;              ///< physical size [m]
  std::vector<double> heights;        ///< [iy * nx + ix] in m; NaN where missing
  std::vector<std::uint8_t> missing;  ///< empty, or one flag per pixel
  bool periodic = false;              ///< true if it continues periodically (generated surfaces)
  std::string channel;                ///< name of the channel read, e.g. "Height Sensor"
  std::string source;                 ///< file or generator call, with what was assumed

  /// Spacing of the pixels along x and y [m].
  double dx() const { return lx / nx; }
  double dy() const { return ly / ny; }
  /// Height of a pixel [m]; without a check of its bounds.
  double& at(int ix, int iy) { return heights[static_cast<std::size_t>(iy) * nx + ix]; }
  double at(int ix, int iy) const { return heights[static_cast<std::size_t>(iy) * nx + ix]; }
  /// Number of pixels without a height of their own.
  std::size_t missing_count() const {
    std::size_t count = 0;
    for (const auto flag : missing) count += flag;
    return count;
  }
};

}  // namespace asperity

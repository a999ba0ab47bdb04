// Cells of a plane on which pressures and gaps are told.
#pragma once

#include <cstddef>
#include <vector>

namespace asperity::half_space {

/// Values of all cells, [iy * nx + ix].
using Field = std::vector<double>;

/// A rectangle in nx x ny cells about the origin.
struct Grid {
  int nx = 0, ny = 0;
  double dx = 0, dy = 0;  ///< sides of a cell [m]

  std::size_t cells() const { return static_cast<std::size_t>(nx) * ny; }
  double cell_area() const { return dx * dy; }  ///< [m^2]
  /// Centre of a cell [m].
  double x(int ix) const { return (ix + 0.5 - 0.5 * nx) * dx; }
  double y(int iy) const { return (iy + 0.5 - 0.5 * ny) * dy; }
};

/// A square of half width `half_width` [m] in n x n cells.
inline Grid square_grid(double half_width, int n) { return {n, n, 2 * half_width / n, 2 * half_width / n}; }

/// free: nothing presses beyond the grid. periodic: the grid repeats, and displacements are those without
/// their mean.
enum class Boundary { free, periodic };

}  // namespace asperity::half_space

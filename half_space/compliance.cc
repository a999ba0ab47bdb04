#include "half_space/compliance.h"

#include <cmath>
#include <utility>

#include "core/error.h"

namespace asperity::half_space {
namespace {

/// Of whose second differences the displacement by a uniform pressure on a rectangle is made, over p / (pi
/// E*); odd in x and y (Johnson 1985, eq. 3.25).
double love_corner(double x, double y) { return x * std::asinh(y / x) + y * std::asinh(x / y); }

KernelSpectrum free_spectrum(const Grid& grid, double modulus) {
  const double scale = 1 / (M_PI * modulus);
  return spectrum_of_cells(grid, Parity::even,
                           [scale](double x, double y) { return scale * love_corner(x, y); });
}

KernelSpectrum periodic_spectrum(const Grid& grid, double modulus) {
  const int columns = grid.nx / 2 + 1, rows = grid.ny / 2 + 1;
  const double scale = 1 / static_cast<double>(grid.cells());
  Field spectrum(static_cast<std::size_t>(columns) * rows);
  for (int ix = 0; ix < columns; ++ix)
    for (int iy = 0; iy < rows; ++iy) {
      const double q = 2 * M_PI * std::hypot(ix / (grid.nx * grid.dx), iy / (grid.ny * grid.dy));
      spectrum[static_cast<std::size_t>(ix) * rows + iy] = q > 0 ? scale * 2 / (modulus * q) : 0.0;
    }
  return {grid.nx, grid.ny, Parity::even, std::move(spectrum)};
}

/// Throws InputError where a half-space cannot have them.
KernelSpectrum checked_spectrum(const Grid& grid, Boundary boundary, double modulus) {
  if (grid.nx < 1 || grid.ny < 1 || !(grid.dx > 0) || !(grid.dy > 0) || !std::isfinite(grid.dx + grid.dy))
    throw InputError("a half-space needs a grid with cells of some size");
  if (!(modulus > 0) || !std::isfinite(modulus))
    throw InputError("a half-space needs a finite modulus above 0");
  if (boundary == Boundary::free) return free_spectrum(grid, modulus);
  if (grid.nx % 2 != 0 || grid.ny % 2 != 0)
    throw InputError("a half-space that repeats needs even numbers of cells");
  return periodic_spectrum(grid, modulus);
}

}  // namespace

Compliance::Compliance(const Grid& grid, Boundary boundary, double modulus)
    : boundary_(boundary),
      convolution_(grid, checked_spectrum(grid, boundary, modulus)),
      of_one_cell_(convolution_.spectrum().sum()) {}

}  // namespace asperity::half_space

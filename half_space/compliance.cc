#include "half_space/compliance.h"

#include <cmath>
#include <utility>

#include "core/error.h"
#include "core/threads.h"

namespace asperity::half_space {
namespace {

/// Of whose second differences the displacement by a uniform pressure on a rectangle is made, over p / (pi
/// E*); odd in x and y (Johnson 1985, eq. 3.25).
double love_corner(double x, double y) { return x * std::asinh(y / x) + y * std::asinh(x / y); }

/// The same of 1/(r^2 + b^2)^(1/2) in place of 1/r.
double term_corner(double x, double y, double b) {
  return x * std::asinh(y / std::hypot(x, b)) + y * std::asinh(x / std::hypot(y, b)) -
         b * std::atan(x * y / (b * std::sqrt(x * x + y * y + b * b)));
}

KernelSpectrum free_spectrum(const Grid& grid, const FilmedBodies& bodies) {
  const double scale = 1 / (M_PI * bodies.of_films);
  return spectrum_of_cells(grid, Parity::even, [&](double x, double y) {
    double sum = love_corner(x, y);
    for (const FilmTerm& term : bodies.terms) sum += term.share * term_corner(x, y, term.reach);
    return scale * sum;
  });
}

KernelSpectrum periodic_spectrum(const Grid& grid, double modulus, const std::vector<FilmOnBody>& films) {
  const int columns = grid.nx / 2 + 1, rows = grid.ny / 2 + 1;
  const double scale = 1 / static_cast<double>(grid.cells());
  Field spectrum(static_cast<std::size_t>(columns) * rows);
  for_parts(columns, 1, [&](int ix, int end) {
    for (; ix < end; ++ix)
      for (int iy = 0; iy < rows; ++iy) {
        const double q = 2 * M_PI * std::hypot(ix / (grid.nx * grid.dx), iy / (grid.ny * grid.dy));
        if (q == 0) continue;  // the mean is left out
        double compliance = 2 / (modulus * q);
        for (const FilmOnBody& film : films) compliance += film.compliance(q);
        spectrum[static_cast<std::size_t>(ix) * rows + iy] = scale * compliance;
      }
  });
  return {grid.nx, grid.ny, Parity::even, std::move(spectrum)};
}

/// Throws InputError where a half-space cannot have them.
KernelSpectrum checked_spectrum(const Grid& grid, Boundary boundary, double modulus,
                                const std::vector<FilmOnBody>& films) {
  if (grid.nx < 1 || grid.ny < 1 || !(grid.dx > 0) || !(grid.dy > 0) || !std::isfinite(grid.dx + grid.dy))
    throw InputError("a half-space needs a grid with cells of some size");
  const FilmedBodies bodies(modulus, films);
  if (boundary == Boundary::free) return free_spectrum(grid, bodies);
  if (grid.nx % 2 != 0 || grid.ny % 2 != 0)
    throw InputError("a half-space that repeats needs even numbers of cells");
  return periodic_spectrum(grid, modulus, films);
}

}  // namespace

Compliance::Compliance(const Grid& grid, Boundary boundary, double modulus,
                       const std::vector<FilmOnBody>& films)
    : boundary_(boundary),
      convolution_(grid, checked_spectrum(grid, boundary, modulus, films)),
      of_one_cell_(convolution_.spectrum().sum()) {}

}  // namespace asperity::half_space

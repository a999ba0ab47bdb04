#include "half_space/compliance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "core/quantity.h"
#include "core/shear_moduli.h"
#include "core/threads.h"

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

/// At the centres of cells, as the spectrum without films: of uniform pressures on cells on a free grid, of
/// waves on one that repeats.
void add_films(const Grid& grid, Boundary boundary, const std::vector<FilmOnBody>& films,
               KernelSpectrum& spectrum) {
  const int columns = spectrum.mx / 2 + 1, rows = spectrum.my / 2 + 1;
  const double scale = 1 / (static_cast<double>(spectrum.mx) * spectrum.my);
  const auto mean_over_cell = [boundary](double half) {
    return boundary == Boundary::free && half > 0 ? std::sin(half) / half : 1.0;
  };
  for_parts(columns, 1, [&](int ix, int end) {
    for (; ix < end; ++ix)
      for (int iy = 0; iy < rows; ++iy) {
        const double qx = 2 * M_PI * ix / (spectrum.mx * grid.dx),
                     qy = 2 * M_PI * iy / (spectrum.my * grid.dy);
        double sum = 0;
        for (const FilmOnBody& film : films) sum += film.compliance(std::hypot(qx, qy));
        spectrum.values[static_cast<std::size_t>(ix) * rows + iy] +=
            scale * sum * mean_over_cell(qx * grid.dx / 2) * mean_over_cell(qy * grid.dy / 2);
      }
  });
}

/// A film is felt some thicknesses away, and on a grid less wide than eight of them its images are: 2 % of
/// the force on one as wide as four (measured on a stiff film as thick as the contact radius).
void require_thin_films(const Grid& grid, const std::vector<FilmOnBody>& films) {
  constexpr double part = 1 / thicknesses_on_grid;
  for (const FilmOnBody& film : films)
    if (film.thickness > part * std::min(grid.nx * grid.dx, grid.ny * grid.dy))
      throw InputError(
          "half-spaces take films thinner than an eighth of their square, " +
          format_quantity(part * std::min(grid.nx * grid.dx, grid.ny * grid.dy), Dimension::length) +
          ", and one is " + format_quantity(film.thickness, Dimension::length) + " thick");
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

KernelSpectrum with_films(const Grid& grid, KernelSpectrum spectrum, Boundary boundary,
                          const std::vector<FilmOnBody>& films) {
  if (boundary == Boundary::free) require_thin_films(grid, films);
  const double of_mean = spectrum.values.front();
  if (!films.empty()) add_films(grid, boundary, films, spectrum);
  if (boundary == Boundary::periodic) spectrum.values.front() = of_mean;
  return spectrum;
}

}  // namespace

double FilmOnBody::compliance(double q) const {
  const double shear = shear_modulus(film), nu = film.poisson_ratio, ratio = shear / shear_modulus(body);
  const double below = (1 - body.poisson_ratio) / shear_modulus(body);
  // Towards longer waves it no longer changes, and is a small difference of large numbers.
  constexpr double long_wave = 1e-5;
  const double qt = std::max(q * thickness, long_wave), e = std::exp(-2 * qt);
  const double lambda = 1 - 4 * (1 - nu) / (1 + ratio * (3 - 4 * body.poisson_ratio)),
               k = (ratio - 1) / (ratio + 3 - 4 * nu);
  const double both = (1 - nu) / shear * (1 + 4 * qt * k * e - lambda * k * e * e) /
                      (1 - (lambda + k + 4 * k * qt * qt) * e + lambda * k * e * e);
  return (both - below) / (qt / thickness);
}

Compliance::Compliance(const Grid& grid, Boundary boundary, double modulus,
                       const std::vector<FilmOnBody>& films)
    : boundary_(boundary),
      convolution_(grid, with_films(grid, checked_spectrum(grid, boundary, modulus), boundary, films)),
      of_one_cell_(convolution_.spectrum().sum()) {}

}  // namespace asperity::half_space

#include "half_space/stuck_contact.h"

#include <cmath>
#include <utility>

#include "core/error.h"
#include "core/threads.h"

namespace asperity::half_space {
namespace {

/// Of whose second differences over the corners of a cell the integrals of 1/r, x^2/r^3 and x y/r^3 are made.
double along_x_corner(double x, double y, const ShearCompliance& c) {
  const double of_x = y * std::asinh(x / y), of_y = x * std::asinh(y / x);
  return (c.across * (of_x + of_y) + c.along * of_x) / (2 * M_PI);
}

const ShearCompliance& checked(const ShearCompliance& c) {
  if (!(c.across > 0) || !(c.along >= 0) || !std::isfinite(c.across + c.along))
    throw InputError("half-spaces that stick together need finite shear compliances above 0");
  return c;
}

KernelSpectrum even_spectrum(const Grid& grid, const ShearCompliance& c, bool along_x) {
  return spectrum_of_cells(grid, Parity::even, [c, along_x](double x, double y) {
    return along_x ? along_x_corner(x, y, c) : along_x_corner(y, x, c);
  });
}

}  // namespace

StuckContact::StuckContact(const Grid& grid, const ShearCompliance& compliance)
    : xx_(grid, even_spectrum(grid, checked(compliance), true)),
      yy_(grid, even_spectrum(grid, compliance, false)),
      xy_(grid, spectrum_of_cells(grid, Parity::odd, [c = compliance.along](double x, double y) {
            return -c * std::hypot(x, y) / (2 * M_PI);
          })) {}

void StuckContact::apply(const Shears& traction, Shears& shift) const {
  Field crossed;
  const auto add = [&](Field& to) {
    for_entries(static_cast<int>(to.size()), [&](int k) { to[k] += crossed[k]; });
  };
  xx_.apply(traction.x, shift.x);
  xy_.apply(traction.y, crossed);
  add(shift.x);
  yy_.apply(traction.y, shift.y);
  xy_.apply(traction.x, crossed);
  add(shift.y);
}

/// Tractions by which what touches has the given shifts: conjugate gradients, whose error in the work is the
/// square of the residual's.
Shears StuckContact::solve(const Field& pressure, const Shears& shift) const {
  constexpr int most = 1000;
  constexpr double enough = 1e-3;
  const std::size_t cells = pressure.size();
  Shears traction{Field(cells, 0.0), Field(cells, 0.0)}, residual = traction, direction, response;
  for (std::size_t k = 0; k < cells; ++k)
    if (pressure[k] > 0) residual.x[k] = shift.x[k], residual.y[k] = shift.y[k];
  direction = residual;
  const auto product = [&](const Shears& a, const Shears& b) {
    return sums_over<1>(cells,
                        [&](std::size_t k, auto& sum) { sum[0] += a.x[k] * b.x[k] + a.y[k] * b.y[k]; })[0];
  };
  double squares = product(residual, residual);
  const double first = squares;
  for (int n = 0; n < most && squares > enough * enough * first; ++n) {
    apply(direction, response);
    const double length = squares / product(direction, response);
    for_entries(static_cast<int>(cells), [&](int k) {
      if (!(pressure[k] > 0)) return;
      traction.x[k] += length * direction.x[k], traction.y[k] += length * direction.y[k];
      residual.x[k] -= length * response.x[k], residual.y[k] -= length * response.y[k];
    });
    const double before = std::exchange(squares, product(residual, residual));
    const double keep = squares / before;
    for_entries(static_cast<int>(cells), [&](int k) {
      direction.x[k] = residual.x[k] + keep * direction.x[k];
      direction.y[k] = residual.y[k] + keep * direction.y[k];
    });
  }
  return traction;
}

double StuckContact::lateral_stiffness(const Field& pressure) const {
  const std::size_t cells = pressure.size();
  const Shears traction = solve(pressure, {Field(cells, 1.0), Field(cells, 0.0)});
  return xx_.grid().cell_area() *
         sums_over<1>(cells, [&](std::size_t k, auto& sum) { sum[0] += traction.x[k]; })[0];
}

double StuckContact::torsion_stiffness(const Field& pressure) const {
  const Grid& grid = xx_.grid();
  Shears shift{Field(grid.cells()), Field(grid.cells())};
  for (int iy = 0; iy < grid.ny; ++iy)
    for (int ix = 0; ix < grid.nx; ++ix) {
      const std::size_t k = static_cast<std::size_t>(iy) * grid.nx + ix;
      shift.x[k] = -grid.y(iy), shift.y[k] = grid.x(ix);
    }
  const Shears traction = solve(pressure, shift);
  return grid.cell_area() * sums_over<1>(grid.cells(), [&](std::size_t k, auto& sum) {
           sum[0] += traction.x[k] * shift.x[k] + traction.y[k] * shift.y[k];
         })[0];
}

}  // namespace asperity::half_space

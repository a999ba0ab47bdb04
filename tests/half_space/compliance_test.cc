// Displacements of a half-space by pressures on cells, against closed forms.
#include "half_space/compliance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "tests/support/verification.h"

namespace asperity::half_space {
namespace {

using test::Largest;
using test::Verified;

constexpr double modulus = 50e9;

Field response_of(const Compliance& compliance, const Field& pressure) {
  Field displacement;
  compliance.apply(pressure, displacement);
  return displacement;
}

TEST(Compliance_analytic, a_square_under_uniform_pressure_sinks_in_its_centre_as_Love_has_it) {
  const double h = 3e-9;
  const Compliance compliance({30, 40, h, h}, Boundary::free, modulus);
  const Verified verified{"Half-space", "uniform pressure on a square: displacement of its centre",
                          "Love (1929): 4 ln(1 + sqrt 2) h p / (pi E*)"};
  const double expected = 4 * std::log(1 + std::sqrt(2.0)) * h / (M_PI * modulus);
  EXPECT_TRUE(verified.within(compliance.of_one_cell(), expected, 1e-10));
  Field pressure(1200, 0.0);
  pressure[17 * 30 + 11] = 1;
  EXPECT_NEAR(response_of(compliance, pressure)[17 * 30 + 11] / expected, 1, 1e-9);
}

TEST(Compliance_analytic, far_from_a_cell_the_surface_sinks_as_under_a_point_load) {
  // Up to the far corner of the grid: with images beyond its edges it would sink further.
  const int nx = 90, ny = 60;
  const double dx = 2e-9, dy = 3e-9;
  const Compliance compliance({nx, ny, dx, dy}, Boundary::free, modulus);
  Field pressure(nx * ny, 0.0);
  pressure[0] = 1e9;
  const Field sunk = response_of(compliance, pressure);
  Largest error;
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const double r = std::hypot(i * dx, j * dy);
      if (r > 20 * dy) error.count(sunk[j * nx + i] / (1e9 * dx * dy / (M_PI * modulus * r)) - 1);
    }
  EXPECT_TRUE((Verified{"Half-space", "pressure on a cell in a corner: displacements farther than 20 cells",
                        "Boussinesq (1885), point load"}
                   .below(error, 1e-3)));
}

TEST(Compliance_analytic, a_wave_of_pressure_makes_a_wave_of_displacement) {
  const int n = 48;
  const double h = 5e-9, q = 2 * M_PI * std::hypot(3, 2) / (n * h);
  const Compliance compliance({n, n, h, h}, Boundary::periodic, modulus);
  Field pressure(n * n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) pressure[j * n + i] = 5 + std::cos(2 * M_PI * (3 * i - 2 * j) / n);
  const Field sunk = response_of(compliance, pressure);
  Largest error;
  for (int k = 0; k < n * n; ++k) error.count(sunk[k] * modulus * q / 2 - (pressure[k] - 5));
  EXPECT_TRUE((Verified{"Half-space", "wave of pressure: displacement", "Johnson (1985), ch. 13"}.below(
      error, 1e-12)));
}

TEST(Compliance_analytic, displacements_are_the_sum_of_those_of_all_cells_and_work_is_mutual) {
  const Grid grid{14, 10, 1e-9, 2e-9};
  const Compliance compliance(grid, Boundary::free, modulus);
  Field sum(grid.cells(), 0.0), one(grid.cells()), other(grid.cells());
  for (std::size_t k = 0; k < grid.cells(); ++k) {
    one[k] = 1e9 * std::sin(1.0 + k * k), other[k] = 1e9 * std::cos(2.0 * k);
    Field single(grid.cells(), 0.0);
    single[k] = one[k];
    const Field sunk = response_of(compliance, single);
    for (std::size_t c = 0; c < grid.cells(); ++c) sum[c] += sunk[c];
  }
  const Field by_one = response_of(compliance, one), by_other = response_of(compliance, other);
  double there = 0, back = 0, size = 0;
  for (std::size_t k = 0; k < grid.cells(); ++k) {
    EXPECT_NEAR(by_one[k], sum[k], 1e-12 * std::abs(compliance.of_one_cell()) * 1e9 * 100);
    there += by_one[k] * other[k], back += by_other[k] * one[k], size += std::abs(by_one[k] * other[k]);
  }
  EXPECT_LT(std::abs(there - back), 1e-13 * size);
}

TEST(Compliance_behaviour, refuses_grids_and_moduli_that_cannot_be_meant) {
  const auto make = [](const Grid& grid, Boundary boundary, double e) {
    return Compliance(grid, boundary, e);
  };
  EXPECT_THROW(make({0, 4, 1, 1}, Boundary::free, 1), InputError);
  EXPECT_THROW(make({4, 4, 0, 1}, Boundary::free, 1), InputError);
  EXPECT_THROW(make({4, 4, NAN, 1}, Boundary::free, 1), InputError);
  EXPECT_THROW(make({4, 4, 1, 1}, Boundary::free, 0), InputError);
  EXPECT_THROW(make({4, 4, 1, 1}, Boundary::free, INFINITY), InputError);
  EXPECT_THROW(make({5, 4, 1, 1}, Boundary::periodic, 1), InputError);
  EXPECT_NO_THROW(make({5, 1, 1, 1}, Boundary::free, 1));
}

}  // namespace
}  // namespace asperity::half_space

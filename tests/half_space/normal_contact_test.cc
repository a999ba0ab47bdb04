// Contacts of half-spaces with known answers: a smooth sphere, a wavy surface, full plasticity.
#include "half_space/normal_contact.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/csv.h"
#include "core/error.h"
#include "core/hertz.h"
#include "core/hertz_separation.h"
#include "half_space/contact_shape.h"
#include "tests/support/shared_files.h"
#include "tests/support/verification.h"

namespace asperity::half_space {
namespace {

using test::Largest;
using test::Verified;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double E = 52.868e9, R = 8.5e-6, F = 100e-6;
const Hertz hertz{E, R};

NormalContact paraboloid(int n, double half_width) {
  const Grid grid = square_grid(half_width, n);
  Field gap(grid.cells());
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) gap[j * n + i] = (grid.x(i) * grid.x(i) + grid.y(j) * grid.y(j)) / (2 * R);
  return NormalContact(grid, Boundary::free, E, std::move(gap));
}

/// Errors of one number of cells, relative.
struct HertzErrors {
  double area, approach, largest_pressure, stiffness;
};

HertzErrors hertz_errors(int n) {
  const NormalContact contact = paraboloid(n, 1.3 * hertz.contact_radius(F));
  const auto solution = contact.at_force(F);
  const ContactShape shape = contact_shape(contact.grid(), solution.pressure, infinite);
  EXPECT_FALSE(shape.reaches_edge);
  EXPECT_EQ(shape.spots, 1);
  EXPECT_NEAR(shape.force / F, 1, 1e-12);
  EXPECT_NEAR(shape.centre_x / hertz.contact_radius(F), 0, 1e-6);
  return {shape.area / hertz.contact_area(F) - 1, solution.approach / hertz.approach(F) - 1,
          shape.largest_pressure / hertz.peak_pressure(F) - 1,
          contact.stiffness(solution) / hertz.normal_stiffness(F) - 1};
}

TEST(HalfSpaceHertz_analytic, errors_are_small_and_fall_with_the_spacing) {
  const auto verified = [](int n, const std::string& what) {
    return Verified{"Half-space", "smooth sphere, " + std::to_string(n) + " cells over 2.6 a: " + what,
                    "Hertz (1882)"};
  };
  const HertzErrors coarse = hertz_errors(64), fine = hertz_errors(128), finest = hertz_errors(512);
  EXPECT_TRUE(verified(64, "contact area").below(coarse.area, 0.01));
  EXPECT_TRUE(verified(128, "contact area").below(fine.area, 0.006));
  EXPECT_TRUE(verified(512, "contact area").below(finest.area, 0.001));
  EXPECT_TRUE(verified(64, "approach").below(coarse.approach, 5e-4));
  EXPECT_TRUE(verified(128, "approach").below(fine.approach, 1e-4));
  EXPECT_TRUE(verified(512, "approach").below(finest.approach, 2e-5));
  EXPECT_TRUE(verified(64, "largest pressure").below(coarse.largest_pressure, 4e-3));
  EXPECT_TRUE(verified(128, "largest pressure").below(fine.largest_pressure, 1e-3));
  EXPECT_TRUE(verified(512, "largest pressure").below(finest.largest_pressure, 1e-4));
  EXPECT_TRUE(verified(128, "stiffness").below(fine.stiffness, 0.01));
  EXPECT_TRUE(verified(512, "stiffness").below(finest.stiffness, 0.002));
  EXPECT_TRUE(verified(512, "error of the approach over that of 64")
                  .below(finest.approach / coarse.approach, 1.0 / 8));
}

TEST(HalfSpaceHertz_analytic, a_given_approach_has_the_force_that_has_it) {
  const NormalContact contact = paraboloid(128, 1.3 * hertz.contact_radius(F));
  const auto solution = contact.at_approach(hertz.approach(F));
  EXPECT_TRUE(
      (Verified{"Half-space", "smooth sphere, 128 cells over 2.6 a, given approach: force", "Hertz (1882)"}
           .within(solution.force, F, 2e-4)));
  const auto by_force = contact.at_force(solution.force);
  EXPECT_NEAR(by_force.approach / hertz.approach(F), 1, 1e-5);
}

TEST(HalfSpaceHertz_analytic, stiffness_is_the_change_of_force_with_approach) {
  const NormalContact contact = paraboloid(256, 1.3 * hertz.contact_radius(F));
  const auto at = contact.at_force(F);
  constexpr double share = 0.02;
  const double chord =
      2 * share * F /
      (contact.at_force((1 + share) * F).approach - contact.at_force((1 - share) * F).approach);
  EXPECT_NEAR(contact.stiffness(at) / chord, 1, 0.01);
}

TEST(HalfSpaceHertz_analytic, pressure_and_gap_follow_the_closed_forms_and_exclude_each_other) {
  const double a = hertz.contact_radius(F), p0 = hertz.peak_pressure(F);
  const NormalContact contact = paraboloid(256, 1.3 * a);
  const auto solution = contact.at_force(F);
  const Grid& grid = contact.grid();
  Largest pressure, gap;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const double r = std::hypot(grid.x(i), grid.y(j));
      const double p = solution.pressure[j * grid.nx + i], g = solution.gap[j * grid.nx + i];
      EXPECT_GE(p, 0);
      if (r < 0.97 * a) pressure.count(p / p0 - std::sqrt(1 - r * r / (a * a)));
      if (r > 1.03 * a) gap.count((g - hertz_separation(r, a, R)) / hertz.approach(F));
    }
  EXPECT_LE(solution.error, 1e-6);
  EXPECT_TRUE(
      (Verified{"Half-space", "smooth sphere, 256 cells over 2.6 a: pressure up to 0.97 a, of the largest",
                "Hertz (1882)"}
           .below(pressure, 0.01)));
  EXPECT_TRUE((Verified{"Half-space", "the same: separation from 1.03 a on, of the approach",
                        "Johnson (1985), eq. 3.42a"}
                   .below(gap, 1e-3)));
}

TEST(HalfSpaceWestergaard_analytic, a_wavy_surface_flattens_as_in_closed_form) {
  // A wave along x on a grid that repeats; across it four cells are as good as any number.
  const CsvTable table = read_csv(test::reference_table("08_fe_table_westergaard.csv"));
  const auto loads = table.numbers("p/p*"), fractions = table.numbers("contact_fraction_exact"),
             gaps = table.numbers("mean_gap/D_exact"), peaks = table.numbers("peak_pressure/p*=2sqrt(p/p*)");
  constexpr int n = 1024;
  constexpr double length = 1e-6, D = 1e-9, full = M_PI * E * D / length;
  const Grid grid{n, 4, length / n, length / n};
  Field gap(grid.cells());
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < n; ++i) gap[j * n + i] = D * (1 - std::cos(2 * M_PI * (i - n / 2) / n));
  const NormalContact contact(grid, Boundary::periodic, E, gap);
  Largest fraction, mean_gap, peak;
  for (std::size_t k = 0; k < loads.size(); ++k) {
    const double area = length * 4 * grid.dy;
    const auto solution = contact.at_force(loads[k] * full * area);
    const ContactShape shape = contact_shape(grid, solution.pressure, infinite);
    double sum = 0;
    for (const double g : solution.gap) sum += g;
    fraction.count(shape.area_of_cells / area - fractions[k]);
    mean_gap.count(sum / static_cast<double>(grid.cells()) / D - gaps[k]);
    peak.count(shape.largest_pressure / full / peaks[k] - 1);
  }
  const auto verified = [](const std::string& what) {
    return Verified{"Half-space", "wavy surface, 1024 cells, 1 to 95 % of the load that flattens it: " + what,
                    "Westergaard (1939); Johnson (1985), ch. 13"};
  };
  EXPECT_TRUE(verified("closed width").below(fraction * n, 2.0, "cells"));
  EXPECT_TRUE(verified("mean gap, of the amplitude").below(mean_gap, 1e-4));
  EXPECT_TRUE(verified("largest pressure").below(peak, 1e-4));
}

TEST(HalfSpaceHardness_analytic, a_fully_plastic_contact_has_the_area_of_load_over_hardness) {
  // Two hundred times softer than what Hertz' pressure needs: nothing but the bearing area is left.
  const double H = hertz.peak_pressure(F) / 200, width = 1.5 * std::sqrt(F / H / M_PI);
  const NormalContact contact = paraboloid(256, width);
  NormalContactOptions options;
  options.hardness = H;
  const auto solution = contact.at_force(F, options);
  const ContactShape shape = contact_shape(contact.grid(), solution.pressure, H);
  EXPECT_FALSE(shape.reaches_edge);
  EXPECT_NEAR(shape.force / F, 1, 1e-9);
  EXPECT_EQ(shape.largest_pressure, H);
  EXPECT_TRUE(
      (Verified{"Half-space", "sphere 200 times softer than Hertz' pressure: area", "force over hardness"}
           .within(shape.area_of_cells, F / H, 0.005)));
  EXPECT_TRUE((Verified{"Half-space", "the same: approach", "geometric overlap, area / (2 pi R)"}.within(
      solution.approach, F / H / (2 * M_PI * R), 0.03)));
}

TEST(HalfSpaceHardness_behaviour, a_hardness_caps_pressures_and_widens_the_contact) {
  const double p0 = hertz.peak_pressure(F);
  const NormalContact contact = paraboloid(128, 1.5 * hertz.contact_radius(F));
  const auto area_at = [&](double hardness) {
    NormalContactOptions options;
    options.hardness = hardness;
    options.tolerance = 1e-9;
    const auto solution = contact.at_force(F, options);
    const ContactShape shape = contact_shape(contact.grid(), solution.pressure, hardness);
    EXPECT_LE(shape.largest_pressure, hardness);
    EXPECT_NEAR(shape.force / F, 1, 1e-9);
    for (std::size_t k = 0; k < solution.pressure.size(); ++k)
      if (solution.gap[k] < -1e-4 * hertz.approach(F)) {
        EXPECT_EQ(solution.pressure[k], hardness);
      }
    return shape.area_of_cells;
  };
  const double elastic = area_at(infinite), above = area_at(1.01 * p0), half = area_at(0.6 * p0),
               softer = area_at(0.4 * p0);
  EXPECT_NEAR(above / elastic, 1, 1e-3);
  EXPECT_GT(half, 1.02 * elastic);
  EXPECT_GT(softer, 1.1 * half);
}

TEST(HalfSpaceContact_behaviour, does_not_depend_on_the_number_of_threads) {
  const NormalContact contact = paraboloid(160, 1.3 * hertz.contact_radius(F));
  const auto on_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return contact.at_force(F);
  };
  const auto alone = on_threads(1), together = on_threads(3);
  EXPECT_EQ(alone.pressure, together.pressure);
  EXPECT_EQ(alone.approach, together.approach);
}

TEST(HalfSpaceContact_behaviour, refuses_what_cannot_be_meant) {
  const double a = hertz.contact_radius(F);
  const NormalContact contact = paraboloid(64, 1.3 * a);
  NormalContactOptions soft;
  soft.hardness = F / (10 * a * a);
  EXPECT_THROW(contact.at_force(0), InputError);
  EXPECT_THROW(contact.at_force(-F), InputError);
  EXPECT_THROW(contact.at_force(NAN), InputError);
  EXPECT_THROW(contact.at_force(infinite), InputError);
  EXPECT_THROW(contact.at_force(F, soft), InputError);
  soft.hardness = 0;
  EXPECT_THROW(contact.at_force(F, soft), InputError);
  EXPECT_THROW(contact.at_approach(-1e-9), InputError);
  EXPECT_THROW(contact.at_approach(NAN), InputError);
  const Grid grid = square_grid(a, 8);
  EXPECT_THROW(NormalContact(grid, Boundary::free, E, Field(63, 0.0)), InputError);
  EXPECT_THROW(NormalContact(grid, Boundary::free, E, Field(64, NAN)), InputError);
  NormalContactOptions hasty;
  hasty.most_iterations = 1;
  EXPECT_THROW(contact.at_force(F, hasty), WorkError);
}

TEST(HalfSpaceContact_behaviour, says_where_the_grid_is_too_small) {
  const NormalContact contact = paraboloid(64, 0.8 * hertz.contact_radius(F));
  const auto solution = contact.at_force(F);
  EXPECT_TRUE(contact_shape(contact.grid(), solution.pressure, infinite).reaches_edge);
}

TEST(ContactShape_analytic, counts_spots_sides_and_bounds) {
  const Grid grid{6, 5, 2e-9, 1e-9};
  // A bar of three cells, a cell that touches it by a corner, and one on the edge.
  Field pressure(30, 0.0);
  for (const int cell : {7, 8, 9, 16}) pressure[cell] = 1e9;
  pressure[29] = 4e9;
  const ContactShape shape = contact_shape(grid, pressure, 4e9);
  EXPECT_EQ(shape.spots, 3);
  EXPECT_TRUE(shape.reaches_edge);
  EXPECT_DOUBLE_EQ(shape.area_of_cells, 5 * 2e-18);
  EXPECT_DOUBLE_EQ(shape.area_at_bound, 2e-18);
  // The cell on the edge of the grid is at the bound.
  EXPECT_NEAR(shape.area, (5 - (M_PI - 1 + std::log(2.0)) / 24 * 12) * 2e-18, 1e-30);
  EXPECT_DOUBLE_EQ(shape.perimeter, (2 * (3 * 2 + 1) + 2 * (2 + 1) + (2 + 1)) * 1e-9);
  EXPECT_DOUBLE_EQ(shape.force, 8e9 * 2e-18);
  EXPECT_DOUBLE_EQ(shape.largest_pressure, 4e9);
  EXPECT_NEAR(shape.centre_x, (-3 - 1 + 1 + 3 + 4 * 5) / 8.0 * 1e-9, 1e-22);
  EXPECT_NEAR(shape.centre_y, (3 * -1 + 0 + 4 * 2) / 8.0 * 1e-9, 1e-22);
  EXPECT_DOUBLE_EQ(shape.reach, 6e-9);
}

}  // namespace
}  // namespace asperity::half_space

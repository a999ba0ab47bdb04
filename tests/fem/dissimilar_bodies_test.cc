// Friction in the normal contact of bodies that differ (Spence 1968, 1975): the softer one is held back from
// spreading.
#include <gtest/gtest.h>

#include <cstdio>

#include "core/csv.h"
#include "tests/fem/support/frictional_contact.h"
#include "tests/support/shared_files.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity;

struct Spence {
  double friction, stick_radius, radius, approach,
      peak;  ///< stick radius over contact radius; the others over Hertz' at the same load
};

Spence reference(const std::filesystem::path& path, const std::string& pair, double stick_radius) {
  const auto table = read_csv(path);
  const auto number = [&](const std::vector<std::string>& row, const std::string& name) {
    return std::stod(row[table.column(name)]);
  };
  for (const auto& row : table.rows)
    if (row[0] == pair && std::abs(number(row, "c_over_a") - stick_radius) < 1e-9)
      return {number(row, "mu_coupled_own"), stick_radius, number(row, "a/a_Hertz_same_P"),
              number(row, "delta/delta_Hertz_same_P"), number(row, "p(0)/p0_Hertz_same_P")};
  throw std::runtime_error("no such pair in " + path.string());
}

/// Borosilicate on diamond, pressed in steps: the contact stays similar to itself.
void expect_spence(const Spence& expected) {
  test::FrictionalContactOptions o;
  o.youngs[1] = 1140e9, o.poisson[1] = 0.07;
  o.friction = expected.friction, o.loaded = false;
  o.cells_per_radius = 16;
  test::FrictionalContact c(o);
  const double a = c.contact_radius, h = a / o.cells_per_radius, p0 = 1.5 * o.load / (M_PI * a * a);
  const double far_field = c.solver.far_field_compliance(0.9 * a);
  fem::ContactResultants r;
  constexpr int steps = 10;
  for (int k = 2; k <= steps; ++k) r = c.step({}, o.load * std::pow(k / static_cast<double>(steps), 1.5));
  // The largest: p0 (1 - r^2 / a^2)^(1/2) is flat in the middle, where one node's place in the lattice does
  // not matter.
  double peak = 0;
  int misplaced = 0;
  const double contact = expected.radius * a, stick = expected.stick_radius * contact;
  for (std::size_t k = 0; k < c.state.multiplier.size(); ++k) {
    const double p = c.state.multiplier[k];
    if (p == 0) continue;
    const auto& x = c.system.interface_points()[c.system.rows()[k].node];
    const double radius = std::hypot(x[0], x[1]);
    peak = std::max(peak, p);
    if (radius > contact - 0.5 * h) continue;
    const bool slips = std::hypot(c.state.shear[0][k], c.state.shear[1][k]) > 0.995 * o.friction * p;
    misplaced += (radius < stick - 1.5 * h && slips) || (radius > stick + 1.5 * h && !slips);
  }
  const double radius = std::sqrt(r.area / M_PI) / a,
               approach = (c.state.approach - far_field * r.force) * o.radius / (a * a);
  std::printf("stick radius %.1f: peak %.4f (%.4f), radius %.4f (%.4f), approach %.4f (%.4f), %d misplaced\n",
              expected.stick_radius, peak / p0, expected.peak, radius, expected.radius, approach,
              expected.approach, misplaced);
  char place[96] = "borosilicate on diamond without friction, a/h 16: ";
  if (expected.friction > 0)
    std::snprintf(place, sizeof place,
                  "borosilicate on diamond, stick radius %.1f a, a/h 16: ", expected.stick_radius);
  const auto verified = [&](const std::string& what) {
    return test::Verified{"Sliding", place + what,
                          expected.friction > 0 ? "Spence (1975), integral equation solved" : "Hertz (1882)"};
  };
  EXPECT_TRUE(verified("largest pressure").within(peak / p0, expected.peak, 0.02));
  EXPECT_TRUE(verified("contact radius").below((radius - expected.radius) * o.cells_per_radius, 0.5, "h"));
  EXPECT_TRUE(verified("approach").within(approach, expected.approach, 0.01));
  EXPECT_TRUE(verified("nodes more than 1.5 spacings on the wrong side of sticking").below(misplaced, 0));
}

TEST(DissimilarBodies_other_code, friction_raises_the_peak_pressure_and_leaves_a_core_that_sticks) {
  const auto path = asperity::test::reference_table("01_hertz_table_spence.csv");
  expect_spence(reference(path, "borosilicate/diamond", 0.5));
}

TEST(DissimilarBodiesNightly_other_code, with_more_friction_a_larger_core_sticks) {
  const auto path = asperity::test::reference_table("01_hertz_table_spence.csv");
  expect_spence(reference(path, "borosilicate/diamond", 0.8));
}

TEST(DissimilarBodies_analytic, without_friction_Hertz_holds) { expect_spence({0, 1, 1, 1, 1}); }

}  // namespace

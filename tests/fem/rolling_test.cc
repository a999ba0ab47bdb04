// A smooth elastic sphere that rolls on a smooth block.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/csv.h"
#include "fem/output/steady_motion.h"
#include "tests/fem/support/frictional_contact.h"
#include "tests/support/shared_files.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity;
using test::FrictionalContact;
using test::FrictionalContactOptions;

const char* const of_load_times_radius = "of load times contact radius";

/// Largest and mean moment over load and contact radius, over a contact radius of path length.
std::array<double, 2> frictionless_moment(double cells) {
  FrictionalContactOptions o;
  o.friction = 0;
  o.cells_per_radius = cells;
  o.path_length = 2 * 260e-9;
  FrictionalContact contact(o);
  const double a = contact.contact_radius, h = a / o.cells_per_radius, unit = o.load * a;
  double largest = 0, sum = 0;
  int steps = 0;
  for (double x = 0; x < a; x += 0.37 * h) {  // meets the nodes of both bodies in all positions
    const auto r = contact.roll(x / o.radius);
    largest = std::max(largest, std::abs(r.rolling_moment) / unit);
    sum += r.rolling_moment / unit;
    ++steps;
    EXPECT_NEAR(r.force, o.load, 1e-5 * o.load);
    EXPECT_NEAR(r.reaction_driven, r.force, 1e-6 * r.force);
    EXPECT_NEAR(r.reaction_fixed, r.force, 1e-6 * r.force);
  }
  std::printf("%g cells: moment over load and contact radius: largest %.1e, mean %.1e\n", cells, largest,
              sum / steps);
  return {largest, sum / steps};
}

void expect_no_resistance(double cells) {
  const auto [largest, mean] = frictionless_moment(cells);
  const auto verified = [&](const std::string& what) {
    return test::Verified{
        "Rolling",
        "smooth elastic sphere without friction, a/h " + std::to_string(std::lround(cells)) + ": " + what,
        "none"};
  };
  EXPECT_TRUE(verified("largest moment over a contact radius")
                  .below(largest, fem::rolling_noise, of_load_times_radius));
  EXPECT_TRUE(verified("mean moment").below(mean, 0.1 * fem::rolling_noise, of_load_times_radius));
}

TEST(Rolling_analytic, a_smooth_elastic_sphere_without_friction_meets_no_resistance) {
  for (const double cells : {6.0, 8.0}) expect_no_resistance(cells);
}

TEST(RollingNightly_analytic, nor_does_it_on_a_finer_mesh) { expect_no_resistance(12); }

/// Six contact radii of a small sphere are a fifth of a radian to both sides. There a load leans on a
/// hemisphere that is held at its equator, which is a little more compliant: a moment that is given back on
/// the other side, and no resistance.
TEST(Rolling_analytic, nor_does_a_small_sphere_that_rolls_far) {
  FrictionalContactOptions o;
  o.radius = 2.5e-6;
  o.friction = 0;
  o.cells_per_radius = 8;
  constexpr double far = 0.185;
  o.path_length = 2 * far * o.radius;
  FrictionalContact contact(o);
  const double a = contact.contact_radius, h = a / o.cells_per_radius, unit = o.load * a;
  const auto mean_moment = [&](double side) {
    constexpr int steps = 6;
    double sum = 0;
    for (int i = 0; i < steps; ++i)
      sum += contact.roll(side * (far - 0.37 * i * h / o.radius)).rolling_moment / unit / steps;
    return sum;
  };
  const double before = mean_moment(-1), after = mean_moment(1);
  std::printf("moment over load and contact radius: %.1e and %.1e, mean of both sides %.1e\n", before, after,
              (before + after) / 2);
  const auto verified = [](const std::string& what) {
    return test::Verified{"Rolling", "R 2.5 um at -0.185 and 0.185 rad, a/h 8: " + what, "none"};
  };
  EXPECT_TRUE(verified("mean of both moments")
                  .below((before + after) / 2, 0.2 * fem::rolling_noise, of_load_times_radius));
  EXPECT_TRUE(verified("larger of both moments")
                  .below(std::max(std::abs(before), std::abs(after)), 3e-3, of_load_times_radius));
}

struct Creep {
  double along = 0, across = 0;  ///< by which the particle leads pure rolling, per length rolled
  double spin = 0;               ///< per length rolled, times the contact radius
};
/// Forces over G a^2, moment over G a^3.
struct Reaction {
  double x, y, torsion;
};

FrictionalContactOptions rolling_contact(double friction) {
  FrictionalContactOptions o;
  // a/R = 0.01: the distance rolled per angle differs from R by a quarter of (a/R)^2, which would be a creep
  // of its own.
  o.load = 100e-6 / 27;
  o.friction = friction;
  o.cells_per_radius = 8;
  return o;
}

/// Shear at the end of a path of 3.5 contact radii, started from `guess`, which the transient forgets over
/// about a radius.
Reaction steady_reaction(FrictionalContactOptions o, const Creep& creep, const Reaction& guess) {
  const double nu = o.poisson[0], G = o.youngs[0] / (2 * (1 + nu)), R = o.radius;
  const double a = std::cbrt(3 * o.load * R * (1 - nu * nu) / (2 * o.youngs[0])), h = a / o.cells_per_radius,
               path_length = 3.5 * a;
  o.path_length = 2 * path_length;
  FrictionalContact contact(o);
  fem::RigidMotion start;
  start.x = guess.x * (2 - nu) / 4 * a, start.y = guess.y * (2 - nu) / 4 * a,
  start.spin = guess.torsion * 3 / 8;
  contact.step(start);
  Reaction reaction{};
  for (double x = h; x < path_length * (1 + 1e-9); x += h) {
    fem::RigidMotion m = start;
    // Along the direction in which it heads: the axis that it rolls about turns with it.
    const double turn = x / a * creep.spin, heading = start.spin + 0.5 * turn,
                 chord = turn == 0 ? x : 2 * std::sin(0.5 * turn) * a / creep.spin;
    m.roll = x / R, m.spin += turn;
    m.x += chord * std::cos(heading) + x * creep.along, m.y += chord * std::sin(heading) + x * creep.across;
    const auto r = contact.step(m);
    reaction = {r.lateral_force[0] / (G * a * a), r.lateral_force[1] / (G * a * a),
                r.torsion_moment / (G * a * a * a)};
  }
  return reaction;
}

/// Small enough for full stick (G a^2 creep = 0.02 mu P), and large where the distance rolled per angle,
/// which differs from the radius by 3e-5 of it, would count: along x, where friction has to be larger for
/// that; a spin makes the rim slip first.
constexpr double small = 1e-3, small_along = 5e-3, friction = 3, friction_along = 15, friction_spin = 6;

/// Coefficient of a circular contact at nu = 0.17.
double kalker(const std::filesystem::path& path, const std::string& column) {
  const auto table = read_csv(path);
  const auto nu = table.numbers("nu");
  return table.numbers(column)[std::find(nu.begin(), nu.end(), 0.17) - nu.begin()];
}

double reference_value(const std::filesystem::path& path, const std::string& id) {
  const auto table = read_csv(path);
  for (const auto& row : table.rows)
    if (row[table.column("id")] == id) return std::stod(row[table.column("value")]);
  throw std::runtime_error("no " + id + " in " + path.string());
}

test::Verified kalkers(const char* what) { return {"Rolling", what, "Kalker (1990), boundary elements"}; }

TEST(RollingNightly_other_code, longitudinal_creep_meets_Kalkers_C11) {
  const auto path = asperity::test::reference_table("05_rolling_table_kalker_circle.csv");
  const double c11 = kalker(path, "C11_own");
  const auto r =
      steady_reaction(rolling_contact(friction_along), {small_along, 0, 0}, {c11 * small_along, 0, 0});
  EXPECT_TRUE(kalkers("C11, longitudinal creep, a/h 8").within(r.x / small_along, c11, 0.05));
}

TEST(RollingNightly_other_code, lateral_creep_meets_Kalkers_C22) {
  const auto path = asperity::test::reference_table("05_rolling_table_kalker_circle.csv");
  const double c22 = kalker(path, "C22_own");
  const auto r = steady_reaction(rolling_contact(friction), {0, small, 0}, {0, c22 * small, 0});
  EXPECT_TRUE(kalkers("C22, lateral creep, a/h 8").within(r.y / small, c22, 0.05));
}

TEST(RollingNightly_other_code, spin_creep_meets_Kalkers_C23_and_C33) {
  const auto path = asperity::test::reference_table("05_rolling_table_kalker_circle.csv");
  const double c23 = kalker(path, "C23_own"), c33 = kalker(path, "C33_own");
  const auto r =
      steady_reaction(rolling_contact(friction_spin), {0, 0, small}, {0, c23 * small, c33 * small});
  EXPECT_TRUE(kalkers("C23, force of spin creep, a/h 8").within(r.y / small, c23, 0.05));
  EXPECT_TRUE(kalkers("C33, moment of spin creep, a/h 8").within(r.torsion / small, c33, 0.05));
}

TEST(RollingNightly_other_code, creep_force_with_partial_slip) {
  // At G a^2 xi / (mu P) = 0.2 and nu = 0.17, Q / (mu P) = 0.6013 (boundary elements, extrapolated).
  const auto path = asperity::test::reference_table("05_rolling.csv");
  const double expected = reference_value(path, "R-creep-longitudinal-0.17-0.2");
  FrictionalContactOptions o = rolling_contact(0);
  const double nu = o.poisson[0], G = o.youngs[0] / (2 * (1 + nu)),
               a = std::cbrt(3 * o.load * o.radius * (1 - nu * nu) / (2 * o.youngs[0]));
  o.friction = G * a * a * small_along / (0.2 * o.load);
  const double unit = o.friction * o.load / (G * a * a);
  const auto r = steady_reaction(o, {small_along, 0, 0}, {0.6 * unit, 0, 0});
  EXPECT_TRUE(kalkers("force of longitudinal creep with partial slip, circular contact, a/h 8")
                  .within(r.x / unit, expected, 0.05));
}

}  // namespace

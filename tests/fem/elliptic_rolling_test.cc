// A smooth elastic body with two radii that rolls with longitudinal creep: CONTACT's wheel, and towards
// Carter's cylinder.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

#include "tests/fem/support/frictional_contact.h"
#include "tests/support/shared_files.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity;
using test::FrictionalContact;
using test::FrictionalContactOptions;

struct CreepForce {
  double creep, force;  ///< force over friction times load
};

/// The first series of CONTACT's curve: Coulomb friction, 0.33, G 82 GPa, nu 0.28, a/b 0.5.
std::vector<CreepForce> contact_series(const std::filesystem::path& path, std::size_t points) {
  std::vector<CreepForce> series;
  std::ifstream stream(path);
  double creep = 0;
  for (std::string line; series.size() < points && std::getline(stream, line);) {
    const bool creeps = line.find("VELOC       CKSI") != std::string::npos,
               forces = line.find("FX/FSTAT/FN") != std::string::npos;
    if (!creeps && !forces) continue;
    std::getline(stream, line);
    std::istringstream numbers(line);
    double first, second, third;
    numbers >> first >> second >> third;
    if (creeps)
      numbers >> creep;
    else
      series.push_back({creep, -second});
  }
  return series;
}

/// Rolled over `path_length` contact lengths with the shift lagging by `creep`, from a first shift that makes
/// `guess` of mu P.
fem::ContactResultants roll_steadily(FrictionalContact& c, double creep, double guess, double path_length) {
  const double a = c.contact_radius, h = a / c.options.cells_per_radius, R = c.options.radius;
  const double mean = a * std::sqrt(c.options.semi_axis_across);
  fem::RigidMotion motion;
  motion.x =
      guess * c.friction_force * (1 / (8 * c.system.reduced_shear_modulus() * mean) + c.lateral_far_field);
  auto r = c.step(motion);
  for (double x = h; x < path_length * a * (1 + 1e-9); x += h) {
    motion.roll = x / R, motion.x += h * (1 + creep);
    r = c.step(motion);
  }
  return r;
}

FrictionalContactOptions elliptic(double ratio, double friction, double poisson, double force_over_g_ab) {
  FrictionalContactOptions o;
  o.poisson[0] = o.poisson[1] = poisson;
  o.semi_axis_across = ratio;
  o.friction = friction;
  o.cells_per_radius = 8;
  // The load at which P / (G a b) is that of the other code, hence a/R too: a^3 is proportional to the load.
  const double G = o.youngs[0] / (2 * (1 + poisson)), E = o.youngs[0] / (2 * (1 - poisson * poisson));
  const double k = 3 * o.radius * test::HertzEllipse(ratio).shape / (M_PI * E * ratio);  // a^3 = k P
  o.load = std::pow(force_over_g_ab * G * ratio, 3) * k * k;
  return o;
}

void expect_creep_force(const CreepForce& point, double cells) {
  // CONTACT's case: P / G = 1.301 mm^2, a = 6.304 mm, b = 12.61 mm.
  auto o = elliptic(2, 0.33, 0.28, 1.301 / (6.304 * 12.61));
  const double a_over_R = 6.304 / 625;
  o.cells_per_radius = cells;
  o.path_length = 2 * 2.2 * a_over_R * o.radius;  // the fine region is square, as wide as the contact
  FrictionalContact c(o);
  EXPECT_NEAR(c.contact_radius / o.radius, a_over_R, 0.002 * a_over_R);
  const auto r = roll_steadily(c, point.creep, point.force, 3.5);
  char what[96];
  std::snprintf(what, sizeof what, "wheel, a/b 0.5: creep force at %.2f mu P, a/h %g", point.force, cells);
  EXPECT_TRUE((test::Verified{"Rolling", what, "CONTACT"}.within(r.lateral_force[0] / c.friction_force,
                                                                 point.force, 0.05)));
}

TEST(EllipticRolling_other_code, creep_force_of_a_wheel_meets_CONTACT) {
  ASPERITY_SHARED_FILE_OR_SKIP(path, "contact_references/tractcurv.ref_out");
  const auto series = contact_series(path, 8);
  ASSERT_EQ(series.size(), 8u);
  expect_creep_force(series[3], 5);
}

TEST(EllipticRollingNightly_other_code, creep_force_curve_of_a_wheel_meets_CONTACT) {
  ASPERITY_SHARED_FILE_OR_SKIP(path, "contact_references/tractcurv.ref_out");
  for (const auto& point : contact_series(path, 8))
    if (point.creep > 1e-4) expect_creep_force(point, 6);
}

/// Traction of a steadily rolling cylinder over friction times its largest pressure, by place over half the
/// contact's width, from behind to the front: CONTACT's example of Carter's problem at a creep of 0.4.
std::vector<std::pair<double, double>> contact_profile(const std::filesystem::path& path) {
  constexpr double load_per_width = 35780.0 / 200, friction = 0.3,
                   largest = friction * 2 * load_per_width / M_PI;  // N/mm, a = 1 mm
  std::vector<std::pair<double, double>> profile;
  std::ifstream stream(path);
  bool reads = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.find("after expanding slip-area") != std::string::npos) {
      reads = true, profile.clear();
      std::getline(stream, line);  // names of the columns
      continue;
    }
    for (char& c : line)
      if (c == ',') c = ' ';
    std::istringstream numbers(line);
    double ix, iy, index, state, traction;
    if (reads && numbers >> ix >> iy >> index >> state >> traction)
      profile.emplace_back(-1.05 + 0.04 * (ix - 1), traction / largest);
    else
      reads = false;
  }
  return profile;
}

/// The middle strip of a contact four times as wide as long. Carter (1926), Proc. R. Soc. A 112, 151; Johnson
/// (1985), eq. 8.31: force per width over mu P' is 1 - (1 - creep / (mu a/R))^2, where a/R = 2 p0 / E*.
/// `profile`: tractions to compare with, or none.
void expect_carter(double share, const std::vector<std::pair<double, double>>& profile) {
  auto o = elliptic(4, 0.3, 0.28, 0.005);
  FrictionalContact c(o);
  const double a = c.contact_radius, h = a / o.cells_per_radius, p0 = 1.5 * o.load / (M_PI * a * a * 4);
  const double unit = o.friction * 2 * p0 / c.reduced_modulus;
  const double expected = 1 - (1 - share) * (1 - share);
  roll_steadily(c, share * unit, expected, 3);
  double shear = 0, pressure = 0;
  std::map<long, std::array<double, 3>> columns;  // place, shear and area of nodes in a row across
  for (std::size_t k = 0; k < c.state.multiplier.size(); ++k) {
    const auto& x = c.system.interface_points()[c.system.rows()[k].node];
    if (std::abs(x[1]) > 2.5 * h) continue;
    const double area = c.system.areas()[k];
    shear -= c.state.shear[0][k] * area, pressure += c.state.multiplier[k] * area;
    auto& column = columns[std::lround(x[0] / h * 16)];
    column[0] += x[0] * area, column[1] -= c.state.shear[0][k] * area, column[2] += area;
  }
  char what[96];
  std::snprintf(what, sizeof what, "middle strip of a contact four times as wide as long: force at %.2f mu P",
                expected);
  EXPECT_TRUE((test::Verified{"Rolling", what, "Carter (1926)"}.within(shear / (o.friction * pressure),
                                                                       expected, 0.05)));
  if (profile.empty()) return;
  // The contact has rolled on: its middle is where the pressure's is.
  const double middle = c.state.motion.x - (c.state.motion.x - c.options.radius * c.state.motion.roll);
  double difference = 0, size = 0;
  for (const auto& [x, traction] : profile) {
    double near = 0, far = 0, weight = 0;
    for (const auto& [key, column] : columns) {
      const double place = (column[0] / column[2] - middle) / a, distance = std::abs(place - x) * a / h;
      if (distance >= 1) continue;
      near += (1 - distance) * column[1] / column[2], weight += 1 - distance;
    }
    far = weight > 0 ? near / weight / (o.friction * p0) : 0;
    difference += (far - traction) * (far - traction), size += traction * traction;
  }
  const test::Verified tractions{"Rolling",
                                 "the same strip at 0.64 mu P: tractions along it, 50 elements, 2-norm",
                                 "CONTACT's cylinder"};
  EXPECT_TRUE(tractions.below(100 * std::sqrt(difference / size), 8, "%"));
}

TEST(EllipticRollingNightly_analytic, the_middle_of_a_wide_contact_follows_Carter) {
  for (const double share : {0.15, 0.7}) expect_carter(share, {});
}

TEST(EllipticRollingNightly_other_code,
     tractions_in_the_middle_of_a_wide_contact_meet_those_of_CONTACTs_cylinder) {
  ASPERITY_SHARED_FILE_OR_SKIP(path, "contact_references/carter2d.ref_out");
  const auto profile = contact_profile(path);
  ASSERT_EQ(profile.size(), 50u);
  expect_carter(0.4, profile);
}

}  // namespace

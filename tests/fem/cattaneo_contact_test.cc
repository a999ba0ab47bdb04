// A ball shifted on a plane by seven eighths of full friction: CONTACT's example (Kalker 1990, sec. 5.2.1.1;
// eve70a/CONTACT), with the traction across the shift that Cattaneo's solution leaves out.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <vector>

#include "tests/fem/support/frictional_contact.h"
#include "tests/support/shared_files.h"
#include "tests/support/verification.h"

namespace {

using asperity::test::FrictionalContact;
using asperity::test::FrictionalContactOptions;

struct Element {
  double x, y, along, across;  ///< traction over its friction coefficient times the largest pressure of Hertz
};

/// Elements of the last case, in contact; lengths are in contact radii there.
std::vector<Element> elements_of(const std::filesystem::path& path, double unit) {
  std::vector<Element> elements;
  std::ifstream stream(path);
  double y = NAN;
  bool in_table = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.find("QUANTITIES DISTRIBUTED") != std::string::npos) in_table = true, elements.clear();
    if (!in_table) continue;
    if (const auto at = line.find("Y ="); at != std::string::npos) y = std::stod(line.substr(at + 3));
    std::istringstream numbers(line);
    double x, penetration, pressure, bound, size, angle;
    if (!(numbers >> x >> penetration >> pressure >> bound >> size >> angle) || std::isnan(y)) continue;
    // The angle is that of the traction on the ball, which resists a shift along x.
    elements.push_back(
        {x, y, -size * std::cos(angle * M_PI / 180) / unit, -size * std::sin(angle * M_PI / 180) / unit});
  }
  return elements;
}

TEST(Cattaneo_other_code, tractions_and_shift_at_seven_eighths_of_friction_meet_CONTACT) {
  ASPERITY_SHARED_FILE_OR_SKIP(path, "contact_references/cattaneo.ref_out");
  constexpr double friction = 0.4, force = 0.875, shift = 8.155e-3, modulus = 200,
                   load = 9.195;  // mm, N, MPa; a = 1
  FrictionalContactOptions o;
  o.load = 100e-9, o.layers = 8, o.slip_tolerance = 1e-3, o.cells_per_radius = 18;  // nearly half-spaces
  o.poisson[0] = o.poisson[1] = 0.42, o.friction = friction;
  FrictionalContact contact(o);
  const double a = contact.contact_radius, G = o.youngs[0] / (2 * (1 + o.poisson[0]));
  const double wanted = shift * modulus / load * o.load / (G * a);
  const auto r = contact.shift(wanted + contact.lateral_far_field * force * contact.friction_force);
  const double reached = r.lateral_force[0] / contact.friction_force;
  const double limit = friction * 1.5 * o.load / (M_PI * a * a);
  const auto elements = elements_of(path, friction * 1.5 * load / M_PI);
  ASSERT_EQ(elements.size(), 177u);
  double difference = 0, size = 0, across_difference = 0, across_size = 0;
  for (const auto& e : elements) {
    // Mean over the nodes within the element, 0.133 a wide.
    double along = 0, across = 0, weight = 0;
    for (std::size_t k = 0; k < contact.system.rows().size(); ++k) {
      const auto& x = contact.system.interface_points()[contact.system.rows()[k].node];
      const double half = 0.5 * 0.13333, area = contact.system.areas()[k];
      if (std::abs(x[0] / a - e.x) > half || std::abs(x[1] / a - e.y) > half) continue;
      along -= contact.state.shear[0][k] * area, across -= contact.state.shear[1][k] * area, weight += area;
    }
    ASSERT_GT(weight, 0);
    along /= weight * limit, across /= weight * limit;
    difference += std::pow(along - e.along, 2), size += e.along * e.along;
    across_difference += std::pow(across - e.across, 2), across_size += e.across * e.across;
  }
  const double off = std::sqrt(difference / size), off_across = std::sqrt(across_difference / across_size);
  std::printf(
      "Q/muP %.4f (%.4f), sticking %.3f of the contact (%.3f), traction along differs by %.2f %% in the "
      "2-norm, across by %.1f %% of its %.2f %%\n",
      reached, force, double(r.sticking) / r.active, 45.0 / 177, 100 * off, 100 * off_across,
      100 * std::sqrt(across_size / size));
  const auto verified = [](const std::string& what) {
    return asperity::test::Verified{
        "Sliding", "CONTACT's ball (nu 0.42, mu 0.4) at 7/8 of full friction, a/h 18: " + what, "CONTACT"};
  };
  EXPECT_TRUE(verified("force at its shift").within(reached, force, 0.01));
  EXPECT_TRUE(
      verified("share that sticks, less CONTACT's").below(double(r.sticking) / r.active - 45.0 / 177, 0.02));
  EXPECT_TRUE(verified("traction along, 177 elements, 2-norm").below(100 * off, 5, "%"));
  EXPECT_TRUE(verified("traction across, which Cattaneo leaves out, 2-norm of its own")
                  .below(100 * off_across, 15, "%"));
}

}  // namespace

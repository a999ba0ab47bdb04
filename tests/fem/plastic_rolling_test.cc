// An elastic sphere that rolls over a yielding block, or a yielding sphere over an elastic one: the first
// pass ploughs, later ones run in the track of the first, which lies on the body that has yielded and goes
// where it goes.
#include <gtest/gtest.h>

#include <cstdio>
#include <vector>

#include "tests/fem/support/frictional_contact.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity;
using test::FrictionalContact;
using test::FrictionalContactOptions;

struct Pass {
  double moment;        ///< mean over the middle of the path [N m]
  double work;          ///< of the moment over the whole path [J]
  double plastic_work;  ///< of the pass but for pressing in and lifting [J]
};

/// Rolls forward by `path_length` contact radii under load, lifts off but for a thousandth, goes back and
/// presses down again.
std::vector<Pass> passes(int yielding_body, int count, double cells, double path_length) {
  FrictionalContactOptions o;
  o.friction = 0, o.cells_per_radius = cells, o.loaded = false, o.tilted_normals = true;
  // Hertz' p0 is 2.6 Y: yielding spreads below the contact, and repeated passes shake down (Johnson 1985, ch.
  // 9).
  const double E = o.youngs[0] / (2 * (1 - o.poisson[0] * o.poisson[0])),
               a = std::cbrt(3 * o.load * o.radius / (4 * E));
  o.yield_stress = 1.5 * o.load / (M_PI * a * a) / 2.6;
  o.yielding_body = yielding_body;
  o.path_length = 1.2 * path_length * a;
  FrictionalContact c(o);
  const double h = a / cells;
  fem::RigidMotion start;
  start.x = -0.5 * path_length * a, start.roll = start.x / o.radius;
  std::vector<Pass> result;
  for (int pass = 0; pass < count; ++pass) {
    fem::RigidMotion motion = start;
    for (const double share : {1e-3, 0.2, 0.45, 0.7, 1.0}) c.step(motion, share * o.load);
    Pass p{};
    const double pressed = c.plastic_work;
    int counted = 0;
    double before = 0;
    for (double x = h; x < path_length * a * (1 + 1e-9); x += h) {
      motion.x = start.x + x, motion.roll = motion.x / o.radius;
      const double moment = c.step(motion).rolling_moment;
      p.work += 0.5 * (before + moment) * h / o.radius;
      before = moment;
      if (x < 0.4 * path_length * a || x > 0.9 * path_length * a) continue;
      p.moment += moment;
      ++counted;
    }
    p.moment /= counted;
    p.plastic_work = c.plastic_work - pressed;
    c.step(motion, 1e-3 * o.load);
    std::printf("pass %d: moment %.4f of load times contact radius, work %.4g J, plastic %.4g J\n", pass + 1,
                p.moment / (o.load * a), p.work, p.plastic_work);
    result.push_back(p);
  }
  return result;
}

void expect_less_from_pass_to_pass(const std::string& what, const std::vector<Pass>& p) {
  const auto verified = [&](const std::string& quantity, const char* source) {
    return test::Verified{"Rolling", what + ": " + quantity, source};
  };
  for (std::size_t k = 0; k < p.size(); ++k) {
    EXPECT_GT(p[k].moment, 0) << k;
    EXPECT_GE(p[k].plastic_work, 0) << k;
    if (k == 0) continue;
    const std::string over = " of pass " + std::to_string(k + 1) + " over that of the pass before";
    EXPECT_TRUE(verified("moment" + over, "less").below(p[k].moment / p[k - 1].moment, 1));
    EXPECT_TRUE(verified("plastic work" + over, "less").below(p[k].plastic_work / p[k - 1].plastic_work, 1));
  }
  // Beside what yields, the first pass stores residual stress.
  EXPECT_TRUE(verified("plastic work of the first pass over the work put in", "stored energy")
                  .within(p[0].plastic_work, p[0].work, 0.15));
}

TEST(PlasticRolling_behaviour, a_second_pass_over_the_own_imprint_needs_less) {
  expect_less_from_pass_to_pass("yielding block, p0 2.6 Y, a/h 6", passes(1, 2, 6, 3));
}

TEST(PlasticRollingNightly_behaviour, so_does_a_second_pass_of_a_sphere_that_carries_the_imprint_with_it) {
  expect_less_from_pass_to_pass("yielding sphere, p0 2.6 Y, a/h 6", passes(0, 2, 6, 3));
}

TEST(PlasticRollingNightly_behaviour, four_passes_over_the_own_imprint_need_less_and_less) {
  expect_less_from_pass_to_pass("yielding block, p0 2.6 Y, a/h 10", passes(1, 4, 10, 4));
}

}  // namespace

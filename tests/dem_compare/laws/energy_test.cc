// No path of load and shear may give more work than was put in before: the second law for the sliding laws.
#include <gtest/gtest.h>

#include <random>

#include "core/shear_moduli.h"
#include "dem_compare/laws/hertz_offset.h"
#include "dem_compare/laws/mindlin.h"
#include "dem_compare/laws/mindlin_deresiewicz.h"

namespace asperity {
namespace {

using Eigen::Vector3d;
constexpr double radius = 8.5e-6, mu = 0.3, load = 1e-4;
const ElasticBody borosilicate{71e9, 0.17}, silicon{179e9, 0.25};
const HertzOffset hertz{reduced_modulus(borosilicate, silicon), radius, 0};
const double shear = reduced_shear_modulus(borosilicate, silicon);

/// Least value of the work of shear, over mu P delta_gs, along random paths that start unsheared: straight
/// pieces of load, of shear, or of both. `planar`: shear in any direction of the contact plane.
double least_work(const SlidingLaw& law, bool planar, double largest_shift) {
  std::mt19937 engine(1953);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const double unit_shift =
      MindlinDeresiewicz{shear, radius, {mu, 0}}.gross_slip_shift(hertz.advance({}, hertz.approach(load)));
  double least = 0;
  for (int path = 0; path < 40; ++path) {
    NormalState normal = hertz.advance({}, hertz.approach(load));
    SlidingHistory history = law->advance({}, normal, Vector3d::Zero());
    Vector3d at = Vector3d::Zero();
    double work = 0;
    for (int piece = 0; piece < 30; ++piece) {
      const double from_load = normal.force;
      const double to_load = piece % 3 == 0 ? from_load : load * (0.55 + 0.45 * uniform(engine));
      Vector3d to = largest_shift * unit_shift * Vector3d(uniform(engine), planar ? uniform(engine) : 0, 0);
      if (piece % 3 == 1) to = at;
      constexpr int steps = 100;
      const Vector3d way = to - at;
      for (int i = 1; i <= steps; ++i) {
        normal = hertz.advance(normal, hertz.approach(from_load + (to_load - from_load) * i / steps));
        const Vector3d before = history.spring.resistance,
                       step = at + way / steps * i - (at + way / steps * (i - 1));
        history = law->advance(history, normal, step);
        work += (before + history.spring.resistance).dot(step) / 2;
      }
      at = to;
      least = std::min(least, work / (mu * load * unit_shift));
    }
  }
  return least;
}

constexpr double integration_error = 1e-3;  // of the trapezoidal rule over the kinks of the laws

TEST(EnergyOfSliding_analytic, Mindlins_law_rescaled_on_unloading_gives_no_energy_on_any_path) {
  for (const bool planar : {false, true})
    for (const double shift : {0.3, 2.0})
      EXPECT_GT(least_work(Mindlin{shear, {mu, 0}}, planar, shift), -integration_error);
}

TEST(EnergyOfSliding_analytic, partial_slip_gives_no_energy_on_any_path) {
  for (const bool planar : {false, true})
    for (const double shift : {0.3, 2.0})
      EXPECT_GT(least_work(MindlinDeresiewicz{shear, radius, {mu, 0}}, planar, shift), -integration_error);
}

TEST(EnergyOfSliding_analytic, Mindlins_law_in_plain_increments_gives_energy_on_some_path) {
  Mindlin plain{shear, {10 * mu, 0}};
  plain.changing_load = ChangingLoad::plain;
  EXPECT_LT(least_work(plain, false, 0.3), -0.01);
}

}  // namespace
}  // namespace asperity

// Hertz' contact of the sphere on a plane: force, approach, radius, pressure and the stress below the
// surface.
#include <gtest/gtest.h>

#include <cmath>

#include "core/csv.h"
#include "tests/fem/support/elastic_materials.h"
#include "tests/fem/support/smooth_contact.h"
#include "tests/support/shared_files.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity::test;
using asperity::fem::J2Material;

const J2Material quartz = J2Material::elastic(71e9, 0.17), diamond = J2Material::elastic(1140e9, 0.07);

/// The sphere on `substrate`, meshed with `cells` spacings per contact radius of the largest force.
SmoothContact contact(const J2Material& substrate, double largest_force, double cells, double layers = 4) {
  SmoothContactOptions o;
  o.particle = borosilicate;
  o.substrate = substrate;
  const auto compliance = [](const J2Material& m) {
    const double nu =
        (3 * m.bulk_modulus - 2 * m.shear_modulus) / (2 * (3 * m.bulk_modulus + m.shear_modulus));
    return (1 - nu) / (2 * m.shear_modulus);
  };
  const LoadedHertz hertz{o.radius, 1 / (compliance(borosilicate) + compliance(substrate)), largest_force};
  o.largest_radius = hertz.contact_radius();
  o.spacing = o.largest_radius / cells;
  o.layers = layers;
  return SmoothContact(o);
}

struct HertzErrors {
  double force, radius_in_spacings, pressure;
};

HertzErrors errors(const ContactStep& step, const LoadedHertz& hertz, double spacing) {
  // At given approach the force follows delta^(3/2): a relative error of approach counts 3/2 times as one of
  // force.
  return {std::pow(step.approach / hertz.approach(), -1.5) - 1,
          (step.contact_radius - hertz.contact_radius()) / spacing,
          step.peak_pressure / hertz.peak_pressure() - 1};
}

void expect_hertz(const char* pair, const J2Material& substrate, double force, double cells) {
  auto c = contact(substrate, force, cells);
  const LoadedHertz hertz = c.hertz(force);
  const ContactStep step = c.load(force);
  ASSERT_TRUE(step.converged);
  ASSERT_FALSE(step.reaches_rim);
  const auto e = errors(step, hertz, hertz.contact_radius() / cells);
  std::printf(
      "%-8s %6.0f uN  a/h %4.0f  unknowns %8ld  force %+.3f %%  radius %+.3f h  pressure %+.3f %%  newton %d "
      "cg %d\n",
      pair, force * 1e6, cells, c.unknowns(), 100 * e.force, e.radius_in_spacings, 100 * e.pressure,
      step.newton, step.linear);
  char mesh[64];
  std::snprintf(mesh, sizeof mesh, ", %s, %g uN, a/h %g", pair, force * 1e6, cells);
  const auto verified = [&](const char* what) {
    return Verified{"Hertz", what + std::string(mesh), "Hertz (1882)"};
  };
  EXPECT_TRUE(verified("force").within(1 + e.force, 1, 0.01));
  EXPECT_TRUE(verified("contact radius").below(e.radius_in_spacings, 0.2, "h"));
  EXPECT_TRUE(verified("largest pressure").within(1 + e.pressure, 1, 0.02));
}

TEST(Hertz_analytic, silicon_at_100_uN) { expect_hertz("silicon", silicon, 100e-6, 12); }
TEST(Hertz_analytic, quartz_at_1000_uN) { expect_hertz("quartz", quartz, 1000e-6, 12); }
TEST(Hertz_analytic, diamond_at_10_uN) { expect_hertz("diamond", diamond, 10e-6, 12); }

TEST(HertzNightly_analytic, all_pairs_from_10_to_3000_uN) {
  for (const double force : {10e-6, 30e-6, 100e-6, 300e-6, 1000e-6, 3000e-6}) {
    expect_hertz("silicon", silicon, force, 16);
    expect_hertz("quartz", quartz, force, 16);
    expect_hertz("diamond", diamond, force, 16);
  }
}

TEST(HertzNightly_analytic,
     force_converges_and_the_radius_error_stays_below_half_a_spacing_under_refinement) {
  double force_before = 0;
  for (const double cells : {6.0, 12.0, 24.0}) {
    auto c = contact(silicon, 100e-6, cells, 4 * std::max(1.0, cells / 12));
    const LoadedHertz hertz = c.hertz(100e-6);
    const auto e = errors(c.load(100e-6), hertz, hertz.contact_radius() / cells);
    std::printf("a/h %4.0f unknowns %8ld  force %+.3f %%  radius %+.3f h  pressure %+.3f %%\n", cells,
                c.unknowns(), 100 * e.force, e.radius_in_spacings, 100 * e.pressure);
    char mesh[64];
    std::snprintf(mesh, sizeof mesh, ", silicon, 100 uN, refined to a/h %g", cells);
    const auto verified = [&](const char* what) {
      return Verified{"Hertz", what + std::string(mesh), "Hertz (1882)"};
    };
    if (force_before != 0) {
      EXPECT_TRUE(verified("error of force over that at half of a/h").below(e.force / force_before, 0.6));
    }
    EXPECT_TRUE(verified("contact radius").below(e.radius_in_spacings, 0.5, "h"));
    EXPECT_TRUE(
        verified("largest pressure")
            .within(1 + e.pressure, 1, 0.02));  // its error changes sign on the way: only its size counts
    force_before = e.force;
  }
}

TEST(Hertz_analytic, force_follows_the_three_halves_law_of_approach) {
  auto c = contact(silicon, 400e-6, 12);
  const auto low = c.load(200e-6), high = c.load(400e-6);
  const double exponent = std::log(2.0) / std::log(high.approach / low.approach);
  EXPECT_TRUE(
      (Verified{"Hertz", "exponent of force over approach, silicon, 200 to 400 uN", "3/2, Hertz (1882)"}
           .within(exponent, 1.5, 0.01)));
}

TEST(Hertz_analytic, tractions_and_reactions_agree) {
  auto c = contact(silicon, 100e-6, 6);
  const auto step = c.load(100e-6);
  const auto verified = [](const char* what) {
    return Verified{"Hertz", what + std::string(", silicon, 100 uN, a/h 6"), "balance"};
  };
  EXPECT_TRUE(verified("reaction of the driven plane against tractions")
                  .below(step.reaction_driven / step.force - 1, 1e-6));
  EXPECT_TRUE(verified("reaction of the block's base against tractions")
                  .below(step.reaction_fixed / step.force - 1, 1e-6));
  EXPECT_TRUE(verified("force reached against force asked for").below(step.force / 100e-6 - 1, 1e-6));
}

TEST(Hertz_analytic, elastic_energy_is_the_work_of_the_force) {
  // Work of a force that grows as delta^(3/2) is 2/5 P delta; bodies that are linear add 1/2 P times theirs.
  auto c = contact(silicon, 100e-6, 12);
  const auto step = c.load(100e-6);
  const double work =
      0.4 * step.force * step.approach + 0.5 * step.force * (step.raw_approach - step.approach);
  std::printf("elastic energy / work %.5f\n", step.elastic_energy / work);
  EXPECT_TRUE((Verified{"Hertz", "elastic energy, silicon, a/h 12", "2/5 P delta"}.within(step.elastic_energy,
                                                                                          work, 0.01)));
}

}  // namespace

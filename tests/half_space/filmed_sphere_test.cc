// A sphere with films by its integral equation: limits in closed form, half-spaces on a grid, and published
// forms.
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "half_space/contact_shape.h"
#include "half_space/filmed_sphere.h"
#include "half_space/normal_contact.h"
#include "tests/support/verification.h"

namespace asperity::half_space {
namespace {

using test::Largest;
using test::Verified;

TEST(FilmedSphere_analytic, of_the_body_s_own_material_or_without_a_film_is_that_of_hertz) {
  const ElasticBody glass{71e9, 0.17};
  const double E = 50e9, R = 8.5e-6, a = 200e-9;
  for (const FilmedSphere& sphere : {FilmedSphere(E, {}), FilmedSphere(E, {{glass, glass, 60e-9}})}) {
    const FilmedSphere::Contact contact = sphere.at(a, R);
    EXPECT_NEAR(contact.approach / (a * a / R), 1, 1e-9);
    EXPECT_NEAR(contact.force / (4.0 / 3 * E * a * a * a / R), 1, 1e-9);
    EXPECT_NEAR(contact.stiffness / (2 * E * a), 1, 1e-9);
    EXPECT_NEAR(sphere.radius_at_force(contact.force, R) / a, 1, 1e-9);
    EXPECT_NEAR(sphere.radius_at_approach(contact.approach, R) / a, 1, 1e-9);
  }
}

TEST(FilmedSphere_analytic, a_small_contact_feels_the_film_and_a_wide_one_the_body) {
  const ElasticBody body{100e9, 0.25};
  for (const double contrast : {0.05, 0.3, 4.0, 50.0}) {
    const FilmedSphere sphere(modulus_alone(body), {{{contrast * body.youngs_modulus, 0.25}, body, 10e-9}});
    const double small = 1e-13, wide = 200e-6, R = 1;
    EXPECT_NEAR(sphere.at(small, R).stiffness / (2 * small * contrast * modulus_alone(body)), 1, 2e-3)
        << contrast;
    EXPECT_NEAR(sphere.at(wide, R).stiffness / (2 * wide * modulus_alone(body)), 1, 2e-3) << contrast;
  }
}

/// Johnson 1985, sec. 5.8: each point of a thin compressible film on a rigid body gives way by itself,
/// p = M w/t, so that a^2 = 2 R d and F = pi M R d^2/t, up to parts of t/a.
TEST(FilmedSphere_analytic, a_thin_soft_film_is_a_bed_of_springs) {
  const ElasticBody body{100e9, 0.25}, film{1e6, 0.3};
  const double oedometric = film.youngs_modulus * 0.7 / (1.3 * 0.4), t = 10e-9, R = 1e-3;
  const FilmedSphere sphere(modulus_alone(body), {{film, body, t}});
  for (const double a : {10 * t, 20 * t, 40 * t}) {
    const FilmedSphere::Contact contact = sphere.at(a, R);
    const double d = contact.approach, off = contact.force / (M_PI * oedometric * R * d * d / t) - 1;
    EXPECT_LT(std::abs(off), 0.1 * t / a);
    EXPECT_NEAR(a * a / (2 * R * d), 1, 2 * t / a);
  }
}

/// Gao, Chiu & Lee 1992, Int. J. Solids Struct. 29, 2471: exact to first order in the difference of moduli,
/// for a flat end.
TEST(FilmedSphere_analytic, of_little_contrast_is_the_perturbation_of_gao) {
  Largest error;
  for (const double nu : {0.1, 0.25, 0.4}) {
    const ElasticBody body{100e9, nu}, film{1.001 * 100e9, nu};
    const FilmedSphere sphere(modulus_alone(body), {{film, body, 1}});
    for (const double a : {0.3, 1.0, 3.0, 10.0}) {
      const double x = 1 / a;
      const double weight =
          2 / M_PI * std::atan(x) +
          1 / (2 * M_PI * (1 - nu)) * ((1 - 2 * nu) * x * std::log((1 + x * x) / (x * x)) - x / (1 + x * x));
      const double found = (sphere.at(a, 1).stiffness / (2 * a * modulus_alone(body)) - 1) / 0.001;
      std::printf("nu %.2f a/t %.1f: %.4f of %.4f\n", nu, a, found, weight);
      error.count(found - weight);
    }
  }
  EXPECT_TRUE((Verified{"Half-space", "flat end on a film of little contrast: share of its modulus",
                        "Gao, Chiu & Lee (1992), first order in the contrast"}
                   .below(error, 0.005)));
}

TEST(FilmedSphere_analytic, its_stiffness_is_the_slope_of_its_force) {
  const ElasticBody body{71e9, 0.17};
  for (const double contrast : {0.02, 0.3, 5.0}) {
    const FilmedSphere sphere(50e9, {{{contrast * 71e9, 0.3}, body, 20e-9}});
    for (const double a : {5e-9, 20e-9, 100e-9, 600e-9}) {
      const auto one = sphere.at(0.999 * a, 8.5e-6), other = sphere.at(1.001 * a, 8.5e-6);
      EXPECT_NEAR(
          (other.force - one.force) / (other.approach - one.approach) / sphere.at(a, 8.5e-6).stiffness, 1,
          5e-4)
          << contrast << " " << a;
    }
  }
}

TEST(FilmedSphere_other_code, carries_what_half_spaces_on_a_grid_do) {
  constexpr double radius = 8.5e-6, approach = 5e-9;
  const ElasticBody body{100e9, 0.25};
  Largest force, width;
  for (const ElasticBody& soft_or_stiff : {ElasticBody{5e9, 0.4}, {30e9, 0.25}, {300e9, 0.2}, {1000e9, 0.2}})
    for (const double thickness : {20e-9, 60e-9, 200e-9}) {
      const FilmOnBody film{soft_or_stiff, body, thickness};
      const double a = std::sqrt(radius * approach);
      const Grid grid = square_grid(4 * a, 512);
      Field gap(grid.cells());
      for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i)
          gap[static_cast<std::size_t>(j) * grid.nx + i] =
              (grid.x(i) * grid.x(i) + grid.y(j) * grid.y(j)) / (2 * radius);
      const auto solved = NormalContact(grid, Boundary::free, modulus_alone(body), std::move(gap), {film})
                              .at_approach(approach);
      const FilmedSphere sphere(modulus_alone(body), {film});
      const double wide = sphere.radius_at_approach(approach, radius),
                   area = contact_shape(grid, solved.pressure, std::numeric_limits<double>::infinity()).area;
      std::printf("E_f %.0f GPa, t/a %.2f: force %.4f, radius %.4f of it\n",
                  soft_or_stiff.youngs_modulus * 1e-9, thickness / wide,
                  solved.force / sphere.at(wide, radius).force, std::sqrt(area / M_PI) / wide);
      force.count(solved.force / sphere.at(wide, radius).force - 1);
      width.count(std::sqrt(area / M_PI) / wide - 1);
    }
  const std::string of = "sphere on a film, a twentieth to ten times as stiff as the body: ",
                    by = "integral equation of the axisymmetric contact (Yu, Sanday & Rath 1990)";
  EXPECT_TRUE((Verified{"Half-space", of + "force", by}.below(force, 0.002)));
  EXPECT_TRUE((Verified{"Half-space", of + "contact radius", by}.below(width, 0.02)));
}

TEST(FilmedSphere_behaviour, what_is_no_film_is_refused) {
  const ElasticBody body{100e9, 0.25};
  EXPECT_THROW(FilmedSphere(0, {}), InputError);
  EXPECT_THROW(FilmedSphere(100e9, {{body, body, 0}}), InputError);
}

}  // namespace
}  // namespace asperity::half_space

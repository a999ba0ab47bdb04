// Half-spaces with films: the response to a wave against the boundary value problem solved by itself, and the
// contact of a sphere against a published fit to another solution.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"
#include "core/hertz.h"
#include "half_space/normal_contact.h"
#include "tests/support/coated_half_space.h"
#include "tests/support/verification.h"

namespace asperity::half_space {
namespace {

using test::Largest;
using test::Verified;

double shear_of(const ElasticBody& body) { return body.youngs_modulus / (2 * (1 + body.poisson_ratio)); }

/// Normal and shear stress, displacement along and down, at a depth, by Airy's function f(z) cos(q x) in
/// plane strain; `f`: it and its first three derivatives.
Eigen::Vector4d fields_of(const std::array<double, 4>& f, double q, const ElasticBody& body) {
  const double G = shear_of(body), nu = body.poisson_ratio;
  return {-q * q * f[0], q * f[1], ((1 - nu) * f[2] + nu * q * q * f[0]) / (2 * G * q),
          -(q * f[1] / G - ((1 - nu) * f[3] + nu * q * q * f[1]) / (2 * G * q)) / q};
}
/// z^power exp(sign q z) and its derivatives.
std::array<double, 4> mode(double z, double q, int sign, int power) {
  const double s = sign * q, e = std::exp(s * z);
  if (power == 0) return {e, s * e, s * s * e, s * s * s * e};
  return {z * e, (1 + s * z) * e, (2 * s + s * s * z) * e, (3 * s * s + s * s * s * z) * e};
}

/// Displacement over pressure of a wave: film and body each satisfy elasticity, tractions and displacements
/// are continuous between them, and the surface carries the pressure alone.
double displacement_of_wave(const FilmOnBody& film, double q) {
  Eigen::Matrix<double, 6, 6> conditions = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> given = Eigen::Matrix<double, 6, 1>::Zero();
  Eigen::Vector4d down;
  for (int k = 0; k < 4; ++k) {
    const int sign = k < 2 ? -1 : 1, power = k % 2;
    const Eigen::Vector4d top = fields_of(mode(0, q, sign, power), q, film.film);
    conditions.col(k).head(2) = top.head(2);
    conditions.col(k).tail(4) = fields_of(mode(film.thickness, q, sign, power), q, film.film);
    down[k] = top[3];
  }
  for (int k = 0; k < 2; ++k) conditions.col(4 + k).tail(4) = -fields_of(mode(0, q, -1, k), q, film.body);
  given[0] = -1;
  return down.dot(conditions.fullPivLu().solve(given).head(4));
}

TEST(Film_analytic, gives_way_to_a_wave_as_the_boundary_value_problem_says) {
  Largest error;
  for (const double nu : {0.1, 0.45})
    for (const double stiffness : {0.02, 0.3, 5.0, 60.0})
      for (const double qt : {0.02, 0.3, 1.0, 3.0}) {
        const FilmOnBody film{{stiffness * 10e9, nu}, {10e9, 0.25}, 1};
        const double body = (1 - 0.25) / (shear_of(film.body) * qt), whole = displacement_of_wave(film, qt);
        error.count((film.compliance(qt) + body) / whole - 1);
      }
  EXPECT_TRUE((Verified{"Half-space", "film on a body, waves of 2 to 300 thicknesses: displacement",
                        "Airy's function in film and body, solved for"}
                   .below(error, 1e-9)));
}

TEST(Film_analytic, of_the_body_s_own_material_adds_nothing_and_a_thick_one_is_all_there_is) {
  const ElasticBody body{70e9, 0.3}, soft{7e9, 0.2};
  const auto alone = [](const ElasticBody& b, double q) { return (1 - b.poisson_ratio) / (shear_of(b) * q); };
  EXPECT_NEAR((FilmOnBody{body, body, 1e-8}.compliance(3e7)) / alone(body, 3e7), 0, 1e-12);
  EXPECT_NEAR((FilmOnBody{soft, body, 1}.compliance(3e7)) / (alone(soft, 3e7) - alone(body, 3e7)), 1, 1e-9);
}

/// Under long waves of pressure p the surface of the body strains along by -k p, k = (1 - 2 nu)/(2 G), and
/// the film with it. It is pressed together by t p (1 - lambda_f k)/M_f, M = lambda + 2 G, and the change of
/// its stress along x shears the body below, which lifts it: together t [(1 - lambda_f k)^2/M_f - k^2 M_f].
TEST(Film_analytic, under_long_waves_is_a_membrane_that_is_pressed_together) {
  for (const ElasticBody& film_body : {ElasticBody{7e9, 0.2}, ElasticBody{700e9, 0.1}}) {
    const ElasticBody body{70e9, 0.3};
    const double thickness = 1e-8, k = (1 - 2 * body.poisson_ratio) / (2 * shear_of(body)),
                 nu = film_body.poisson_ratio, lame = 2 * shear_of(film_body) * nu / (1 - 2 * nu),
                 oedometric = lame + 2 * shear_of(film_body);
    const double expected = thickness * (std::pow(1 - lame * k, 2) / oedometric - k * k * oedometric);
    const FilmOnBody film{film_body, body, thickness};
    EXPECT_NEAR(film.compliance(0) / expected, 1, 1e-3);
    EXPECT_DOUBLE_EQ(film.compliance(10), film.compliance(0));
  }
}

TEST(Film_analytic, a_wave_on_a_grid_that_repeats_sinks_by_body_and_film) {
  constexpr int n = 48;
  constexpr double h = 5e-9, modulus = 50e9, q = 2 * M_PI * 3 / (n * h);
  const FilmOnBody film{{5e9, 0.3}, {70e9, 0.2}, 20e-9};
  const Compliance compliance({n, n, h, h}, Boundary::periodic, modulus, {film});
  Field pressure(n * n), sunk;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) pressure[static_cast<std::size_t>(j) * n + i] = std::cos(q * i * h);
  compliance.apply(pressure, sunk);
  const double expected = 2 / (modulus * q) + film.compliance(q);
  for (std::size_t c = 0; c < sunk.size(); ++c) EXPECT_NEAR(sunk[c], expected * pressure[c], 1e-9 * expected);
}

/// A sphere of 8.5 um on the film on silicon, at a contact of some hundred nanometres.
double force_of_sphere(const FilmOnBody& film, double radius, double approach) {
  constexpr int n = 256;
  const Grid grid = square_grid(4 * std::sqrt(radius * approach), n);
  Field gap(grid.cells());
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      gap[static_cast<std::size_t>(j) * n + i] =
          (grid.x(i) * grid.x(i) + grid.y(j) * grid.y(j)) / (2 * radius);
  const double reduced = film.body.youngs_modulus / (1 - film.body.poisson_ratio * film.body.poisson_ratio);
  return NormalContact(grid, Boundary::free, reduced, std::move(gap), {film}).at_approach(approach).force;
}

TEST(Film_other_code, under_a_rigid_sphere_is_the_coated_half_space_of_Perriot_and_Barthel) {
  constexpr double radius = 8.5e-6, approach = 5e-9;
  const double a = std::sqrt(radius * approach);
  Largest error, of_thin;
  for (const double stiffness : {0.2, 0.5, 3.0})
    for (const double thickness : {0.1, 0.3, 1.0}) {
      const FilmOnBody film{{stiffness * 100e9, 0.25}, {100e9, 0.25}, thickness * a};
      const double reduced = 100e9 / (1 - 0.0625);
      const CoatedHalfSpace coated{stiffness * reduced, reduced, film.thickness};
      const double expected = 4.0 / 3 * coated.modulus(a) * a * approach;
      const double found = force_of_sphere(film, radius, approach);
      std::printf("film %.1f times as stiff, t/a %.1f: %.3f of the fit\n", stiffness, thickness,
                  found / expected);
      error.count(found / expected - 1);
      if (thickness < 0.2) of_thin.count(found / expected - 1);
    }
  EXPECT_TRUE((Verified{"Half-space", "sphere on a film of a tenth of the contact radius: force",
                        "Perriot & Barthel (2004), fit to their solution"}
                   .below(of_thin, 0.03)));
  EXPECT_TRUE((Verified{"Half-space", "sphere on a film, a fifth to three times as stiff as the body: force",
                        "Perriot & Barthel (2004), fit to their solution"}
                   .below(error, 0.15)));  // of a fit over a wide range of moduli
}

/// Nothing repeats on a free grid, however thick the film and however far it reaches.
TEST(Film_analytic, is_felt_as_far_on_a_small_grid_as_on_a_large_one) {
  const FilmOnBody film{{700e9, 0.2}, {70e9, 0.2}, 20e-9};
  constexpr int small = 16, large = 96;
  const auto sunk_by_one_cell = [&](int n) {
    const Compliance compliance({n, n, 1e-9, 1e-9}, Boundary::free, 50e9, {film});
    Field pressure(static_cast<std::size_t>(n) * n, 0.0), sunk;
    pressure[0] = 1e9;
    compliance.apply(pressure, sunk);
    return sunk;
  };
  const Field on_small = sunk_by_one_cell(small), on_large = sunk_by_one_cell(large);
  for (int j = 0; j < small; ++j)
    for (int i = 0; i < small; ++i)
      EXPECT_NEAR(on_small[j * small + i] / on_large[j * large + i], 1, 1e-9) << i << " " << j;
}

TEST(Film_analytic, around_a_force_sinks_as_its_waves_do) {
  Largest error;
  for (const double stiffness : {0.01, 0.1, 0.5, 2.0, 10.0, 100.0})
    for (const double nu : {0.1, 0.3, 0.45}) {
      const FilmOnBody film{{stiffness * 70e9, nu}, {70e9, 0.2}, 3e-9};
      const FilmedBodies bodies(50e9, {film});
      for (double q = 1e-3 / film.thickness; q * film.thickness < 20; q *= 1.3) {
        double by_terms = 1;
        for (const FilmTerm& term : bodies.terms) by_terms += term.share * std::exp(-term.reach * q);
        error.count(by_terms * 2 / (bodies.of_films * q) / (2 / (50e9 * q) + film.compliance(q)) - 1);
      }
    }
  EXPECT_TRUE(
      (Verified{"Half-space", "film a hundredth to a hundred times as stiff as the body, as a sum of terms",
                "the same wave by wave (Burmister 1945)"}
           .below(error, 2e-4)));
}

TEST(Film_behaviour, without_a_thickness_is_refused) {
  EXPECT_THROW(Compliance({64, 64, 1e-9, 1e-9}, Boundary::free, 50e9, {{{10e9, 0.3}, {70e9, 0.2}, 0}}),
               InputError);
}

}  // namespace
}  // namespace asperity::half_space

// Attraction beyond the contact: Derjaguin, Muller & Toporov's limit, in which it acts like more load.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/error.h"
#include "fem/solve_case.h"
#include "tests/fem/support/solved_experiment.h"
#include "tests/fem/support/sphere_on_silicon.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity;
using test::solve_experiment;

constexpr double pull = 40e-6, load_with_it = 100e-6, local_friction = 0.25;

CaseInput slid_under(double load, double attraction) {
  CaseInput input = test::sphere_on_silicon("smooth", "smooth", 26e-9, 330e-9);
  input.interface.parameters["Friction coefficient"] = local_friction;
  input.interface.attraction_force = attraction;
  input.experiment.type = Motion::sliding;
  input.experiment.normal_load = load;
  input.experiment.load_steps = 3, input.experiment.unload_steps = 2;
  input.experiment.distance = 15e-9;
  input.experiment.reverse = false;
  input.output.fields = false;
  return input;
}

/// What the contact of a sphere carries beside its load where a stress s0 attracts it out to the radius c:
/// s0 pi c^2, by Maugis' (1992) equations in his units, whose only unknown is the ratio of c to the contact
/// radius.
double attraction_by_maugis(double load, double work, double range) {
  const double radius = 8.5e-6, stress = work / range,
               K = 4.0 / 3 * reduced_modulus({71e9, 0.17}, {179e9, 0.25}),
               lambda = 2 * stress * std::cbrt(radius / (M_PI * work * K * K)),
               unit_radius = std::cbrt(M_PI * work * radius * radius / K), unit_force = M_PI * work * radius;
  const auto at = [&](double u) {
    const double t = std::atan(u), m = std::hypot(1, u), Q = lambda / 2 * (u + (m * m - 2) * t),
                 L = 4.0 / 3 * lambda * lambda * (u * t - m + 1),
                 a = (std::sqrt(L * L + 4 * Q) - L) / (2 * Q);
    return std::pair<double, double>{a * a * a - lambda * a * a * (u + m * m * t), m * a};
  };
  double near = 1e-6, far = 1e3;  // u: force falls with it
  for (int i = 0; i < 200; ++i) {
    const double middle = std::sqrt(near * far);
    (at(middle).first * unit_force > load ? near : far) = middle;
  }
  const double c = at(near).second * unit_radius;
  return stress * M_PI * c * c;
}

/// Row of the history with the largest lateral force.
std::size_t slipping(const test::SolvedExperiment& s) {
  const auto force = s.history.numbers("lateral_force [N]");
  return static_cast<std::size_t>(std::max_element(force.begin(), force.end()) - force.begin());
}

}  // namespace

TEST(AttractionForce_analytic, acts_like_more_load_on_contact_and_friction) {
  const test::TemporaryFolder with, without;
  const auto attracted = solve_experiment(slid_under(load_with_it, pull), with.path);
  const auto pressed = solve_experiment(slid_under(load_with_it + pull, 0), without.path);
  const std::size_t row = slipping(attracted), other = slipping(pressed);
  for (const char* column : {"lateral_force [N]", "contact_radius [m]", "normal_displacement [m]"})
    EXPECT_NEAR(attracted.at(column, row), pressed.at(column, other), 2e-3 * pressed.at(column, other))
        << column;
  EXPECT_NEAR(attracted.at("normal_force [N]", row), load_with_it, 1e-5 * load_with_it);
  EXPECT_NEAR(attracted.at("attraction [N]", row), pull, 1e-12);
  const auto verified = [](const char* quantity, const char* source) {
    return test::Verified{"Adhesion",
                          std::string("40 uN beyond the contact beside 100 uN, a/h 10: ") + quantity, source};
  };
  EXPECT_TRUE(verified("friction over load", "mu (1 + F/P), DMT (1975)")
                  .within(attracted.result["effective"]["sliding_friction"]["value"],
                          local_friction * (1 + pull / load_with_it), 0.01));
  // As of a friction that is all by load: none of it is by the area, whose error is larger.
  EXPECT_NEAR(attracted.result["effective"]["sliding_friction"]["sd"].get<double>() /
                  attracted.result["effective"]["sliding_friction"]["value"].get<double>(),
              pressed.result["effective"]["sliding_friction"]["sd"].get<double>() /
                  pressed.result["effective"]["sliding_friction"]["value"].get<double>(),
              5e-4);
  EXPECT_TRUE(verified("energy left open", "balance")
                  .below(100 * attracted.result["balance"]["energy"].get<double>(), 1, "%"));
  // The last load is a thousandth of the largest, and the contact stays that of the attraction.
  const Hertz hertz{reduced_modulus({71e9, 0.17}, {179e9, 0.25}), 8.5e-6};
  const std::size_t last = attracted.history.numbers("step").size() - 1;
  EXPECT_LT(attracted.at("normal_force [N]", last), 1e-2 * load_with_it);
  EXPECT_TRUE(verified("contact radius without load", "(3 R F/(4 E*))^(1/3), DMT (1975)")
                  .within(attracted.at("contact_radius [m]", last), hertz.contact_radius(pull), 0.03));
}

/// Friction is that of the contact pressure, which attraction over a range raises across the contact and
/// around it (Derjaguin 1934).
TEST(FrictionUnderAttractionNightly_analytic, is_that_of_load_and_attraction_by_Maugis) {
  for (const auto& [work, range] : {std::pair{0.05, 1e-9}, std::pair{0.1, 0.6e-9}, std::pair{0.05, 3e-9}}) {
    CaseInput input = slid_under(load_with_it, 0);
    input.mesh.interface_spacing = 18e-9, input.mesh.contact_region = 380e-9;
    input.interface.work_of_adhesion = work;
    input.interface.parameters["Adhesion range"] = range;
    const test::TemporaryFolder folder;
    const auto s = solve_experiment(input, folder.path);
    const double expected =
        local_friction * (1 + attraction_by_maugis(load_with_it, work, range) / load_with_it);
    char what[96];
    std::snprintf(what, sizeof what, "friction over load under 100 uN, w %g J/m2 over %g nm, a/h 13", work,
                  1e9 * range);
    EXPECT_TRUE((test::Verified{"Adhesion", what, "mu (1 + s0 pi c^2/P), Maugis (1992)"}.within(
        s.result["effective"]["sliding_friction"]["value"], expected, 0.01)));
  }
}

TEST(AttractionForce_behaviour, needs_control_by_force) {
  CaseInput input = slid_under(0, pull);
  input.experiment.control = ExperimentInput::Control::displacement;
  input.experiment.normal_approach = 8e-9;
  const test::TemporaryFolder folder;
  try {
    solve_experiment(input, folder.path);
    FAIL() << "it was solved";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("needs Control = force"), std::string::npos) << error.what();
  }
}

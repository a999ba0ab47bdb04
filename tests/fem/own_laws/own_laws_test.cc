// Laws from outside of the program, each one file of this folder that nothing else names: a case asks for
// them by their own entries, the manual has them, and contacts are solved with them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/case_declaration.h"
#include "core/error.h"
#include "fem/case/case_setup.h"
#include "fem/interface/adhesion_law.h"
#include "fem/interface/friction_law.h"
#include "fem/solve_case.h"
#include "tests/fem/support/frictional_contact.h"
#include "tests/fem/support/glass_sphere.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity;
using test::solve_experiment;

constexpr double at_rest = 0.3, kinetic = 0.2, weakening = 50e-9, load = 100e-6;

CaseInput weakened_sliding(const std::filesystem::path& folder) {
  return test::glass_case(
      folder,
      "set Friction coefficient = 0.3\n set Kinetic friction coefficient = 0.2\n set Weakening "
      "distance = 50 nm\n",
      "set Type = sliding\n set Normal load = 100 uN\n set Load steps = 3\n set Unload = false\n "
      "set Reverse = false\n"
      "set Distance = 110 nm\n",
      "set Interface spacing = 32 nm\n set Contact region = 320 nm\n");
}

testing::AssertionResult balances(const std::string& topic, const test::SolvedExperiment& s) {
  return test::leaves_no_energy_open(topic, "a law from outside", s);
}

/// Mean friction of a sphere that slips as a whole when shifted by `shift`: each point has slipped by the
/// shift less what the bodies have given way there, 1 - r^2/(2 a^2) of 3 Q C/(16 a) under a shear stress in
/// proportion to Hertz' pressure (Mindlin 1949), whose mean over the pressure is 4/5.
double weakened_friction(double shift, double contact_radius) {
  const double shear_modulus = 71e9 / (2 * 1.17), compliance = 2 * (2 - 0.17) / shear_modulus;
  const double give = 0.8 * 3 * compliance / (16 * contact_radius);  // mean, per lateral force
  const double rate = (at_rest - kinetic) / weakening;
  return (at_rest - rate * shift) / (1 - rate * give * load);
}

TEST(OwnFrictionLaw_analytic, weakens_with_slip_from_its_peak_to_its_plateau_and_resumes) {
  const test::TemporaryFolder folder;
  const CaseInput input = weakened_sliding(folder.path);
  const auto whole = solve_experiment(input, folder.path / "whole");
  const auto force = whole.history.numbers("lateral_force [N]"),
             shift = whole.history.numbers("lateral_displacement [m]"),
             sticking = whole.history.numbers("sticking_share"),
             radius = whole.history.numbers("contact_radius [m]");
  const auto verified = [](const char* what, const char* source) {
    return test::Verified{"Sliding", std::string("friction that weakens with slip, a/h 8: ") + what, source};
  };
  EXPECT_TRUE(
      verified("peak", "mu_s P").within(*std::max_element(force.begin(), force.end()), at_rest * load, 0.02));
  test::Largest branch;
  int falling = 0;
  for (std::size_t k = 0; k < force.size(); ++k) {
    if (sticking[k] > 0 || shift[k] > 0.95 * weakening || shift[k] <= 0) continue;
    branch.count(force[k] / (load * weakened_friction(shift[k], radius[k])) - 1);
    ++falling;
  }
  EXPECT_GE(falling, 2);
  EXPECT_TRUE(verified("its fall", "law and Mindlin (1949)").within(1 + branch, 1, 0.01));
  EXPECT_TRUE(verified("its plateau", "mu_k P").within(force.back(), kinetic * load, 0.01));
  EXPECT_TRUE(balances("Sliding", whole));
  EXPECT_DOUBLE_EQ(whole.result["inputs"]["weakening_distance"].get<double>(), weakening);

  struct Stop {};
  SolveOptions options;
  options.output = folder.path / "cut";
  options.progress = [steps = 0](const std::string& line) mutable {
    if (line.rfind("step ", 0) == 0 && ++steps == 9) throw Stop();
  };
  EXPECT_THROW(solve_case(input, options), Stop);
  const auto resumed =
      solve_experiment(input, folder.path / "cut", true).history.numbers("lateral_force [N]");
  ASSERT_EQ(resumed.size(), force.size());
  test::Largest difference;
  for (std::size_t k = 0; k < force.size(); ++k) difference.count((resumed[k] - force[k]) / (kinetic * load));
  EXPECT_TRUE((test::Verified{"Interruption", "friction with a history resumed: lateral force",
                              "the uninterrupted run"}
                   .below(difference, 1e-6, "mu P")));
}

/// Remembers what it is told.
class Witness : public fem::FrictionLaw {
 public:
  fem::ShearLimit limit(const fem::InterfacePoint& point, const double*) const override {
    return {0.3 * point.pressure, 0.3};
  }
  std::vector<std::string> history() const override { return {"slipped", "path", "rate", "time", "step"}; }
  void remember(const fem::InterfacePoint& point, double* history) const override {
    history[0] += std::hypot(point.slip[0], point.slip[1]);
    history[1] = point.slip_path, history[2] = point.slip_rate, history[3] = point.time,
    history[4] = point.time_step;
  }
};

/// A step that is not accepted leaves everything that a point remembers as it was.
TEST(OwnFrictionLaw_behaviour, is_told_slip_path_rate_and_time_of_accepted_steps) {
  test::FrictionalContactOptions o;
  o.cells_per_radius = 6, o.friction = 0.3;
  test::FrictionalContact contact(o);
  fem::ContactSolverOptions options;
  options.friction = std::make_shared<Witness>();
  fem::ContactSolver solver(contact.system, options);
  fem::ContactState state = solver.first_touch();
  solver.push_rigidly(state, 0.8 * contact.contact_radius * contact.contact_radius / o.radius);
  ASSERT_TRUE(solver.solve(state, o.load).converged);
  std::vector<double> path(state.multiplier.size());
  for (std::size_t r = 0; r < path.size(); ++r) path[r] = solver.tractions().remembered(state, r, 1);
  for (const double shift : {8e-9, 14e-9}) {
    fem::ContactState tried = state;
    fem::RigidMotion motion = state.motion;
    motion.x = 1.1 * shift;
    solver.solve(tried, o.load, motion, 0.25);
    motion.x = shift;
    ASSERT_TRUE(solver.solve(state, o.load, motion, 0.5).converged);
    for (std::size_t r = 0; r < path.size(); ++r) {
      const auto kept = [&](std::size_t index) { return solver.tractions().remembered(state, r, index); };
      EXPECT_NEAR(kept(0), kept(1), 1e-18);
      EXPECT_NEAR(kept(2) * 0.5, kept(1) - path[r], 1e-18);
      EXPECT_EQ(kept(3), state.time);
      EXPECT_EQ(kept(4), 0.5);
      path[r] = kept(1);
    }
  }
  EXPECT_EQ(state.time, 2);
  // Beyond full slip every point moves by the shift but for what the bodies give way.
  const double farthest = *std::max_element(path.begin(), path.end());
  EXPECT_GT(farthest, 0.7 * 14e-9);
  EXPECT_LT(farthest, 14e-9);
}

TEST(OwnAdhesionLaw_analytic, draws_a_sphere_apart_as_its_work_says) {
  const test::TemporaryFolder folder;
  const CaseInput input = test::glass_case(
      folder.path,
      "set Work of adhesion = 20 mJ/m^2\n set Adhesion law = trapezoidal\n set Adhesion range = 12 nm\n"
      "set Adhesion plateau = 0.25\n",
      "set Control = displacement\n set Normal approach = 3 nm\n set Load steps = 4\n set Unload steps = 8\n"
      "set Retract = 6 nm\n",
      "set Interface spacing = 50 nm\n");
  const auto s = solve_experiment(input, folder.path / "solved");
  const auto force = s.history.numbers("normal_force [N]"),
             approach = s.history.numbers("normal_displacement [m]"),
             area = s.history.numbers("contact_area [m^2]");
  const auto law = fem::make_adhesion_laws(input.interface).closing;
  test::Largest error;
  int apart = 0;
  for (std::size_t k = 0; k < force.size(); ++k) {
    if (area[k] > 0 || approach[k] > -0.5e-9) continue;
    error.count(force[k] / (-2 * M_PI * input.radius * law->at(-approach[k]).work) - 1);
    ++apart;
  }
  EXPECT_GE(apart, 3);
  EXPECT_TRUE(
      (test::Verified{"Adhesion", "a law from outside, spheres apart: force", "Derjaguin (1934)"}.within(
          1 + error, 1, 0.03)));
  EXPECT_TRUE(balances("Adhesion", s));
}

/// A point stretched to 2 % of plastic strain, and a contact of the same material.
TEST(OwnMaterial_analytic, hardens_as_its_law_says_and_balances_energy) {
  const test::TemporaryFolder folder;
  const CaseInput input = test::glass_case(
      folder.path, "", "set Normal load = 300 uN\n set Load steps = 3\n set Unload steps = 2\n",
      "set Interface spacing = 60 nm\n",
      "set Yield stress = 0.4 GPa\n set Swift strain = 0.01\n set Swift exponent = 0.3\n");
  const fem::J2Material material = fem::material_of(input.particle);
  constexpr double plastic = 0.02;
  const double expected = 0.4e9 * std::pow(1 + plastic / 0.01, 0.3),
               strain = expected / (3 * material.shear_modulus) + plastic;
  const fem::J2Material* lane[fem::lanes];
  fem::Simd<double> shear;
  fem::SymmetricTensor<fem::Simd<double>> deviator{}, stress;
  for (int l = 0; l < fem::lanes; ++l) {
    lane[l] = &material, shear[l] = material.shear_modulus;
    for (int c = 0; c < 3; ++c) deviator[c][l] = c == 0 ? strain : -0.5 * strain;
  }
  fem::PlasticState<fem::Simd<double>> state{};
  fem::J2Tangent<fem::Simd<double>> tangent;
  fem::return_map(lane, shear, deviator, state, stress, tangent);
  const test::Verified verified{
      "Material law", "hardening by a law from outside: stress at 2 % plastic strain", "Y (1 + alpha/e)^n"};
  EXPECT_TRUE(verified.below(1.5 * stress[0][0] / expected - 1, 1e-10));
  const auto s = solve_experiment(input, folder.path / "solved");
  EXPECT_GT(s.history.numbers("plastic_work [J]").back(), 0);
  EXPECT_GT(s.result["effective"]["particle_von_mises"]["value"].get<double>(), 0.42e9);
  EXPECT_TRUE(balances("Yielding", s));
  EXPECT_EQ(s.result["inputs"]["particle"]["swift_exponent"], 0.3);
}

TEST(OwnLaws_behaviour, are_in_manual_and_choices_and_refuse_entries_that_are_not_theirs) {
  const std::string manual = case_reference();
  for (const char* said : {"`Kinetic friction coefficient`", "`Weakening distance`", "`Swift exponent`",
                           "`Adhesion plateau`", "patch_potentials \\| trapezoidal \\| van_der_waals"})
    EXPECT_NE(manual.find(said), std::string::npos) << said;
  EXPECT_NE(case_template().find("set Weakening distance = 0 m"), std::string::npos);
  const test::TemporaryFolder folder;
  CaseInput input = weakened_sliding(folder.path);
  EXPECT_EQ(input.physical_entries.at("Interface/Weakening distance"), "50 nm");
  input.interface.parameters["Shear strength"] = 1e9;
  const auto message = [&] { return test::message_of<InputError>([&] { check_case(input); }); };
  EXPECT_NE(message().find("no law of friction takes just "), std::string::npos) << message();
  EXPECT_NE(message().find(
                "Slip weakening (Friction coefficient, Kinetic friction coefficient and Weakening distance)"),
            std::string::npos)
      << message();
  input.interface.parameters.erase("Shear strength");
  EXPECT_NO_THROW(check_case(input));
  input.particle.parameters = {
      {"Yield stress", 1e9}, {"Swift strain", 0.01}, {"Swift exponent", 0.2}, {"Voce rate", 3}};
  EXPECT_NE(message().find("no law of a body takes just "), std::string::npos) << message();
}

}  // namespace

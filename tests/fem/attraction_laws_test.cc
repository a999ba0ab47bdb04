// Attraction of liquid bridges and of patches of potential: their equations, spheres by Derjaguin's integral
// over the gap, and contacts that are solved.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "dem_compare/laws/maugis_dugdale.h"
#include "fem/interface/adhesion/capillary_bridge.h"
#include "fem/interface/adhesion/patch_potentials.h"
#include "tests/fem/support/glass_sphere.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace asperity;

LawValues water(double humidity, double angle = 0) {
  return with_defaults(fem::capillary_entries(), {{"Relative humidity", humidity}, {"Contact angle", angle}});
}

test::Verified of_attraction(const std::string& what, const char* source) {
  return {"Adhesion", what, source};
}

/// Of a rigid sphere whose lowest point is `apart` above a plane: the law's stress over the sphere's own gap
/// [N].
double pull_of_rigid_sphere(const fem::AdhesionLaw& law, double radius, double apart) {
  // Even steps of the logarithm of the gap's growth, where the stress changes.
  const double widest = std::min(law.range(), 0.5 * radius), smallest = 1e-6 * widest;
  constexpr int steps = 20000;
  const double ratio = std::pow(widest / smallest, 1.0 / steps);
  double force = 0, before = 0;
  for (double rise = smallest; before < widest; rise *= ratio) {
    const double middle = 0.5 * (before + rise);
    // 2 pi r dr, with (r/R)^2 = 1 - (1 - rise/R)^2.
    force += 2 * M_PI * (radius - middle) * (rise - before) * law.at(apart + middle).stress;
    before = rise;
  }
  return force;
}

TEST(CapillaryBridge_analytic, has_kelvins_radius_and_suction_and_the_work_of_its_menisci) {
  const fem::KelvinMeniscus half(water(0.5));
  EXPECT_TRUE(of_attraction("Kelvin's radius of water at 20 C and 50 %",
                            "0.54 nm/ln(1/RH), Israelachvili (2011) ch. 17")
                  .within(half.radius(), 0.54e-9 / std::log(2.0), 0.01));
  test::Largest suction, force;
  for (const double humidity : {0.1, 0.5, 0.9})
    for (const double angle : {0.0, 1.0}) {
      const LawValues values = water(humidity, angle);
      InterfaceInput input;
      input.adhesion_law = "capillary", input.parameters = values;
      const auto law = fem::make_adhesion_laws(input).closing;
      const double gas = 8.314462618 * 293.15;
      suction.count(law->at(0).stress / (gas / 18.05e-6 * std::log(1 / humidity)) - 1);
      const double R = 8.5e-6;
      force.count(pull_of_rigid_sphere(*law, R, 0) / (4 * M_PI * R * 72.8e-3 * std::cos(angle)) - 1);
      EXPECT_DOUBLE_EQ(law->at(law->range()).stress, 0);
    }
  EXPECT_TRUE(of_attraction("suction of bridges at 10 to 90 %", "R T/V_m ln(1/RH)").below(suction, 1e-9));
  EXPECT_TRUE(of_attraction("rigid sphere at contact under suction of bridges", "4 pi R gamma cos(theta)")
                  .below(force, 2e-3));
}

TEST(PatchPotentials_analytic, are_a_plate_capacitor_near_and_fall_exponentially_far) {
  constexpr double eps0 = fem::PatchPotentials::permittivity, V = 0.2, L = 100e-9, d = 1e-9;
  const double k = M_PI / L;
  const fem::PatchPotentials law(fem::PatchPotentials::work(V, L, d), L, d);
  test::Largest far;
  for (const double z : {200e-9, 300e-9})
    far.count(law.at(z - d).stress / (2 * eps0 * V * V * k * k * std::exp(-2 * k * z)) - 1);
  EXPECT_TRUE(
      of_attraction("patches: stress beyond their size", "2 eps0 V^2 k^2 exp(-2 k z)").below(far, 1e-4));
  EXPECT_TRUE(of_attraction("patches: stress of films of 1 nm in contact", "eps0 V^2/(2 d^2)")
                  .within(law.at(0).stress, eps0 * V * V / (2 * d * d), 1e-3));
  constexpr double wide = 1e-3, R = 50e-6;
  const fem::PatchPotentials uniform(fem::PatchPotentials::work(V, wide, d), wide, d);
  test::Largest force;
  for (const double apart : {0.0, 4e-9, 29e-9})
    force.count(pull_of_rigid_sphere(uniform, R, apart) / (M_PI * eps0 * R * V * V / (d + apart)) - 1);
  EXPECT_TRUE(of_attraction("sphere and plane of uniform potential, z/R up to 6e-4",
                            "pi eps0 R V^2/z, proximity approximation")
                  .below(force, 0.01));
}

TEST(AdhesionLaws_behaviour, with_a_work_of_their_own_refuse_another_and_entries_of_other_laws) {
  InterfaceInput input;
  input.adhesion_law = "capillary", input.parameters = {{"Relative humidity", 0.5}};
  EXPECT_NEAR(fem::work_of_adhesion(input).closing, 2 * 72.8e-3, 1e-12);
  EXPECT_EQ(fem::work_entries_of_law(input).at("Interface/Work of adhesion"), "145.6 mJ/m^2");
  const auto message = [&] { return test::message_of<InputError>([&] { fem::make_adhesion_laws(input); }); };
  EXPECT_NO_THROW(fem::make_adhesion_laws(input));
  input.work_of_adhesion = 0.1;
  EXPECT_NE(message().find("leave out Work of adhesion"), std::string::npos) << message();
  input.work_of_adhesion = 0, input.parameters["Patch size"] = 1e-7;
  EXPECT_NE(message().find("Interface/Patch size is given, and Adhesion law = capillary does not take it"),
            std::string::npos)
      << message();
  input.parameters = {};
  EXPECT_NE(message().find("e.g. Relative humidity = 50 %"), std::string::npos) << message();
}

CaseInput drawn_off(const std::filesystem::path& folder, const std::string& interface,
                    const std::string& steps) {
  return test::glass_case(folder, interface, "set Control = displacement\n" + steps,
                          "set Interface spacing = 40 nm\n");
}

struct DrawnOff {
  std::vector<double> force, approach, area;
  explicit DrawnOff(const test::SolvedExperiment& s)
      : force(s.history.numbers("normal_force [N]")),
        approach(s.history.numbers("normal_displacement [m]")),
        area(s.history.numbers("contact_area [m^2]")) {}
};

TEST(CapillaryBridge_analytic, pulls_a_solved_sphere_as_its_meniscus_says) {
  const test::TemporaryFolder folder;
  const CaseInput input = drawn_off(
      folder.path, "set Adhesion law = capillary\n set Relative humidity = 80 %\n",
      "set Normal approach = 2 nm\n set Load steps = 4\n set Unload steps = 36\n set Retract = 7 nm\n");
  const auto s = test::solve_experiment(input, folder.path / "solved");
  const DrawnOff drawn(s);
  const fem::KelvinMeniscus meniscus(water(0.8));
  const double largest = -*std::min_element(drawn.force.begin(), drawn.force.end()),
               limit = 4 * M_PI * input.radius * 72.8e-3;
  const MaugisDugdale maugis{test::GlassSphere::reduced_modulus, input.radius, meniscus.work(),
                             meniscus.work() / meniscus.height()};
  EXPECT_TRUE(of_attraction("bridge of water at 80 %: pull-off", "Maugis (1992), lambda 0.12")
                  .within(largest, maugis.pull_off_force(), 0.03));
  EXPECT_TRUE(of_attraction("bridge of water at 80 %: pull-off", "4 pi R gamma, DMT's limit")
                  .within(largest, limit, 0.06));
  EXPECT_TRUE(test::leaves_no_energy_open("Adhesion", "bridge of water at 80 %", s));
}

/// Bridges that form on contact pull only on the way back; what that costs is dissipated as they form.
TEST(CapillaryBridge_behaviour, that_forms_on_contact_has_a_hysteresis_that_balances) {
  const test::TemporaryFolder folder;
  const CaseInput input = drawn_off(
      folder.path,
      "set Adhesion law = capillary\n set Relative humidity = 80 %\n set Condensation = on contact\n",
      "set Normal approach = 4 nm\n set Load steps = 16\n set Unload steps = 40\n set Retract = 8 nm\n");
  const auto s = test::solve_experiment(input, folder.path / "solved");
  const DrawnOff drawn(s);
  const double least = *std::min_element(drawn.force.begin(), drawn.force.end());
  for (std::size_t k = 0; k < 16; ++k) EXPECT_GT(drawn.force[k], 0.5 * least) << k;
  EXPECT_LT(least, -1e-6);
  const double lost = s.history.numbers("adhesion_loss [J]").back();
  EXPECT_GT(lost, 0);
  EXPECT_NEAR(drawn.force.back(), 0, 1e-3 * std::abs(least));
  EXPECT_TRUE(test::leaves_no_energy_open("Adhesion", "bridge that forms on contact", s, 0.02));
}

TEST(PatchPotentials_analytic, pull_a_solved_sphere_as_two_pi_R_of_their_work) {
  const test::TemporaryFolder folder;
  const CaseInput input = drawn_off(
      folder.path,
      "set Adhesion law = patch_potentials\n set Patch potential = 1 V\n set Patch size = 20 nm\n"
      " set Insulating film = 1 nm\n",
      "set Normal approach = 1 nm\n set Load steps = 4\n set Unload steps = 32\n set Retract = 7 nm\n");
  const auto s = test::solve_experiment(input, folder.path / "solved");
  const DrawnOff drawn(s);
  const auto law = fem::make_adhesion_laws(input.interface).closing;
  test::Largest error;
  for (std::size_t k = 0; k < drawn.force.size(); ++k)
    if (drawn.area[k] == 0 && drawn.approach[k] < -1e-9)
      error.count(drawn.force[k] / (-2 * M_PI * input.radius * law->at(-drawn.approach[k]).work) - 1);
  EXPECT_TRUE(of_attraction("patches, spheres apart: force", "Derjaguin (1934)").within(1 + error, 1, 0.04));
  EXPECT_TRUE(test::leaves_no_energy_open("Adhesion", "patches", s));
}

}  // namespace

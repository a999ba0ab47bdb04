// Path, mesh and steps that are left to the program, of contacts that attraction or a film makes wider than
// Hertz'.
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "core/hertz_separation.h"
#include "fem/case/case_setup.h"
#include "tests/fem/support/solved_experiment.h"
#include "tests/fem/support/sphere_on_silicon.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/verification.h"

namespace asperity {
namespace {

using test::sphere_on_silicon;

CaseInput moved(const std::string& substrate, double spacing, Motion motion) {
  CaseInput input = sphere_on_silicon("smooth", substrate, spacing, 0);
  input.interface.parameters["Friction coefficient"] = 0.3;
  input.experiment.type = motion;
  return input;
}

TEST(WidenedContact_analytic, derives_paths_of_contacts_that_attraction_or_a_film_widens) {
  CaseInput input = moved("smooth", 25e-9, Motion::rolling);
  const double pressed = fem::with_derived_path_length(input).experiment.distance;
  CaseInput filmed = input;
  filmed.particle.film.thickness = 1e-6;
  filmed.particle.film.youngs_modulus = 1e9, filmed.particle.film.poisson_ratio = 0.3;
  // Nearly all of the contact is the film's, of a modulus of 1.1 GPa beside one of 56 GPa.
  EXPECT_GT(fem::with_derived_path_length(filmed).experiment.distance, 2 * pressed);

  input.interface.work_of_adhesion = 0.1;
  input.interface.parameters["Adhesion range"] = 1e-9;
  // Where the load is large beside the pull-off force attraction does not matter.
  input.experiment.normal_load = 10e-3;
  EXPECT_NEAR(fem::with_derived_path_length(input).experiment.distance,
              5 * hertz_of(input).contact_radius(input.experiment.normal_load), 1e-12);  // the cap ends
  // A particle that nothing but its adhesion presses: a^3 = 6 pi w R^2/K (Johnson, Kendall & Roberts 1971).
  input.experiment.normal_load = 1e-12;
  const double R = input.radius, stiffness = 4.0 / 3 * hertz_of(input).reduced_modulus,
               a = std::cbrt(6 * M_PI * 0.1 * R * R / stiffness), force = stiffness * a * a * a / R;
  EXPECT_NEAR(fem::with_derived_path_length(input).experiment.distance / (5 * a), 1, 1e-3);
  input.experiment.type = Motion::torsion;
  const auto shear = [](const BodyInput& b) { return b.youngs_modulus / (2 * (1 + b.poisson_ratio)); };
  const double compliance = 1 / shear(input.particle) + 1 / shear(input.substrate);
  EXPECT_NEAR(fem::with_derived_path_length(input).experiment.angle /
                  (2.56 * input.interface.parameters["Friction coefficient"] * force * compliance / (a * a)),
              1, 1e-3);
}

TEST(WidenedContact_analytic, meshes_a_contact_that_little_but_its_attraction_presses) {
  CaseInput input = moved("smooth", 0, Motion::sliding);
  input.interface.work_of_adhesion = 0.1;
  input.interface.parameters["Adhesion range"] = 3e-9;
  input.experiment.normal_load = 1e-12;
  const fem::CaseSetup setup = fem::set_up_sizes(fem::with_derived_path_length(input));
  // a^3 = 2 pi w R^2/K (Derjaguin, Muller & Toporov 1975), which Hertz' approach of 2 pi w R/K a presses.
  const double R = input.radius, stiffness = 4.0 / 3 * hertz_of(input).reduced_modulus,
               bears = 2 * M_PI * 0.1 * R, a = std::cbrt(bears * R / stiffness);
  EXPECT_NEAR(setup.least_radius / a, 1, 1e-6);
  EXPECT_NEAR(setup.system.mesh.sizes.spacing_particle, a / 12, 1e-12);
  EXPECT_NEAR(setup.motion.contact_radius / a, 1, 1e-6);
  // Surfaces that far apart attract each other still.
  EXPECT_GT(hertz_separation(setup.system.mesh.sizes.region_particle, a, R), 3e-9);

  CaseInput rough =
      moved("generated(rms=5 nm, hurst=0.8, rolloff=400 nm, cutoff=100 nm, seed=4)", 0, Motion::normal);
  rough.experiment.normal_load = 1e-9;
  const std::string message = test::message_of<InputError>([&] { fem::set_up_sizes(rough); });
  EXPECT_NE(message.find("raise the load"), std::string::npos) << message;
  rough.mesh.interface_spacing = 10e-9;
  EXPECT_NO_THROW(fem::set_up_sizes(rough));
}

/// Path, mesh and steps as they are derived: rolled, the contact closes by the one work and opens by the
/// other, over its width. Where the region ends within the attraction the moment rises towards the end of the
/// path.
TEST(WidenedContactNightly_analytic, a_particle_that_its_adhesion_presses_is_resisted_as_Kendall_says) {
  const test::TemporaryFolder folder;
  CaseInput input = moved("smooth", 0, Motion::rolling);
  input.interface.work_of_adhesion = 0.05, input.interface.work_of_separation = 0.1;
  input.interface.parameters["Adhesion range"] = 2e-9;
  input.experiment.normal_load = 1e-12;
  input.experiment.load_steps = 3;
  input.experiment.reverse = input.experiment.unload = false;
  input.output.fields = false;
  const auto solved = test::solve_experiment(input, folder.path);
  const auto moment = solved.history.numbers("rolling_moment [N m]"),
             area = solved.history.numbers("contact_area [m^2]");
  test::Largest off;
  for (std::size_t k = moment.size() / 2; k < moment.size(); ++k)
    off.count(moment[k] / (0.05 * 2 * std::sqrt(area[k] / M_PI) * input.radius) - 1);
  EXPECT_TRUE((test::Verified{"Rolling", "a particle under 1 pN, work of adhesion 50 and 100 mJ/m^2: moment",
                              "Kendall (1975)"}
                   .below(100 * off, 1.5, "%")));
}

/// A mesh that is fine on the whole path would have more than 4 million unknowns.
TEST(WidenedContact_behaviour, rolls_a_long_way_on_a_mesh_that_travels) {
  CaseInput input = moved("smooth", 0, Motion::rolling);
  input.experiment.distance = 5.8e-6;
  input.experiment.normal_load = 0.05e-6;
  EXPECT_NO_THROW(fem::set_up_sizes(input));
  input.mesh.along_path = "whole";
  EXPECT_THROW(fem::set_up_sizes(input), InputError);
}

}  // namespace
}  // namespace asperity

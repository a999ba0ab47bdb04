// The finely meshed region holds the contact, also of a body that flows; where it does not, the solver says
// so.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/csv.h"
#include "fem/case/case_setup.h"
#include "fem/solve_case.h"
#include "tests/fem/support/sphere_on_silicon.h"
#include "tests/support/shared_files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity;

/// A sphere of 71 GPa that yields on a plane that is a thousand times stiffer. Its contact radius at first
/// yield is 1 % of its own: p0 = 2 E* a/(pi R) = 1.295 exp(0.736 nu) Y (Jackson & Green 2005, eq. 3).
struct FlowingSphere {
  CaseInput input = test::sphere_on_silicon("smooth", "smooth", 0, 0);
  double modulus, radius_at_yield, force_at_yield;

  explicit FlowingSphere(double poisson) {
    constexpr double radius_of_sphere = 0.01, stiffer = 1000;
    input.particle.poisson_ratio = poisson;
    input.substrate.youngs_modulus = stiffer * input.particle.youngs_modulus;
    const double e = input.particle.youngs_modulus, nu = input.substrate.poisson_ratio;
    modulus = 1 / ((1 - poisson * poisson) / e + (1 - nu * nu) / (stiffer * e));
    radius_at_yield = radius_of_sphere * input.radius;
    force_at_yield = 4.0 / 3 * modulus * std::pow(radius_at_yield, 3) / input.radius;
    input.particle.parameters["Yield stress"] =
        2 * modulus * radius_of_sphere / M_PI / (1.295 * std::exp(0.736 * poisson));
  }
};

TEST(MeshedRegion_other_code, holds_the_contact_of_a_sphere_that_flows) {
  const CsvTable table = read_csv(test::reference_table("02_elastoplastic_table_ownFE.csv"));
  double outermost = 0;
  for (const char* poisson : {"0.17", "0.25", "0.3"}) {
    FlowingSphere sphere(std::stod(poisson));
    const auto depth = table.numbers("w/wc"), force = table.numbers(std::string("F/Fc_nu") + poisson),
               area = table.numbers(std::string("A/Ac_nu") + poisson);
    for (std::size_t i = 0; i < force.size(); ++i) {
      const double radius = std::sqrt(area[i]) * sphere.radius_at_yield;
      constexpr double shallow = 0.15;  // of the sphere's radius: beyond, small strain ends
      if (!std::isfinite(radius) || radius > shallow * sphere.input.radius) continue;
      auto& experiment = sphere.input.experiment;
      experiment.normal_load = force[i] * sphere.force_at_yield;
      experiment.normal_approach =
          depth[i] * sphere.radius_at_yield * sphere.radius_at_yield / sphere.input.radius;
      for (const auto control : {ExperimentInput::Control::force, ExperimentInput::Control::displacement}) {
        experiment.control = control;
        const auto sizes = fem::set_up_sizes(sphere.input).system.mesh.sizes;
        outermost = std::max(outermost, (radius + sizes.spacing_particle) / sizes.region_particle);
      }
    }
  }
  EXPECT_TRUE((test::Verified{"Meshes", "radius of a flowing contact and a cell over the meshed region's",
                              "axisymmetric finite elements"}
                   .between(outermost, 0.8, 1)));
}

std::vector<std::string> said_under(const CaseInput& input) {
  const test::TemporaryFolder folder;
  SolveOptions options;
  options.output = folder.path;
  std::vector<std::string> lines;
  options.progress = [&](const std::string& line) {
    if (line.find("edge of the finely meshed region") != std::string::npos) lines.push_back(line);
  };
  solve_case(input, options);
  return lines;
}

TEST(MeshedRegion_behaviour, a_contact_that_outgrows_it_is_said_once_with_the_remedy) {
  // Asperities of 5 nm touch well beyond Hertz' contact.
  CaseInput input = test::sphere_on_silicon(
      "smooth", "generated(rms=5 nm, hurst=0.8, rolloff=300 nm, cutoff=150 nm, seed=2)", 45e-9, 0);
  input.mesh.layers = 2;
  input.solver.threads = 1;
  input.experiment.load_steps = 3, input.experiment.unload = false;
  input.output.fields = false;
  EXPECT_TRUE(said_under(input).empty());
  input.mesh.contact_region = 230e-9;
  const auto lines = said_under(input);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NE(lines.front().find("larger Mesh/Contact region"), std::string::npos) << lines.front();
}

}  // namespace

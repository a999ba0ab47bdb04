// Large local friction between rough bodies that yield, where updates of the tractions can alternate between
// stick and slip of a row for ever.
#include <gtest/gtest.h>

#include "tests/fem/support/solved_experiment.h"
#include "tests/fem/support/sphere_on_silicon.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity;

/// Roughness of 2.7 nm RMS above waves of 72 nm, yielding, under attraction.
CaseInput rough_yielding_contact(double friction) {
  const auto surface = [](const char* rms, const char* rolloff, const char* seed) {
    return std::string("generated(rms=") + rms + ", window=2.5 um, hurst=0.8, rolloff=" + rolloff +
           ", cutoff=72 nm, seed=" + seed + ")";
  };
  CaseInput input =
      test::sphere_on_silicon(surface("0.7 nm", "500 nm", "1"), surface("2.7 nm", "200 nm", "2"), 18e-9, 0);
  input.particle.parameters["Yield stress"] = 3e9;
  input.substrate.parameters["Yield stress"] = 4e9;
  input.interface.parameters["Friction coefficient"] = friction;
  input.interface.parameters["Adhesion range"] = 1e-9;
  input.interface.work_of_adhesion = input.interface.work_of_separation = 0.186;
  input.interface.adhesion_law = "dugdale";
  input.experiment.type = Motion::sliding;
  input.experiment.load_steps = 5;
  input.experiment.unload = input.experiment.reverse = false;
  input.experiment.distance = 60e-9;
  input.output.fields = false;
  return input;
}

TEST(LargeFrictionNightly_behaviour, slides_to_its_end_with_its_energy_balanced) {
  const test::TemporaryFolder folder;
  const auto s = test::solve_experiment(rough_yielding_contact(0.65), folder.path);
  EXPECT_TRUE(
      (test::Verified{"Sliding", "2.7 nm, yielding, local friction 0.65: energy left open", "balance"}.below(
          100 * s.result["balance"]["energy"].get<double>(), 1, "%")));
  // Attraction adds to the friction of the load alone.
  EXPECT_GT(s.history.numbers("lateral_force [N]").back(), 0.65 * 100e-6);
}

}  // namespace

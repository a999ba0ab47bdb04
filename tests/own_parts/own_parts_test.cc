// What a user adds in one file of his own is made, listed and used like what asperity has: own_law.cc,
// own_engine.cc, own_experiment.cc. Nothing here or elsewhere includes or names these files' contents but by
// their registered names.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dem_compare/experiments/from_parameters.h"
#include "dem_compare/experiments/particle_experiment.h"
#include "dem_compare/experiments/quasi_static.h"
#include "dem_compare/laws/law_curve.h"
#include "engines/engine_input.h"
#include "tests/engines/canonical_contact.h"

namespace asperity {
namespace {

constexpr double pi = M_PI;

ContactParameters silicon() { return read_contact_parameters(test::paper_run("parameters_silicon.json")); }

TEST(OwnLaw_analytic, is_made_listed_and_leads_a_contact) {
  EXPECT_NE(reduced_laws_manual().find("## normal: `elastic_foundation`"), std::string::npos);
  const double k = 4e17;
  const ContactParameters record = silicon();
  ReducedLawOptions options;
  options.laws.push_back(parse_law("elastic_foundation, foundation_modulus = 4e17"));
  const ContactModel contact = contact_model(record, options);
  const double load = 1e-4, approach = contact.normal->approach(load);
  EXPECT_NEAR(pi * k * record.effective_radius() * approach * approach / load, 1, 1e-12);
  LoopProgram program;
  program.normal_load = load;
  const LoopNumbers numbers =
      measure(simulate_quasi_static(make_particle("glued", {contact, contact}), program));
  EXPECT_NEAR(numbers.plateau / record.sliding_limit(load), 1, 1e-6);
  LawCurveOptions reach;
  reach.reach = approach;
  const LawCurve curve = curve_of(law_of_contact(options.laws[0], record), reach);
  EXPECT_NEAR(curve.columns[1].back() / load, 1, 1e-12);
}

TEST(OwnEngine_behaviour, is_listed_and_writes_its_input) {
  const auto names = engine_input_names();
  EXPECT_EQ(std::count(names.begin(), names.end(), "own"), 1);
  EngineInputOptions options;
  options.load = 1e-4;
  const ContactParameters record = silicon();
  const std::string input = engine_input("own", record, options);
  ASSERT_EQ(input.rfind("friction ", 0), 0u) << input;
  EXPECT_NEAR(std::stod(input.substr(9)) / (record.sliding_limit(1e-4) / 1e-4), 1, 1e-6);
}

TEST(OwnExperiment_analytic, is_listed_and_run) {
  const auto& all = particle_experiments();
  EXPECT_EQ(
      std::count_if(all.begin(), all.end(), [](const auto& known) { return known.name == "glued_rail"; }), 1);
  const ContactModel contact = contact_model(silicon());
  const double angle = pi / 4, flank_load = 1e-4;
  LoopProgram program;
  program.normal_load = 2 * std::cos(angle) * flank_load;
  const LoopNumbers numbers =
      measure(simulate_quasi_static(make_particle("glued_rail", {contact, contact, angle}), program));
  EXPECT_NEAR(numbers.plateau / (2 * silicon().sliding_limit(flank_load)), 1, 1e-6);
}

}  // namespace
}  // namespace asperity

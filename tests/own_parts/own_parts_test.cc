// What a user adds in one file of his own is made, listed and used like what asperity has: own_law.cc,
// own_engine.cc, own_experiment.cc, own_effect.cc. Nothing here or elsewhere includes or names these files'
// contents but by their registered names.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "dem_compare/experiments/from_parameters.h"
#include "dem_compare/experiments/particle_experiment.h"
#include "dem_compare/experiments/quasi_static.h"
#include "dem_compare/laws/law_curve.h"
#include "diagnosis/catalogue/effect.h"
#include "diagnosis/diagnose.h"
#include "engines/engine_input.h"
#include "tests/diagnosis/support/made_recording.h"
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

/// Hertz' contact whose displacement was read with a periodic error.
Recording read_periodically(double amplitude, double period, double noise) {
  Recording r;
  r.mode = Motion::normal;
  r.particle = test::borosilicate();
  r.substrate = test::silicon();
  RecordingTable table;
  table.file = "indentation.csv";
  table.control = {"normal_displacement"};
  table.response = "normal_force";
  const Hertz hertz = test::experiment(Motion::normal).hertz();
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int i = 0; i <= 600; ++i) {
    const double d = 60e-9 * (i <= 300 ? i / 300.0 : (600 - i) / 300.0);
    table.columns["time"].push_back(0.1 * i);
    table.columns["normal_displacement"].push_back(d);
    const double contact = std::max(0.0, d - amplitude * std::sin(2 * pi * d / period));
    table.columns["normal_force"].push_back(hertz.force(contact) + noise * normal(random));
    table.segment.push_back(i <= 300 ? "load" : "unload");
  }
  r.tables = {table};
  return r;
}

TEST(OwnEffect_analytic, is_listed_and_named_with_its_amplitude) {
  EXPECT_NE(effects_manual().find("## periodic_reading\n"), std::string::npos);
  const double amplitude = 0.8e-9;
  const Diagnosis d = diagnose(read_periodically(amplitude, 15e-9, 10e-6));
  ASSERT_EQ(d.verdict, Verdict::explained) << diagnosis_json(d);
  ASSERT_EQ(d.left_out.size(), 1u);
  EXPECT_EQ(d.left_out[0].id, "periodic_reading");
  const DiagnosedParameter& found = d.left_out[0].parameters[0];
  EXPECT_LE(found.low, amplitude);
  EXPECT_GE(found.high, amplitude);
}

}  // namespace
}  // namespace asperity

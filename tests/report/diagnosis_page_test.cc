// The page of a diagnosis: what it shows where nothing is named.
#include "report/diagnosis/diagnosis_page.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

Recording of_gel() {
  Recording r;
  r.title = "<b>gel</b>";
  r.particle.material = "glass";
  r.particle.radius = 8e-6;
  r.substrate.youngs_modulus = 20e3;
  return r;
}

Diagnosis unexplained() {
  Diagnosis d;
  d.verdict = Verdict::unexplained;
  d.baseline.chi2_reduced = d.improved.chi2_reduced = 4860;
  d.with_nearest.chi2_reduced = 196;
  d.baseline.rms["normal_force"] = 9e-9, d.with_nearest.rms["normal_force"] = 2e-9;
  d.nearest = {{"fluid_drag",
                "Drag of the fluid",
                "",
                "",
                "",
                EffectKind::instrument,
                0,
                {{"coefficient", "N s/m", 1e-4, 0, 0}},
                {},
                {}}};
  d.compared = {{"curve.csv",
                 "normal_force",
                 "N",
                 "normal_displacement",
                 "m",
                 {0, 1e-9, 2e-9},
                 {0, 1e-9, 3e-9},
                 {0, 0, 1e-9},
                 {0, 1e-9, 2e-9},
                 {1e-10, 1e-10, 1e-10},
                 {0, 0, 0},
                 {"load", "load", "load"},
                 false}};
  return d;
}

TEST(DiagnosisPage_behaviour, shows_the_nearest_of_an_unexplained_recording_as_no_answer) {
  const std::string page = report::diagnosis_page(of_gel(), unexplained());
  for (const char* part : {"Drag of the fluid", "100 µN s/m", "nearest, not named", "196", "2 nN",
                           "neither its names nor its numbers are an answer", "(glass) on a body of 20 kPa"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  EXPECT_EQ(page.find("<b>gel"), std::string::npos);
}

TEST(DiagnosisPage_behaviour, draws_the_simulation_alone_where_nothing_is_near) {
  Diagnosis d = unexplained();
  d.nearest.clear();
  const std::string page = report::diagnosis_page(of_gel(), d);
  EXPECT_EQ(page.find("nearest"), std::string::npos);
  EXPECT_EQ(page.find("196"), std::string::npos);
}

TEST(DiagnosisPage_behaviour, shows_what_was_not_solved_to_its_end_as_not_confirmed) {
  Diagnosis d = unexplained();
  d.verdict = Verdict::ambiguous;
  d.remaining =
      d.mismatch = {{"curve.csv", "normal_force", "load", "normal_displacement", "m", 0, 1e-9, 5, 0, 0.4}};
  AlternativeExplanation open;
  open.effects = d.nearest;
  open.probability = 1;
  open.told_apart_by = "a longer --minutes";
  d.alternatives = {open};
  d.nearest.clear();
  const std::string page = report::diagnosis_page(of_gel(), d);
  for (const char* part : {"what fits could not be solved to its end", "Nothing is named", "not confirmed",
                           "fluid_drag", "a longer --minutes"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  for (const char* part : {"if the likeliest is right", "With what is named", "99 %"})
    EXPECT_EQ(page.find(part), std::string::npos) << part;
}

}  // namespace
}  // namespace asperity

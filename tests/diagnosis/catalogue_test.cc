// The catalogue: its names are fixed by the format, its manual page is what it prints.
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "diagnosis/catalogue/effect.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

TEST(Catalogue_behaviour, holds_every_effect_of_the_format_by_its_name) {
  for (const auto& id : {"instrument_compliance",
                         "contact_point_offset",
                         "thermal_drift",
                         "adhesion",
                         "effective_radius",
                         "bulk_plasticity",
                         "roughness_compliance",
                         "creep",
                         "lateral_compliance",
                         "adhesion_offset",
                         "static_friction_peak",
                         "velocity_dependence",
                         "partial_slip",
                         "surface_tilt",
                         "lateral_zero_offset",
                         "area_proportional_friction",
                         "run_in",
                         "stick_slip",
                         "rolling_adhesion_offset",
                         "contact_radius_scaling",
                         "roughness_dependent_rolling",
                         "viscous_rolling",
                         "torsion_resistance",
                         "adhesion_hysteresis",
                         "baseline_tilt",
                         "rate_and_state",
                         "pop_in",
                         "film",
                         "capillary",
                         "electrostatic",
                         "viscoelasticity",
                         "detector_nonlinearity",
                         "actuator_hysteresis",
                         "clipping",
                         "constant_lateral_force",
                         "friction_by_roughness",
                         "friction_by_humidity",
                         "two_term_friction",
                         "indentation_size",
                         "normal_zero_offset",
                         "fluid_drag"})
    EXPECT_EQ(effect_of(id).id(), id);
}

TEST(Catalogue_behaviour, every_effect_says_what_it_is_and_keeps_its_starts_within_its_bounds) {
  std::set<std::string> ids;
  for (const auto& effect : effect_catalogue()) {
    const EffectDescription& d = effect->description();
    EXPECT_TRUE(ids.insert(d.id).second) << d.id;
    EXPECT_FALSE(d.title.empty() || d.equation.empty() || d.source.empty() || d.meaning.empty() ||
                 d.modes.empty())
        << d.id;
    for (const Motion mode : d.modes) {
      Experiment e = test::experiment(mode);
      e.hold_duration = 20;
      for (const auto& p : effect->parameters(e)) {
        EXPECT_LT(p.low, p.high) << d.id << " " << p.name;
        EXPECT_FALSE(p.starts.empty()) << d.id << " " << p.name;
        EXPECT_FALSE(p.logarithmic && p.low <= 0) << d.id << " " << p.name;
        for (const double start : p.starts)
          EXPECT_TRUE(start >= p.low && start <= p.high) << d.id << " " << p.name;
      }
    }
  }
}

TEST(Catalogue_behaviour, an_effect_is_shown_only_by_as_many_values_as_it_needs) {
  const Effect& effect = effect_of("roughness_dependent_rolling");
  Samples samples = test::row(test::experiment(Motion::rolling), 1e-3);
  Recording recording;
  recording.mode = Motion::rolling;
  recording.tables.emplace_back();
  // The fourth differs from the third by less than a tenth.
  for (const double rms : {0.3e-9, 0.9e-9, 2.7e-9, 2.8e-9}) {
    samples.list.push_back(samples.list.front());
    samples.list.back().rms_roughness = rms;
  }
  samples.list.erase(samples.list.begin());
  samples.runs[0].end = samples.list.size();
  EXPECT_EQ(experiment_of(recording, samples).different.at("rms_roughness"), 3);
  EXPECT_EQ(experiment_of(recording, samples).different.at("radius"), 1);
  EXPECT_FALSE(effect.is_shown_by(experiment_of(recording, samples)));
  samples.list.back().rms_roughness = 5e-9;
  EXPECT_EQ(experiment_of(recording, samples).different.at("rms_roughness"), 4);
  EXPECT_TRUE(effect.is_shown_by(experiment_of(recording, samples)));
  EXPECT_FALSE(effect.is_shown_by(test::experiment(Motion::sliding)));
}

TEST(Catalogue_behaviour, manual_page_is_current) {
  std::ifstream file(std::string(ASPERITY_SOURCE_DIR) + "/docs/effects.md");
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_EQ(text.str(), effects_manual(Equations::typeset))
      << "write it anew: asperity diagnose --catalogue --typeset > docs/effects.md";
}

}  // namespace
}  // namespace asperity

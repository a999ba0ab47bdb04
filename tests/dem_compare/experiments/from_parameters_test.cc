#include "dem_compare/experiments/from_parameters.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "dem_compare/experiments/particle_experiment.h"
#include "dem_compare/experiments/quasi_static.h"
#include "engines/experiment.h"

namespace asperity {
namespace {

EffectiveQuantity number(double value) {
  EffectiveQuantity quantity;
  quantity.value = value;
  return quantity;
}

ContactParameters parameters(double reduced_modulus, double shear_modulus) {
  ContactParameters record;
  record.file = "parameters.json";
  record.particle.radius = 8.5e-6;
  record.particle.density = 2230;
  record.target.radius = std::numeric_limits<double>::infinity();
  record.reduced_modulus = number(reduced_modulus);
  record.reduced_shear_modulus = number(shear_modulus);
  record.sliding_friction = number(0.23);
  record.sliding_offset = number(12e-6);
  record.rolling_friction = number(7.9e-4);
  record.rolling_friction->length_scale = LengthScale::particle_radius;
  record.rolling_offset = number(571.4e-6);
  record.torsion_friction = number(0.0056);
  record.torsion_friction->length_scale = LengthScale::particle_radius;
  record.torsion_offset = number(0);
  for (auto* stiffness : {&record.rolling_stiffness, &record.torsion_stiffness}) {
    *stiffness = number(1.56385e-6);
    (*stiffness)->length_scale = LengthScale::contact_radius;
    (*stiffness)->at_load = 1e-4;
  }
  return record;
}
ContactParameters silicon() { return parameters(52.8684e9, 11.7989e9); }
ContactParameters diamond() { return parameters(68.7268e9, 15.6407e9); }

/// The two ways to the same numbers: increments of equilibrium here, closed form in engines/experiment.h.
void expect_closed_form(Motion type, const SingleParticle& particle, double angle = 0) {
  EngineExperiment experiment;
  experiment.type = type;
  experiment.substrate = silicon();
  experiment.indenter = diamond();
  experiment.load = 5e-4;
  experiment.rail_angle = angle;
  const ClosedForm law = closed_form(experiment);
  LoopProgram program;
  program.normal_load = experiment.indenter_load();
  const LoopNumbers numbers = measure(simulate_quasi_static(particle, program));
  EXPECT_NEAR(numbers.initial_slope / law.slope, 1, 1e-5);
  EXPECT_NEAR(numbers.reversal_slope / law.slope, 1, 1e-5);
  EXPECT_NEAR(numbers.plateau / law.plateau, 1, 1e-6);
}

TEST(FromParameters_analytic, glued_and_rolling_spheres_agree_with_the_closed_form) {
  const ContactModel below = contact_model(silicon()), above = contact_model(diamond());
  expect_closed_form(Motion::sliding, make_particle("glued", {below, below}));
  expect_closed_form(Motion::rolling, make_particle("rolling", {below, above}));
}

TEST(FromParameters_analytic, a_sphere_in_a_rail_agrees_with_the_closed_form_at_every_angle) {
  for (const double degrees : {25.0, 45.0, 60.0}) {
    const double angle = degrees * (M_PI / 180);
    expect_closed_form(Motion::rail,
                       make_particle("rail", {contact_model(silicon()), contact_model(diamond()), angle}),
                       angle);
  }
}

TEST(FromParameters_analytic, given_stiffnesses_and_lengths_are_used_as_the_file_means_them) {
  ContactParameters record = silicon();
  record.lateral_stiffness = number(2219);
  record.lateral_stiffness->at_load = 1e-4;
  record.lateral_stiffness->length_scale = LengthScale::contact_radius;
  record.rolling_friction->length_scale = LengthScale::none;
  record.rolling_friction->value = 7.9e-4 * 8.5e-6;
  const ContactModel model = contact_model(record);
  const NormalState normal = model.normal->advance({}, model.normal->approach(1e-4));
  const Eigen::Vector3d still = Eigen::Vector3d::Zero();
  EXPECT_NEAR(model.sliding->advance({}, normal, still).spring.stiffness, 2219, 1e-6);
  EXPECT_NEAR(model.rolling->limit(normal, 8.5e-6) / silicon().rolling_limit(1e-4), 1, 1e-12);
  EXPECT_NEAR(model.rolling->advance({}, normal, 8.5e-6, still).stiffness / 1.56385e-6, 1, 1e-9);
  record.lateral_stiffness->length_scale = LengthScale::none;
  EXPECT_EQ(contact_model(record).sliding->advance({}, NormalState{0, 9, 9, 9, true}, still).spring.stiffness,
            2219);
  record.sliding_friction.reset();
  EXPECT_THROW(contact_model(record), InputError);
}

TEST(FromParameters_analytic, pull_off_force_adds_to_the_pressure_of_the_contact_only_where_it_is_asked_for) {
  ContactParameters record = silicon();
  record.pull_off_force = number(3.2e-6);
  ReducedLawOptions adhesive;
  adhesive.normal_adhesion = true;
  EXPECT_GT(contact_model(record, adhesive).normal->approach(1e-4),
            contact_model(record).normal->approach(1e-4));
}

}  // namespace
}  // namespace asperity

// Laws of the effects that the format names since its first version, against their own formulas.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dem_compare/laws/maugis_dugdale.h"
#include "diagnosis/catalogue/effect.h"
#include "diagnosis/conceal/relaxing_sphere.h"
#include "diagnosis/describe.h"
#include "diagnosis/fit/explanation.h"
#include "diagnosis/mechanics/yielding_contact.h"
#include "diagnosis/remarks.h"
#include "half_space/filmed_sphere.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

using test::nm;
using test::uN;

Mechanics with_effect(const std::string& id, const std::vector<double>& values,
                      Motion mode = Motion::normal) {
  SimulationChoice choice;
  choice.parameters["sliding_friction"] = {0.2, true};
  Mechanics m = baseline_mechanics(test::experiment(mode), choice);
  effect_of(id).assemble(m, values.data());
  return m;
}

TEST(PopIn_analytic, moves_the_law_on_by_its_jump_once_its_force_was_passed) {
  const Mechanics m = with_effect("pop_in", {3 * nm, 100 * uN});
  const Hertz law = m.geometry;
  const auto contact = m.normal.contact->clone();
  const double threshold = law.approach(100 * uN);
  EXPECT_NEAR(contact->force(0.9 * threshold), law.force(0.9 * threshold), 1e-12);
  contact->accept(0.9 * threshold);
  EXPECT_NEAR(contact->displacement(90 * uN), law.approach(90 * uN), 1e-15);
  contact->accept(1.5 * threshold);
  for (const double part : {0.9, 1.5, 2.0})
    EXPECT_NEAR(contact->force(part * threshold), law.force(part * threshold - 3 * nm), 1e-12) << part;
  EXPECT_NEAR(contact->displacement(50 * uN), law.approach(50 * uN) + 3 * nm, 1e-15);
}

TEST(Film_analytic, goes_from_the_film_to_the_body_and_is_none_of_the_same_modulus) {
  const double thickness = 20 * nm;
  const Mechanics soft = with_effect("film", {0.2, thickness}), same = with_effect("film", {1, thickness});
  const Hertz law = soft.geometry;
  EXPECT_NEAR(soft.normal.contact->force(1e-6 * nm) / (0.2 * law.force(1e-6 * nm)), 1, 0.01);
  EXPECT_NEAR(soft.normal.contact->force(1e6 * nm) / law.force(1e6 * nm), 1, 0.01);
  EXPECT_NEAR(same.normal.contact->force(10 * nm) / law.force(10 * nm), 1, 1e-12);
}

/// Its table is the integral equation from which it is made.
TEST(Film_analytic, is_the_contact_of_a_sphere_with_a_film_on_the_softer_body) {
  const double thickness = 20 * nm;
  for (const double ratio : {0.013, 0.1, 0.7, 2.0, 3.4}) {
    const Mechanics m = with_effect("film", {ratio, thickness});
    const ElasticBody glass = m.experiment.particle, silicon = m.experiment.substrate;
    ASSERT_LT(modulus_alone(glass), modulus_alone(silicon));
    const double E = m.geometry.reduced_modulus, R = m.geometry.radius, nu = glass.poisson_ratio,
                 film = 1 / (1 / (ratio * E) - 1 / modulus_alone(silicon));
    const half_space::FilmedSphere exact(E, {{{film * (1 - nu * nu), nu}, glass, thickness}});
    for (const double a : {0.005, 0.05, 0.4, 1.3, 7.0, 60.0, 800.0}) {
      const auto contact = exact.at(a * thickness, R);
      EXPECT_NEAR(m.normal.contact->force(contact.approach) / contact.force, 1, 3e-3) << ratio << " " << a;
    }
  }
}

/// Gao, Chiu & Lee (1992): first order in the contrast, for a punch on film and body of the same nu.
TEST(Film_analytic, is_that_of_Gao_for_films_little_softer_or_stiffer_than_the_body) {
  constexpr double nu = 0.3;
  for (const double ratio : {0.8, 1.25})
    for (const double a_over_t : {0.1, 0.3, 1.0, 3.0, 10.0}) {
      const double x = 1 / a_over_t, square = x * x;
      const double weight =
          2 / M_PI * std::atan(x) +
          ((1 - 2 * nu) * x * std::log((1 + square) / square) - x / (1 + square)) / (2 * M_PI * (1 - nu));
      const double thickness = 20 * nm;
      const Mechanics m = with_effect("film", {ratio, thickness});
      const double d = std::pow(a_over_t * thickness, 2) / m.geometry.radius;
      EXPECT_NEAR(m.normal.contact->force(d) / m.geometry.force(d) / (1 + (ratio - 1) * weight), 1, 0.02)
          << ratio << " " << a_over_t;  // one fit is off by at most 1.8 % of the other
    }
}

/// Each part has a saw-tooth of another phase: the trace gives the phases back.
TEST(SlidingTrace_analytic, reads_the_phase_of_a_saw_tooth_off_each_segment) {
  const double period = 25 * nm;
  Samples samples = test::lateral_path(1e-3, {0, 300 * nm, 0}, 600);
  samples.parts = 2;
  std::vector<double> truth;
  for (std::size_t i = 0; i < samples.list.size(); ++i) {
    Sample& s = samples.list[i];
    s.part = i < 600 ? 0 : 1;
    s.since_reversal = i < 600 ? s.lateral_displacement : 300 * nm - s.lateral_displacement;
    const double passed = s.since_reversal / period + (i < 600 ? 0.15 : 0.7);
    truth.push_back(passed - std::floor(passed));
    s.response = s.direction * (100 * uN + 4 * uN * (truth.back() - 0.5));
  }
  const SlidingTrace trace(samples);
  const auto phases = trace.phases(period);
  for (std::size_t i = 200; i < truth.size(); i += 37) {
    const double off = phases[i] - truth[i];
    EXPECT_NEAR(off - std::round(off), 0, 0.03) << i;
  }
  EXPECT_NEAR(trace.windows(period), 2 * 0.7 * 300 / (3 * 25), 0.1);
}

TEST(Capillary_analytic, pulls_from_touch_to_rupture_and_forms_only_on_touch) {
  const Mechanics m = with_effect("capillary", {20 * uN, 4 * nm});
  const Hertz law = m.geometry;
  const MaugisDugdale maugis{law.reduced_modulus, law.radius, 20 * uN / (2 * M_PI * law.radius),
                             20 * uN / (2 * M_PI * law.radius) / (4 * nm)};
  const auto contact = m.normal.contact->clone();
  EXPECT_EQ(contact->force(-1 * nm), 0);
  contact->accept(2 * nm);
  for (const double d : {1 * nm, 5 * nm, 20 * nm})
    EXPECT_NEAR(contact->force(d), maugis.advance({}, d).force, 1e-4 * 20 * uN) << d;
  // Of surfaces apart it acts on a disc whose edge it draws out by 4/pi s c/E* (Johnson 1985, eq. 3.29).
  const double out = 4 / M_PI * maugis.cohesive_stress / law.reduced_modulus * law.radius,
               disc = out + std::sqrt(out * out + 2 * law.radius * 3 * nm);
  EXPECT_NEAR(contact->force(-1 * nm), -maugis.cohesive_stress * M_PI * disc * disc, 1e-3 * 20 * uN);
  EXPECT_NEAR(contact->release(), -4 * nm - 0.5 * out * out / law.radius, 0.001 * nm);
  EXPECT_EQ(contact->force(-4.2 * nm), 0);
  contact->accept(-5 * nm);
  EXPECT_EQ(contact->force(-1 * nm), 0);
}

/// Where the contact breaks before surfaces apart are pulled, nothing tells it from an adhesion of that
/// range.
TEST(Capillary_analytic, of_a_strong_suction_is_the_adhesion_of_its_range) {
  const Effect &bridge = effect_of("capillary"), &adhesion = effect_of("adhesion");
  const Experiment e = test::experiment(Motion::normal);
  const double weak[] = {5 * uN, 4 * nm}, strong[] = {11 * uN, 0.57 * nm};
  EXPECT_TRUE(bridge.is_itself(e, weak));
  EXPECT_FALSE(bridge.is_itself(e, strong));
  const SimplerForm form = bridge.simpler_form(e, strong);
  ASSERT_EQ(form.effect, "adhesion");
  ASSERT_EQ(form.starts.size(), 1u);
  Mechanics bridged = baseline_mechanics(e, {}), adhesive = bridged;
  bridge.assemble(bridged, strong);
  adhesion.assemble(adhesive, form.starts[0].data());
  const auto one = bridged.normal.contact->clone(), other = adhesive.normal.contact->clone();
  one->accept(1 * nm), other->accept(1 * nm);
  for (const double d : {-0.3 * nm, 0.5 * nm, 8 * nm})
    EXPECT_NEAR(one->force(d), other->force(d), 1e-6 * 11 * uN) << d;
  EXPECT_NEAR(one->release() / other->release(), 1, 1e-6);
}

/// On another law it is a constant force while they touch.
TEST(Capillary_analytic, pulls_on_a_film_as_on_any_law) {
  Mechanics m = with_effect("film", {0.3, 20 * nm});
  const double bridge[] = {20 * uN, 4 * nm};
  const auto filmed = m.normal.contact->clone();
  effect_of("capillary").assemble(m, bridge);
  const auto contact = m.normal.contact->clone();
  contact->accept(2 * nm);
  EXPECT_NEAR(contact->force(2 * nm), filmed->force(2 * nm) - 20 * uN, 1e-12);
  EXPECT_NEAR(contact->force(-1 * nm), -15 * uN, 1e-12);
}

TEST(Electrostatic_analytic, is_pi_eps_U_squared_R_over_z_near_the_plane) {
  const Mechanics m = with_effect("electrostatic", {5, 2 * nm});
  const double R = m.geometry.radius, near = M_PI * 8.8541878128e-12 * 25 * R;
  ASSERT_EQ(m.normal.beside.size(), 1u);
  const auto& attraction = m.normal.beside.front();
  EXPECT_NEAR(attraction(-8 * nm) / (-near / (10 * nm)), 1, 0.01);
  EXPECT_NEAR(attraction(0) / (-near / (2 * nm)), 1, 0.01);
  EXPECT_EQ(attraction(5 * nm), attraction(0));
  EXPECT_DOUBLE_EQ(m.normal.contact->force(20 * nm), m.geometry.force(20 * nm));
}

/// A step of depth relaxes from E* to (1 - g) E* with tau.
TEST(Viscoelasticity_analytic, relaxes_after_a_step) {
  const Mechanics m = with_effect("viscoelasticity", {0.4, 10.0});
  const auto contact = m.normal.contact->clone();
  const double elastic = m.geometry.force(20 * nm);
  contact->begin_step(0);
  EXPECT_NEAR(contact->force(20 * nm) / elastic, 1, 1e-12);
  contact->accept(20 * nm);
  contact->begin_step(10);
  EXPECT_NEAR(contact->force(20 * nm) / elastic, 0.6 + 0.4 * std::exp(-1), 1e-9);
}

/// Each sample is simulated at its own time: of a row of springs and dampers, which takes no integral.
TEST(Viscoelasticity_other_code, is_simulated_at_the_time_of_each_sample) {
  constexpr double share = 0.5, tau = 6, deepest = 15e-9;
  const Mechanics m = with_effect("viscoelasticity", {share, tau});
  const Samples samples = test::approach_and_back(0, deepest, 20);  // a second apart
  const std::vector<double> simulated = simulate(m, samples);
  hidden::RelaxingSphere row({m.geometry.reduced_modulus, m.geometry.radius}, share, tau, 1.5 * deepest);
  double time = samples.list.front().time;
  for (std::size_t i = 0; i < simulated.size(); ++i) {
    const Sample& s = samples.list[i];
    EXPECT_NEAR(simulated[i], row.force(s.normal_displacement, s.time - time),
                0.01 * m.geometry.force(deepest))
        << i;
    row.take(s.normal_displacement, s.time - time);
    time = s.time;
  }
}

TEST(Readings_analytic, of_a_bent_and_a_clipped_sensor) {
  const Mechanics bent = with_effect("detector_nonlinearity", {0.2}),
                  clipped = with_effect("clipping", {7 * uN});
  const double largest = bent.experiment.largest_force;
  EXPECT_NEAR(bent.normal.readings.at(0)(0.5 * largest) / largest, 0.5 * (1 - 0.2 * 0.25), 1e-12);
  EXPECT_EQ(clipped.normal.readings.at(0)(9 * uN), 7 * uN);
  EXPECT_EQ(clipped.normal.readings.at(0)(6 * uN), 6 * uN);
}

TEST(ActuatorHysteresis_analytic, shifts_the_way_back_alone_and_nothing_at_its_ends) {
  const Mechanics m = with_effect("actuator_hysteresis", {-2 * nm});
  auto shift = m.normal.shifts.at(0);
  Sample sample;
  const auto at = [&](double displacement, int direction) {
    sample.normal_displacement = displacement, sample.direction = direction;
    return shift(sample);
  };
  for (const double d : {-10 * nm, 0.0, 10 * nm, 30 * nm}) EXPECT_EQ(at(d, 1), 0) << d;
  EXPECT_NEAR(at(30 * nm, -1), 0, 1e-20);
  EXPECT_NEAR(at(10 * nm, -1), -2 * nm, 1e-18);
  EXPECT_NEAR(at(0, -1), -2 * nm * 0.75, 1e-18);
  EXPECT_NEAR(at(-10 * nm, -1), 0, 1e-20);
}

TEST(InWords_regression, more_than_noise_is_not_called_noise) {
  Diagnosis d;
  d.verdict = Verdict::explained;
  d.improved.samples = 1000;
  d.improved.chi2_reduced = 1.1;
  EXPECT_NE(in_words(d).find("which is noise"), std::string::npos) << in_words(d);
  d.improved.chi2_reduced = 2;
  EXPECT_NE(in_words(d).find("more than noise, but no more than laws of this kind are off by"),
            std::string::npos)
      << in_words(d);
}

TEST(IndentationSize_analytic, is_the_yielding_sphere_of_the_stress_at_its_depth) {
  const double yield = 0.4e9, length = 30 * nm, d = 20 * nm;
  const Mechanics m = with_effect("indentation_size", {yield, length});
  const YieldingContact law(m.geometry, yield * std::sqrt(1 + length / d), YieldingContact::without_hardening,
                            softer_body(m.experiment).poisson_ratio);
  EXPECT_NEAR(m.normal.contact->force(d) / law.force(d), 1, 1e-12);
}

TEST(LateralTerms_analytic, add_to_the_limit_by_their_formulas) {
  Sample sample;
  sample.humidity = 0.5, sample.rms_roughness = 2 * nm, sample.normal_force = 100 * uN;
  SlipState state;
  state.sample = &sample, state.normal_force = 100 * uN, state.contact_radius = 300 * nm;
  const Mechanics constant = with_effect("constant_lateral_force", {3 * uN}, Motion::sliding);
  EXPECT_NEAR(constant.lateral.beside.at(0)(state), 3 * uN, 1e-15);
  const Mechanics two = with_effect("two_term_friction", {1e7}, Motion::sliding);
  EXPECT_NEAR(two.lateral.limit_changes.at(0)(20 * uN, state), 20 * uN + 1e7 * M_PI * 9e-14, 1e-12);
  const Mechanics rough = with_effect("friction_by_roughness", {0.1, 1e8}, Motion::sliding);
  EXPECT_NEAR(rough.lateral.coefficient_changes.at(0)(0.2, state), 0.3, 1e-12);
  const Mechanics damp = with_effect("friction_by_humidity", {5 * uN}, Motion::sliding);
  EXPECT_NEAR(offset_at(damp.lateral, sample), 5 * uN, 1e-12);
  sample.humidity = 0.25;
  EXPECT_NEAR(offset_at(damp.lateral, sample), 2.5 * uN, 1e-12);
}

/// A search tries values at the bounds, too, alone and with another effect. Under a driven force a contact
/// that cannot carry it must not end the program.
TEST(Simulate_behaviour, every_effect_of_a_normal_contact_bears_all_corners_of_its_bounds) {
  Experiment e = test::experiment(Motion::normal);
  e.hold_duration = 10;
  Samples samples = test::approach_and_back(-0.5 * e.largest_displacement, e.largest_displacement, 40);
  for (Sample& s : samples.list) {
    s.normal_force = std::max(0.0, s.normal_displacement / e.largest_displacement) * e.largest_force;
    if (s.normal_force == e.largest_force) s.hold_time = 1;
  }
  const auto corner = [&](const Effect& effect, std::size_t bits) {
    std::vector<double> values;
    for (const EffectParameter& p : effect.parameters(e)) {
      values.push_back(bits & 1 ? p.high : p.low);
      bits >>= 1;
    }
    return values;
  };
  for (const bool by_force : {false, true}) {
    samples.runs.front().response_is_displacement = by_force;
    for (const auto& one : effect_catalogue())
      for (const auto& other : effect_catalogue()) {
        if (!one->acts_in(Motion::normal) || !other->acts_in(Motion::normal)) continue;
        if (one != other && !Explanation::compatible({one.get(), other.get()})) continue;
        const std::size_t corners = std::size_t{1} << one->parameters(e).size();
        for (std::size_t k = 0; k < corners; ++k)
          EXPECT_NO_THROW({
            Mechanics m = baseline_mechanics(e, {});
            std::vector<const Effect*> both{one.get()};
            if (one != other) both.push_back(other.get());
            std::stable_sort(both.begin(), both.end(), [](const Effect* a, const Effect* b) {
              return a->description().order < b->description().order;
            });
            for (const Effect* effect : both)
              effect->assemble(m, corner(*effect, effect == one.get() ? k : 1).data());
            simulate(m, samples);
          }) << one->id()
             << " " << other->id() << " " << k << (by_force ? " driven by force" : "");
      }
  }
}

}  // namespace
}  // namespace asperity

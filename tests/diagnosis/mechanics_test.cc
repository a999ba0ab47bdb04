// What the assembled mechanics of normal contact says, against formulas worked out by hand.
#include "diagnosis/mechanics/mechanics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/csv.h"
#include "dem_compare/laws/jkr.h"
#include "dem_compare/laws/maugis_dugdale.h"
#include "diagnosis/mechanics/attraction_in_case.h"
#include "tests/diagnosis/support/assembled_mechanics.h"
#include "tests/diagnosis/support/made_recording.h"
#include "tests/support/shared_files.h"

namespace asperity {
namespace {

using test::approach_and_back;
using test::experiment;
using test::nm;
using test::uN;
using test::with;

TEST(Mechanics_analytic, normal_force_without_effects_is_hertz) {
  const Experiment e = experiment(Motion::normal);
  const auto f = simulate(with(e, {}), approach_and_back(-5 * nm, 40 * nm, 46));
  EXPECT_EQ(f[3], 0);
  EXPECT_NEAR(f[45], 4.0 / 3 * e.reduced_modulus() * std::sqrt(e.radius) * std::pow(40 * nm, 1.5), 1e-12);
}

TEST(Mechanics_analytic, series_compliance_takes_its_part_of_the_displacement) {
  const Experiment e = experiment(Motion::normal);
  const double C = 5e-6;
  const Samples path = approach_and_back(0, 50 * nm, 51);
  const auto f = simulate(with(e, {{"instrument_compliance", {C}}}), path);
  for (const int i : {10, 30, 50})
    EXPECT_NEAR(e.hertz().approach(f[i]) + C * f[i], path.list[i].normal_displacement, 1e-13);
}

TEST(Mechanics_analytic, force_control_gives_the_displacement_that_displacement_control_would_turn_back) {
  const Experiment e = experiment(Motion::normal);
  const Mechanics m = with(
      e, {{"instrument_compliance", {5e-6}}, {"contact_point_offset", {3 * nm}}, {"baseline_tilt", {200}}});
  Samples path = approach_and_back(5 * nm, 50 * nm, 40);
  const auto f = simulate(m, path);
  for (std::size_t i = 0; i < f.size(); ++i) path.list[i].normal_force = f[i];
  path.runs.front().response_is_displacement = true;
  const auto d = simulate(m, path);
  for (std::size_t i = 0; i < f.size(); ++i) EXPECT_NEAR(d[i], path.list[i].normal_displacement, 1e-13);
}

TEST(Mechanics_analytic, drift_and_offset_shift_the_displacement) {
  const Experiment e = experiment(Motion::normal);
  const Samples path = approach_and_back(0, 50 * nm, 51);  // a sample a second
  const auto f = simulate(with(e, {{"thermal_drift", {0.1 * nm}}, {"contact_point_offset", {4 * nm}}}), path);
  EXPECT_NEAR(f[30], e.hertz().force(30 * nm - 4 * nm - 30 * 0.1 * nm), 1e-12);
}

TEST(Mechanics_analytic, creep_under_a_held_load_reaches_63_per_cent_after_its_time_constant) {
  const Experiment e = experiment(Motion::normal);
  Samples path = approach_and_back(0, 40 * nm, 2);
  for (std::size_t i = 0; i < path.list.size(); ++i)
    path.list[i].normal_force = e.largest_force, path.list[i].time = 7.0 * static_cast<double>(i);
  path.runs[0].response_is_displacement = true;
  const auto d = simulate(with(e, {{"creep", {2 * nm, 7.0}}}), path);
  EXPECT_NEAR(d[0], e.largest_displacement, 1e-13);
  // The load came at once, before the first sample; from then on it is held.
  EXPECT_NEAR(d[1] - d[0], 2 * nm * (1 - std::exp(-1)), 1e-3 * nm);
  EXPECT_NEAR(d[3] - d[0], 2 * nm * (1 - std::exp(-3)), 1e-3 * nm);
}

TEST(Mechanics_analytic, creep_follows_a_ramp_late_by_its_time_constant) {
  const Experiment e = experiment(Motion::normal);
  Samples path = approach_and_back(0, 1, 101);
  const double tau = 9, duration = 100;  // a sample a second
  path.list.resize(101);
  path.runs[0].end = 101;
  path.runs[0].response_is_displacement = true;
  // The contact's own displacement grows evenly.
  for (auto& s : path.list) s.normal_force = e.hertz().force(e.largest_displacement * s.time / duration);
  const auto d = simulate(with(e, {{"creep", {2 * nm, tau}}}), path);
  for (const std::size_t i : {20u, 60u, 100u}) {
    const double t = static_cast<double>(i), late = 2 * nm / duration * (t - tau * (1 - std::exp(-t / tau)));
    EXPECT_NEAR(d[i], e.largest_displacement * t / duration + late, 1e-3 * nm);
  }
}

TEST(Mechanics_analytic, creep_driven_by_displacement_gives_the_force_that_drives_it_there) {
  const Experiment e = experiment(Motion::normal);
  Samples path = approach_and_back(0, 40 * nm, 30);
  const auto force = simulate(with(e, {{"creep", {5 * nm, 12}}}), path);
  Samples back = path;
  back.runs[0].response_is_displacement = true;
  for (std::size_t i = 0; i < back.list.size(); ++i) back.list[i].normal_force = force[i];
  const auto displacement = simulate(with(e, {{"creep", {5 * nm, 12}}}), back);
  for (std::size_t i = 1; i < 50; ++i)
    EXPECT_NEAR(displacement[i], path.list[i].normal_displacement, 1e-3 * nm) << i;
}

TEST(Mechanics_analytic, a_radius_ratio_of_four_doubles_the_force) {
  const Experiment e = experiment(Motion::normal);
  const Samples path = approach_and_back(0, 50 * nm, 11);
  EXPECT_NEAR(simulate(with(e, {{"effective_radius", {4}}}), path)[10], 2 * e.hertz().force(50 * nm), 1e-12);
}

TEST(Mechanics_analytic, the_asperity_layer_adds_its_displacement_to_hertz) {
  const Experiment e = experiment(Motion::normal);
  const Samples path = approach_and_back(0, 50 * nm, 51);
  const auto f = simulate(with(e, {{"roughness_compliance", {2 * nm, 0.5, 0}}}), path);
  const double first = 0.5 * e.hertz().force(2 * nm), smooth = e.hertz().approach(f[40]);
  EXPECT_NEAR(smooth + 2 * nm * std::log(1 + f[40] / first / (1 + 0.914 * smooth / (2 * nm))), 40 * nm,
              1e-13);
}

TEST(Mechanics_analytic, adhesion_pulls_off_at_its_force_from_DMT_to_JKR) {
  const Experiment e = experiment(Motion::normal);
  const Samples path = approach_and_back(-20 * nm, 20 * nm, 4001);
  for (const double transition : {0.0, 0.5, 1.0}) {
    const auto f = simulate(with(e, {{"adhesion", {40 * uN, transition}}}), path);
    EXPECT_NEAR(*std::min_element(f.begin(), f.end()), -40 * uN, 0.02 * uN) << transition;
    EXPECT_EQ(f.front(), 0);
    EXPECT_EQ(f.back(), 0);
  }
}

/// A series stiffer than the contact lets it go at its own limit, which the recorder sees at d + C f.
TEST(Mechanics_analytic, a_compliance_draws_an_adhesive_contact_out_before_it_snaps) {
  const Experiment e = experiment(Motion::normal);
  const Samples path = approach_and_back(-20 * nm, 20 * nm, 4001);
  const double compliance = 1e-5;
  const auto last_pull = [&](const std::vector<double>& force) {
    std::size_t last = 0;
    for (std::size_t i = 0; i < force.size(); ++i)
      if (force[i] < 0) last = i;
    return last;
  };
  const auto stiff = simulate(with(e, {{"adhesion", {40 * uN, 0.5}}}), path);
  const auto drawn =
      simulate(with(e, {{"adhesion", {40 * uN, 0.5}}, {"instrument_compliance", {compliance}}}), path);
  const std::size_t at = last_pull(stiff), later = last_pull(drawn);
  ASSERT_LT(stiff[at], -10 * uN);
  EXPECT_NEAR(path.list[later].normal_displacement,
              path.list[at].normal_displacement + compliance * stiff[at], 0.05 * nm);
}

TEST(Mechanics_analytic, adhesion_that_vanishes_leaves_hertz_whatever_its_transition) {
  const Experiment e = experiment(Motion::normal);
  const Samples path = approach_and_back(1 * nm, 40 * nm, 40);
  for (const double transition : {0.0, 0.1, 0.3, 0.6, 0.88, 1.0}) {
    const auto f = simulate(with(e, {{"adhesion", {1e-12, transition}}}), path);
    for (std::size_t i = 0; i < 40; ++i)
      EXPECT_NEAR(f[i] / e.hertz().force(path.list[i].normal_displacement), 1, 1e-3)
          << transition << " " << i;
  }
}

TEST(Mechanics_other_code, adhesion_with_transition_one_is_JKR_within_one_per_cent) {
  const Experiment e = experiment(Motion::normal);
  const double h = 40 * uN;
  const Jkr law{e.reduced_modulus(), e.radius, h / (1.5 * M_PI * e.radius)};
  const Samples path = approach_and_back(-5 * nm, 40 * nm, 451);
  const auto f = simulate(with(e, {{"adhesion", {h, 1}}}), path);
  NormalState state;
  for (std::size_t i = 0; i < f.size(); ++i) {
    state = law.advance(state, path.list[i].normal_displacement);
    if (std::abs(path.list[i].normal_displacement) < 1e-15 ||
        path.list[i].normal_displacement < 0.9 * law.smallest_approach())
      continue;
    EXPECT_NEAR(f[i], state.force, 0.01 * h + 0.01 * std::abs(state.force))
        << path.list[i].normal_displacement;
  }
}

/// Maugis' contact of a given radius (1992), solved for the edge of its attraction, against the branch in
/// closed form: lambda = -0.924 ln(1 - alpha), so far as that ends at 10.
TEST(Mechanics_other_code, adhesion_in_transition_is_the_law_of_maugis) {
  const Experiment e = experiment(Motion::normal);
  const double h = 40 * uN, R = e.radius, K = 4.0 / 3 * e.reduced_modulus(), pi = M_PI;
  for (const double alpha : {0.3, 0.6, 0.9}) {
    const double lambda = -0.924 * std::log(1 - alpha * (1 - std::exp(-10 / 0.924)));
    // The work that has this pull-off force.
    MaugisDugdale law{e.reduced_modulus(), R, 0, 0};
    double work = h / (1.75 * pi * R);
    for (int i = 0; i < 20; ++i) {
      law.work_of_adhesion = work, law.cohesive_stress = lambda / (2 * std::cbrt(R / (pi * work * K * K)));
      work *= h / law.pull_off_force();
    }
    ASSERT_NEAR(law.lambda(), lambda, 1e-6);
    const auto contact = with(e, {{"adhesion", {h, alpha}}}).normal.contact->clone();
    contact->accept(5 * nm);
    const double unit = law.approach(h);
    for (const double force : {-0.5 * h, 0.0, h, 5 * h, 20 * h})
      EXPECT_NEAR(contact->displacement(force), law.approach(force),
                  1e-6 * std::max(unit, law.approach(force)))
          << alpha << " " << force / h;
  }
}

TEST(Mechanics_other_code, adhesion_hysteresis_with_equal_works_is_Maugis_solution) {
  const Experiment e = experiment(Motion::normal);
  MaugisDugdale law{e.reduced_modulus(), e.radius, 0.5, 1};
  law.cohesive_stress = lambda_of_transition(0.8) / law.lambda();
  const Samples path = approach_and_back(-20 * nm, 40 * nm, 201);
  const auto f = simulate(with(e, {{"adhesion_hysteresis", {0.5, 0.5, 0.8}}}), path);
  NormalState state;
  for (std::size_t i = 0; i < f.size(); ++i) {
    state = law.advance(state, path.list[i].normal_displacement);
    EXPECT_NEAR(f[i], state.force, 1e-6 * 1e-3) << i;
  }
}

TEST(Mechanics_analytic, a_pinned_edge_unloads_as_a_flat_punch) {
  const Experiment e = experiment(Motion::normal);
  const Samples path = approach_and_back(0, 40 * nm, 401);
  const auto f = simulate(with(e, {{"adhesion_hysteresis", {1e-6, 1.0, 1.0}}}), path);
  const double a = std::sqrt(e.radius * 40 * nm), step = 40 * nm / 400;
  EXPECT_NEAR((f[400] - f[405]) / (4 * step), 2 * e.reduced_modulus() * a,
              0.01 * 2 * e.reduced_modulus() * a);  // f[401] repeats the turn
}

/// Approach at first yield [m] where the particle of 8.5 um yields at Y.
double critical_approach(const Experiment& e, double Y) {
  const double C = 1.295 * std::exp(0.736 * e.particle.poisson_ratio);
  return std::pow(M_PI * C * Y / (2 * e.reduced_modulus()), 2) * e.radius;
}

TEST(Mechanics_analytic, plasticity_is_hertz_before_first_yield) {
  const Experiment e = experiment(Motion::normal);
  const double Y = 0.5e9, critical = critical_approach(e, Y);
  const auto f =
      simulate(with(e, {{"bulk_plasticity", {Y, 2.84}}}), approach_and_back(0, 0.99 * critical, 11));
  EXPECT_NEAR(f[10], e.hertz().force(0.99 * critical), 1e-9 * f[10]);
  EXPECT_NEAR(f[16], f[5], 1e-9 * f[10]);
}

TEST(Mechanics_other_code, yielding_follows_axisymmetric_finite_elements) {
  Experiment e = experiment(Motion::normal);
  const double Y = 2e6;  // at which a/R stays small at the largest depth, as in the tables
  const CsvTable loading = read_csv(test::reference_table("02_elastoplastic_table_ownFE.csv"));
  const auto depths = loading.numbers("w/wc");
  for (const char* poisson : {"0.17", "0.25", "0.3"}) {
    e.particle.poisson_ratio = std::stod(poisson);
    const double critical = critical_approach(e, Y), unit = e.hertz().force(critical);
    const Mechanics m = with(e, {{"bulk_plasticity", {Y, 2.84}}});
    const auto forces = loading.numbers(std::string("F/Fc_nu") + poisson);
    for (std::size_t i = 0; i < depths.size(); ++i) {
      if (std::isnan(forces[i])) continue;
      EXPECT_NEAR(simulate(m, approach_and_back(0, depths[i] * critical, 51))[50] / unit, forces[i],
                  0.0025 * forces[i])
          << depths[i] << " " << poisson;
    }
  }
  const CsvTable unloading = read_csv(test::reference_table("02_elastoplastic_table_unloading.csv"));
  const auto deepest = unloading.numbers("w_max/wc"), residual = unloading.numbers("w_res/w_max_ownFE"),
             exponents = unloading.numbers("unloading_exponent_fit_ownFE"), poisson = unloading.numbers("nu");
  for (std::size_t i = 0; i < deepest.size(); ++i) {
    e.particle.poisson_ratio = poisson[i];
    const double deep = deepest[i] * critical_approach(e, Y);
    const auto f = simulate(with(e, {{"bulk_plasticity", {Y, 2.84}}}), approach_and_back(0, deep, 101));
    // f/f_m = [(d - d_r)/(d_m - d_r)]^n, held against the tables' d_r and n, by 1 % of the largest force.
    for (std::size_t k = 0; k < 101; ++k) {
      const double part =
          std::max(0.0, ((1 - static_cast<double>(k) / 100) - residual[i]) / (1 - residual[i]));
      EXPECT_NEAR(f[101 + k] / f[100], std::pow(part, exponents[i]), 0.01) << deepest[i] << " " << k;
    }
  }
}

}  // namespace
}  // namespace asperity

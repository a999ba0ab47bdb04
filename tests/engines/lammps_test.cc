// LAMMPS run as users run it, against closed forms and against the figures measured once by hand (8 G* a =
// 21645.1 N/m).
#include <gtest/gtest.h>

#include "tests/engines/engine_support.h"

namespace asperity {
namespace {

using test::canonical_experiment;
using test::expect_closed_form;
using test::rail_experiment;
using test::run;

constexpr double asked = 0.01;       // of every engine against its law
constexpr double last_digit = 5e-6;  // figures are given to five or six digits

test::Verified lammps_against(const std::string& figure, const std::string& what) {
  return {"Engines", "LAMMPS, " + what, figure};
}

double value(const EngineRun& r, const std::string& name) { return named(r.measurements, name).measured; }

/// LAMMPS with a change made to the input asperity wrote.
class EditedLammps : public Lammps {
 public:
  EditedLammps(std::string from, std::string to) : from_(std::move(from)), to_(std::move(to)) {}
  std::string input(const EngineExperiment& experiment, const MotionPlan& plan) const override {
    std::string text = Lammps::input(experiment, plan);
    const auto first = text.find("granular hertz", text.find("fix substrate")),
               last = text.find(' ' + from_, first);
    EXPECT_NE(first, std::string::npos);
    EXPECT_NE(last, std::string::npos);
    return text.substr(0, first) + to_ + text.substr(last);
  }

 private:
  std::string from_, to_;
};

TEST(Lammps_other_code, sliding_loop_has_mindlins_slope_coulombs_plateau_and_hertz_approach) {
  const Lammps lammps;
  ASPERITY_ENGINE_OR_SKIP(lammps);
  const EngineRun r = run(lammps, canonical_experiment(Motion::sliding));
  expect_closed_form("sliding loop", r, asked);
  const std::string slope = "8 G* a, 21645.1 N/m";
  EXPECT_TRUE(lammps_against(slope, "sliding loop: slope at the start")
                  .below(value(r, "slope at the start") / 21645.1 - 1, last_digit));
  EXPECT_TRUE(lammps_against(slope, "sliding loop: slope after reversal")
                  .below(value(r, "slope after reversal") / 21645.1 - 1, last_digit));
  EXPECT_TRUE(lammps_against("mu P, 23.000 uN", "sliding loop: plateau")
                  .below(value(r, "plateau") / 23e-6 - 1, last_digit));
  EXPECT_TRUE(lammps_against("Hertz, 6.1864 nm", "sliding loop: approach")
                  .below(value(r, "approach") / 6.1864e-9 - 1, last_digit));
  EXPECT_NEAR(value(r, "travel of reversal"), 2.13e-9, 0.005e-9);
  EXPECT_FALSE(r.version.empty());
}

TEST(Lammps_other_code, sliding_loop_with_the_fitted_shear_modulus_has_the_published_slope) {
  const Lammps lammps;
  ASPERITY_ENGINE_OR_SKIP(lammps);
  EngineExperiment e = canonical_experiment(Motion::sliding);
  e.substrate.reduced_shear_modulus->value = 1.2096e9;
  const EngineRun r = run(lammps, e);
  expect_closed_form("sliding loop with the fitted shear modulus", r, asked);
  EXPECT_NEAR(value(r, "slope after reversal"), 2219.0, 0.05);
}

TEST(Lammps_other_code, all_mindlin_styles_agree_at_constant_load) {
  Lammps lammps;
  ASPERITY_ENGINE_OR_SKIP(lammps);
  for (const char* style : {"mindlin/force", "mindlin_rescale", "mindlin_rescale/force"}) {
    lammps.tangential_style = style;
    const EngineRun r = run(lammps, canonical_experiment(Motion::sliding));
    EXPECT_NEAR(value(r, "slope after reversal"), 21645.1, 21645.1 * last_digit) << style;
    EXPECT_NEAR(value(r, "plateau"), 23e-6, 23e-6 * last_digit) << style;
  }
}

TEST(Lammps_other_code, ten_times_the_speed_changes_neither_slope_nor_plateau) {
  const Lammps lammps;
  ASPERITY_ENGINE_OR_SKIP(lammps);
  EngineExperiment e = canonical_experiment(Motion::sliding);
  e.haste = 10;
  const EngineRun r = run(lammps, e);
  EXPECT_NEAR(value(r, "slope after reversal"), 21645.1, 21645.1 * last_digit);
  EXPECT_NEAR(value(r, "plateau"), 23e-6, 23e-6 * last_digit);
}

TEST(Lammps_other_code,
     rolling_sphere_needs_half_the_sum_of_both_coefficients_and_travels_half_as_far_as_the_plate) {
  const Lammps lammps;
  ASPERITY_ENGINE_OR_SKIP(lammps);
  EngineExperiment e = canonical_experiment(Motion::rolling);
  e.amplitude = 50e-9;
  const EngineRun r = run(lammps, e);
  expect_closed_form("rolling", r, asked);
  const double plateau = value(r, "plateau") / 0.5304e-6;
  EXPECT_TRUE(lammps_against("mean coefficient times P, 0.5304 uN", "rolling: plateau")
                  .below(plateau - 1, last_digit));
  EXPECT_NEAR(value(r, "way of the sphere over that of the plate"), 0.5, 1e-6);
}

TEST(Lammps_other_code, rail_coefficients_are_those_of_the_torque_balance) {
  const Lammps lammps;
  ASPERITY_ENGINE_OR_SKIP(lammps);
  const std::map<double, double> measured{{25, 1.58399e-3}, {45, 2.58022e-3}, {60, 3.43049e-3}};
  for (const auto& [angle, coefficient] : measured) {
    const EngineRun r = run(lammps, rail_experiment(angle));
    const std::string what = "rail at " + std::to_string(std::lround(angle)) + " degrees";
    expect_closed_form(what, r, asked);
    EXPECT_TRUE(lammps_against("figure of six digits", what + ": coefficient")
                    .below(value(r, "rail coefficient") / coefficient - 1, last_digit));
  }
}

TEST(Lammps_other_code, soft_springs_of_rolling_and_torsion_are_measured_as_exactly_as_stiff_ones) {
  const Lammps lammps;
  ASPERITY_ENGINE_OR_SKIP(lammps);
  EngineExperiment e = rail_experiment(45);
  e.amplitude = 50e-9;
  for (ContactParameters* contact : {&e.substrate, &e.indenter}) {
    contact->rolling_stiffness->value = 1e-8;
    contact->torsion_stiffness->value = 2e-8;
  }
  expect_closed_form("rail at 45 degrees, soft springs", run(lammps, e), asked);
}

TEST(Lammps_other_code, twisting_sds_takes_stiffness_per_radian_and_a_limit_with_a_length_in_it) {
  const Lammps lammps;
  ASPERITY_ENGINE_OR_SKIP(lammps);
  const EngineExperiment e = canonical_experiment(Motion::torsion);
  const EngineRun r = run(lammps, e);
  expect_closed_form("twisting", r, asked);
  EXPECT_NEAR(value(r, "plateau"), 0.0056 * 8.5e-6 * 1e-4, 1e-4 * 4.76e-12);
  EXPECT_NEAR(lammps_contact(e.substrate, 1e-4).torsion, 0.0056 * 8.5e-6, 1e-15);
}

TEST(Lammps_other_code, a_twist_that_turns_at_its_limit_comes_back_along_the_spring_whatever_the_rounding) {
  const Lammps lammps;
  ASPERITY_ENGINE_OR_SKIP(lammps);
  // With a set-up of LAMMPS at the turning point, the first of these jumps to the other limit at once.
  for (const double friction : {3.10498470997e-8 / 8.5e-6, 3.2e-3, 3.3e-3, 3.4e-3}) {
    EngineExperiment e = canonical_experiment(Motion::torsion);
    e.substrate.reduced_modulus->value = 52.868387707575e9;
    e.substrate.torsion_stiffness = EffectiveQuantity{1.56385178098e-6};
    e.substrate.torsion_stiffness->length_scale = LengthScale::particle_radius;
    e.substrate.torsion_friction->value = friction;
    const EngineRun r = run(lammps, e);
    EXPECT_NEAR(named(r.measurements, "slope after reversal").ratio(), 1, asked) << friction;
  }
}

TEST(Lammps_other_code, twisting_marshall_is_softer_than_no_slip_and_stronger_than_full_slip) {
  Lammps lammps;
  ASPERITY_ENGINE_OR_SKIP(lammps);
  lammps.marshall = true;
  EngineExperiment e = canonical_experiment(Motion::torsion);
  // Its own stiffness and limit, so that the plan spins it far enough.
  const double a = e.substrate.contact_radius(1e-4);
  e.substrate.torsion_stiffness->value = 0.5 * e.substrate.lateral_stiffness_at(1e-4) * a * a;
  e.substrate.torsion_friction->value = 2.0 / 3 * 0.23 * a / e.substrate.particle.radius;
  const EngineRun r = run(lammps, e);
  expect_closed_form("twisting marshall", r, asked);
  EXPECT_NEAR(value(r, "slope at the start"), 5.691e-10, 5e-14);
  EXPECT_NEAR(value(r, "plateau"), 3.516e-12, 5e-16);
}

TEST(Lammps_other_code, walls_mix_moduli_wrongly_so_that_4_3_of_E_and_8_G_are_given) {
  const EditedLammps lammps("zplane",
                            "granular hertz/material 71e9 2e14 0.17 tangential mindlin NULL 0 0.23");
  ASPERITY_ENGINE_OR_SKIP(lammps);
  EngineExperiment quartz = canonical_experiment(Motion::sliding);
  quartz.substrate.reduced_modulus->value = 36.5565e9;
  quartz.substrate.reduced_shear_modulus->value = 8.2901e9;
  const EngineRun wrong = run(lammps, quartz);
  if (wrong.version.find("29 Sep 2021") == std::string::npos)
    GTEST_SKIP() << "LAMMPS " << wrong.version << " has mended it";
  EXPECT_NEAR(value(wrong, "slope after reversal"), 9353, 1);
  expect_closed_form("sliding loop on quartz", run(Lammps(), quartz), asked);
}

TEST(Lammps_other_code, adhesion_of_walls_is_lost_with_dmt_and_shared_by_all_modes_with_jkr) {
  // gamma such that the JKR pull-off force 3 pi gamma R is 9 uN, DMT's 4 pi gamma R 12 uN.
  const EditedLammps dmt("zplane",
                         "granular dmt 71e9 2e14 0.17 0.11234 tangential mindlin 9.43912e10 0 0.23");
  const EditedLammps jkr("zplane",
                         "granular jkr 71e9 2e14 0.17 0.11234 tangential mindlin 9.43912e10 0 0.23");
  ASPERITY_ENGINE_OR_SKIP(dmt);
  const EngineRun lost = run(dmt, canonical_experiment(Motion::sliding));
  if (lost.version.find("29 Sep 2021") == std::string::npos)
    GTEST_SKIP() << "LAMMPS " << lost.version << " has mended it";
  EXPECT_NEAR(value(lost, "plateau"), 23.0e-6, 0.05e-6);
  EXPECT_NEAR(value(run(jkr, canonical_experiment(Motion::sliding)), "plateau"), 27.14e-6,
              0.05e-6);  // mu (f + 2 * 3 pi gamma R)
}

/// Two spheres of different types, overlapping; the force between them.
std::string two_types(const std::string& coefficients) {
  return "units si\natom_style sphere\nboundary f f f\nnewton off\ncomm_modify vel yes\n"
         "region box block -4e-5 4e-5 -4e-5 4e-5 -4e-5 4e-5\ncreate_box 2 box\n"
         "create_atoms 1 single 0 0 0\ncreate_atoms 2 single 0 0 1.6993e-5\nset group all diameter 1.7e-5 "
         "density 2230\n"
         "neighbor 1e-6 bin\npair_style granular\n" +
         coefficients +
         "compute f all property/atom fz\ncompute fmax all reduce max c_f\nthermo_style custom step "
         "c_fmax\ntimestep 1e-9\nrun 0\n"
         "print \"force: $(c_fmax:%.10g)\"\n";
}

TEST(Lammps_other_code, unlike_types_fall_back_to_a_linear_spring_so_that_each_pair_is_given) {
  const Lammps lammps;
  ASPERITY_ENGINE_OR_SKIP(lammps);
  const std::string hertz = " hertz 7.04912e10 0 tangential linear_nohistory 0 0\n";
  const double overlap = 7e-9, radius = 4.25e-6;
  const double forgotten = test::number_after(
      test::run_script(lammps, two_types("pair_coeff 1 1" + hertz + "pair_coeff 2 2" + hertz)), "\nforce: ");
  const double given = test::number_after(
      test::run_script(
          lammps, two_types("pair_coeff 1 1" + hertz + "pair_coeff 2 2" + hertz + "pair_coeff 1 2" + hertz)),
      "\nforce: ");
  EXPECT_NEAR(given / (7.04912e10 * std::sqrt(radius) * std::pow(overlap, 1.5)), 1, 1e-4);
  EXPECT_NEAR(forgotten / (7.04912e10 * overlap), 1, 1e-4);  // hundreds of newtons in place of 85 uN
}

TEST(Lammps_other_code, sliding_in_micro_units_is_the_same) {
  const Lammps lammps;
  ASPERITY_ENGINE_OR_SKIP(lammps);
  // pg, um, us: force in nN, pressure in kPa. Sphere held at the overlap of 100 uN and dragged by 10 nm.
  const std::string output = test::run_script(
      lammps,
      "units micro\natom_style sphere\natom_modify map array\nboundary f f f\nnewton off\ncomm_modify vel "
      "yes\n"
      "region box block -20 20 -20 20 -0.1 40\ncreate_box 1 box\ncreate_atoms 1 single 0 0 8.4938136119\n"
      "set atom 1 diameter 17 density 2.23\nneighbor 1 bin\npair_style granular\n"
      "pair_coeff * * hertz 1 0 tangential linear_nohistory 0 0\n"
      "fix w all wall/gran granular hertz 7.04912e7 0 tangential mindlin 9.43912e7 0 0.23 zplane 0 NULL\n"
      "fix hold all setforce 0 0 0\nfix move all nve\ntimestep 0.002\nvelocity all set 1e-3 0 "
      "0\nthermo_style custom step f_hold[1]\n"
      "run 100\nprint \"early: $(-f_hold[1]/x[1])\"\nrun 4900\nprint \"late: $(-f_hold[1])\"\n");
  EXPECT_NEAR(test::number_after(output, "\nearly: ") * 1e-9 / 1e-6, 21645.1, 0.5);  // nN/um
  EXPECT_NEAR(test::number_after(output, "\nlate: ") * 1e-9, 23e-6, 23e-6 * 1e-5);
}

}  // namespace
}  // namespace asperity

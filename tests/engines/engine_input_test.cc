// What asperity writes for a user to paste: the written file is run, and what was put in comes out.
#include "engines/engine_input.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/engines/engine_support.h"

namespace asperity {
namespace {

using test::Liggghts;
using test::message_of;
using test::number_after;
using test::run_script;

#define EXPECT_CONTAINS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

std::string text(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.15g", value);
  return buffer;
}

/// The canonical contact with the paper's offsets, and torsion softer than rolling.
ContactParameters record_with_offsets() {
  ContactParameters p = test::canonical_contact();
  p.sliding_offset = EffectiveQuantity{12e-6};
  p.rolling_friction->value = 7.9e-4;
  p.rolling_offset = EffectiveQuantity{571.4e-6};
  p.torsion_offset = EffectiveQuantity{40e-6};
  p.torsion_stiffness->value = 4e-7;
  for (auto* quantity : {&p.sliding_friction, &p.sliding_offset, &p.rolling_friction, &p.rolling_offset,
                         &p.torsion_friction, &p.torsion_offset})
    (*quantity)->load_range = LoadRange{1e-4, 3e-3};
  return p;
}

/// Normal force at rest, initial stiffness and limit of one mode as an engine has them.
struct Found {
  double force = 0, stiffness = 0, limit = 0;
};

/// The mode's own motion, prescribed at the overlap of a load: sliding at vx, pure rolling at vx = R omega_y,
/// spin at omega_z. Rate such that the limit is reached in 500 of 2000 steps; the stiffness is read after
/// 100.
struct Rates {
  double vx = 0, omega_y = 0, omega_z = 0;
};
constexpr double time_step = 1e-9;

Rates motion(const ContactParameters& p, double load, Motion mode) {
  const double per_limit = 500 * time_step, R = p.particle.radius;
  switch (mode) {
    case Motion::sliding:
      return {p.sliding_limit(load) / p.lateral_stiffness_at(load) / per_limit, 0, 0};
    case Motion::rolling: {
      const double omega = p.rolling_limit(load) / p.rolling_stiffness_at(load) / per_limit;
      return {R * omega, omega, 0};
    }
    case Motion::torsion:
      return {0, 0, p.torsion_limit(load) / p.torsion_stiffness_at(load) / per_limit};
  }
  return {};
}

Found in_lammps(const ContactParameters& p, double load, Motion mode) {
  EngineInputOptions options;
  options.load = load;
  const Rates m = motion(p, load, mode);
  const double R = p.particle.radius;
  const std::string measured = mode == Motion::sliding   ? "-f_hold[1]"
                               : mode == Motion::rolling ? "-c_ty[1]"
                                                         : "-c_tz[1]";
  const double rate = mode == Motion::sliding ? m.vx : mode == Motion::rolling ? m.omega_y : m.omega_z;
  const std::string output = run_script(
      Lammps(),
      "units si\natom_style sphere\natom_modify map array\nboundary f f f\nnewton off\ncomm_modify vel yes\n"
      "region box block -2e-5 2e-5 -2e-5 2e-5 -1e-7 4e-5\ncreate_box 1 box\ncreate_atoms 1 single 0 0 " +
          text(R - p.hertz().approach(load)) + "\nset atom 1 diameter " + text(2 * R) +
          " density 2230 omega 0 " + text(m.omega_y) + " " + text(m.omega_z) +
          "\nneighbor 1e-6 bin\npair_style granular\npair_coeff * * hertz 1 0 tangential linear_nohistory 0 "
          "0\n" +
          engine_input("lammps", p, options) +  // as it is pasted
          "compute ty all property/atom tqy\ncompute tz all property/atom tqz\nfix hold all setforce 0 0 "
          "0\nfix move all nve\n"
          "timestep " +
          text(time_step) + "\nvelocity all set " + text(m.vx) + " 0 0\nvariable response equal " + measured +
          "\nvariable pressed equal f_hold[3]\nthermo_style custom step v_response v_pressed\nrun 100\n"
          "print \"force: $(v_pressed:%.12g)\"\nprint \"early: $(v_response:%.12g)\"\nrun 1900\n"
          "print \"late: $(v_response:%.12g)\"\n");
  return {number_after(output, "\nforce: "), number_after(output, "\nearly: ") / (rate * 100 * time_step),
          number_after(output, "\nlate: ")};
}

/// As in_lammps; it has no torsion.
Found in_liggghts(const ContactParameters& p, double load, Motion mode) {
  EngineInputOptions options;
  options.load = load;
  const Rates m = motion(p, load, mode);
  // Its arm is R - delta/2: what rolls at R omega slides a little.
  const double R = p.particle.radius, rate = mode == Motion::sliding ? m.vx : m.omega_y,
               vx = mode == Motion::sliding ? m.vx : m.omega_y * (R - p.hertz().approach(load) / 2);
  const std::string input = engine_input("liggghts", p, options);
  const std::string response = mode == Motion::sliding ? "-f_hold[1]" : "-c_ty[1]";
  const std::string output = run_script(
      Liggghts(),
      "hard_particles yes\natom_style granular\natom_modify map array\nboundary f f f\nnewton "
      "off\ncommunicate single vel yes\nunits si\n"
      "region reg block -2e-5 2e-5 -2e-5 2e-5 -1e-7 4e-5 units box\ncreate_box 2 reg\nneighbor 1e-6 "
      "bin\nneigh_modify delay 0\n"
      "variable restitution index 1\n" +  // what moves is prescribed: no damping on top
          input.substr(input.find("# type 1 is")) +
          "create_atoms 1 single 0 0 " + text(R - p.hertz().approach(load)) +
          " units box\nset group all diameter " + text(2 * R) + " density 2230\nset group all omegay " +
          text(m.omega_y) +
          "\ncompute ty all property/atom tqy\nfix hold all setforce 0. 0. 0.\nfix move all nve\ntimestep " +
          text(time_step) + "\nvelocity all set " + text(vx) + " 0. 0. units box\nvariable response equal " +
          response +
          "\nvariable pressed equal f_hold[3]\nthermo_style custom step v_response v_pressed\nrun 100\n"
          "print \"force: ${pressed}\"\nprint \"early: ${response}\"\nrun 1900\nprint \"late: "
          "${response}\"\n");
  return {number_after(output, "\nforce: "), number_after(output, "\nearly: ") / (rate * 100 * time_step),
          number_after(output, "\nlate: ")};
}

Found in_yade(const ContactParameters& p, double load, Motion mode) {
  EngineInputOptions options;
  options.load = load;
  const Rates m = motion(p, load, mode);
  const double rate = mode == Motion::sliding ? m.vx : mode == Motion::rolling ? m.omega_y : m.omega_z;
  const std::string measured = mode == Motion::sliding   ? "O.forces.f(b)[0]"
                               : mode == Motion::rolling ? "contact().phys.momentBend.norm()"
                                                         : "O.forces.t(b)[2]";
  const std::string output = run_script(
      Yade(), "from yade import *\nimport os, sys\nR = " + text(p.particle.radius) + "\n" +
                  engine_input("yade", p, options) +  // as it is pasted
                  "def glass(label): return O.materials.append(FrictMat(young=1e9, poisson=0.3, "
                  "frictionAngle=0.1, density=2230, label=label))\n"
                  "large = 1e5*R\ns = O.bodies.append(utils.sphere((0, 0, -large), large, "
                  "material=glass(TARGET), fixed=True))\n"
                  "b = O.bodies.append(utils.sphere((0, 0, R - " +
                  text(p.hertz().approach(load)) +
                  "), R, material=glass(PARTICLE)))\n"
                  "O.bodies[b].state.blockedDOFs = 'xyzXYZ'\nO.dt = " +
                  text(time_step) +
                  "\n"
                  "O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb()]),\n"
                  "    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_MindlinPhys()],\n"
                  "                    [Law2_ScGeom_MindlinPhys_Mindlin(includeMoment=True)]),\n"
                  "    PyRunner(command='asperity_step()', iterPeriod=1, initRun=True), "
                  "NewtonIntegrator(damping=0)]\n"
                  "def contact(): return O.interactions[s, b]\nO.run(1, True)\nprint('force: %.12g' % "
                  "O.forces.f(b)[2])\n"
                  "O.bodies[b].state.vel = (" +
                  text(m.vx) + ", 0, 0)\nO.bodies[b].state.angVel = (0, " + text(m.omega_y) + ", " +
                  text(m.omega_z) +
                  ")\n"
                  "O.run(100, True)\nprint('early: %.12g' % abs(" +
                  measured + "))\nO.run(1900, True)\nprint('late: %.12g' % abs(" + measured +
                  "))\n"
                  "sys.stdout.flush(); os._exit(0)\n");
  return {number_after(output, "force: "), number_after(output, "early: ") / (rate * 100 * time_step),
          number_after(output, "late: ")};
}

/// C and h of limit = C (f + h) from two loads, and force and stiffness at each, against the record.
template <class Run>
void expect_round_trip(const char* engine, const Run& run, double tolerance, bool has_torsion = true) {
  test::Largest error;
  const ContactParameters p = record_with_offsets();
  const double low = 2e-4, high = 2e-3;
  struct Expected {
    Motion mode;
    double coefficient, offset;
    double (ContactParameters::*stiffness)(double) const;
  };
  const double R = p.particle.radius;
  for (const Expected& e :
       {Expected{Motion::sliding, 0.23, 12e-6, &ContactParameters::lateral_stiffness_at},
        Expected{Motion::rolling, 7.9e-4 * R, 571.4e-6, &ContactParameters::rolling_stiffness_at},
        Expected{Motion::torsion, 0.0056 * R, 40e-6, &ContactParameters::torsion_stiffness_at}}) {
    if (e.mode == Motion::torsion && !has_torsion) continue;
    const Found at_low = run(p, low, e.mode), at_high = run(p, high, e.mode);
    for (const double ratio :
         {at_low.force / low, at_high.force / high, at_low.stiffness / (p.*e.stiffness)(low),
          at_high.stiffness / (p.*e.stiffness)(high)})
      error.count(ratio - 1);
    const double C = (at_high.limit - at_low.limit) / (high - low), h = at_low.limit / C - low;
    error.count(C / e.coefficient - 1);
    error.count((h - e.offset) / (e.offset + low));  // known from the limit at the lower load
    std::printf("mode %d: largest error so far %.2g\n", static_cast<int>(e.mode), static_cast<double>(error));
  }
  const std::string modes = has_torsion ? "sliding, rolling and torsion" : "sliding and rolling";
  const test::Verified verified{
      "Engines", engine + (", written input run, " + modes + ": force, stiffness, C, h over f + h"),
      "what was written"};
  EXPECT_TRUE(verified.below(error, tolerance));
}

TEST(EngineInput_other_code,
     lammps_gives_back_stiffness_friction_torque_factors_and_offsets_that_were_written_for_it) {
  ASPERITY_ENGINE_OR_SKIP(Lammps());
  expect_round_trip("LAMMPS", in_lammps, 1e-4);
}

TEST(EngineInput_other_code,
     yade_gives_back_stiffness_friction_torque_factors_and_offsets_that_were_written_for_it) {
  ASPERITY_ENGINE_OR_SKIP(Yade());
  expect_round_trip("YADE", in_yade, 1e-4);
}

TEST(EngineInput_other_code,
     liggghts_gives_back_stiffness_friction_torque_factor_and_offsets_that_were_written_for_it) {
  ASPERITY_ENGINE_OR_SKIP(Liggghts());
  constexpr bool has_torsion = false;
  expect_round_trip("LIGGGHTS", in_liggghts, 3e-3,
                    has_torsion);  // its rolling spring counts angles with R/(R - delta/2), 0.27 % at 2 mN
}

TEST(EngineInput_analytic, folded_limit_errs_as_much_at_both_ends_of_the_load_range) {
  const auto limit = [](double f) { return 0.23 * (f + 1e-4); };
  const auto coulomb = [](double f) { return f; };
  const Folded balanced = fold(limit, coulomb, {1e-4, 9e-4}, std::nullopt);
  EXPECT_NEAR(balanced.error_low, -balanced.error_high, 1e-12);
  EXPECT_LT(balanced.error_low, 0);  // too weak where the offset matters most
  const Folded right_at_low = fold(limit, coulomb, {1e-4, 9e-4}, 1e-4);
  EXPECT_NEAR(right_at_low.error_low, 0, 1e-12);
  EXPECT_NEAR(right_at_low.number, 0.46, 1e-12);
  EXPECT_NEAR(right_at_low.error_high, 0.46 * 9e-4 / (0.23 * 1e-3) - 1, 1e-12);
  EXPECT_TRUE(fold(coulomb, coulomb, {1e-4, 9e-4}, std::nullopt).is_exact());
}

TEST(EngineInput_analytic, coefficients_carry_the_lever_arms_of_each_engine) {
  ContactParameters p = test::canonical_contact();
  const double R = 8.5e-6, C_ro = 5.304e-3 * R, C_to = 0.0056 * R;
  EngineInputOptions options;
  options.load = 1e-4;
  const auto number = [&](const std::string& engine, const std::string& label) {
    return number_after(engine_input(engine, p, options), label);
  };
  EXPECT_NEAR(number("lammps", "rolling sds mu = "), C_ro / R, 1e-12);
  EXPECT_NEAR(number("lammps", "twisting sds mu = "), C_to, 1e-18);
  EXPECT_NEAR(number("lammps", "mindlin k = "), 8 * 11.7989e9, 1);
  EXPECT_NEAR(number("mercurydpm", "setEffectiveShearModulus("), 1.5 * 11.7989e9, 1);
  EXPECT_NEAR(number("mercurydpm", "setTorsionFrictionCoefficient("), C_to / (2 * R), 1e-12);
  EXPECT_NEAR(number("mercurydpm", "setRollingFrictionCoefficient("), C_ro / R, 1e-12);
  EXPECT_NEAR(number("liggghts", "coefficientRollingFriction = "), C_ro / R, 1e-12);
  // K_ro = prefactor k_n mu^2 R^2 with k_n = 4/3 E* a.
  const double prefactor = number("liggghts", "rollingStiffness scalar ");
  EXPECT_NEAR(
      prefactor * 4.0 / 3 * 52.8684e9 * p.contact_radius(1e-4) * C_ro * C_ro / p.rolling_stiffness_at(1e-4),
      1, 1e-9);
  EXPECT_NEAR(number("yade", "maxBendPl = "), C_ro, 1e-16);
  EXPECT_NEAR(number("kratos", "\"ROLLING_FRICTION\": "), C_ro / R, 1e-9);
  EXPECT_NEAR(number("musen", "\nINTERACTION_PROPERTY ROLLING_FRICTION KEY_1 KEY_2 "), C_ro / R, 1e-9);

  // Two equal spheres: R_e = R/2, twice that in MercuryDPM's torsion, the smaller radius in Kratos.
  p.target.radius = R;
  EXPECT_NEAR(number("lammps", "rolling sds mu = "), 2 * C_ro / R, 1e-12);
  EXPECT_NEAR(number("mercurydpm", "setTorsionFrictionCoefficient("), C_to / R, 1e-12);
  EXPECT_NEAR(number("kratos", "\"ROLLING_FRICTION\": "), C_ro / R, 1e-9);
  EXPECT_CONTAINS(engine_input("lammps", p, options), "\npair_coeff 1 2 hertz");
}

TEST(EngineInput_behaviour, header_says_what_an_engine_cannot_express_with_errors_at_both_ends) {
  const ContactParameters p = read_contact_parameters(test::paper_run("parameters_silicon.json"));
  const std::string lammps = engine_input("lammps", p, {});
  // C (1 + h/f) at 100 uN and 3 mN is 6.714 and 1.190 C: the balanced number is 2/(1/6.714 + 1/1.190) = 2.022
  // C.
  EXPECT_CONTAINS(lammps,
                  "rolling limit, whose offset h = 0.0005714 N has no place of its own and is folded into "
                  "the coefficient: "
                  "-69.9 % at 0.0001 N, +69.9 % at 0.003 N");
  EXPECT_CONTAINS(lammps,
                  "rolling stiffness, which is constant here: +51.3 % at 0.0001 N, -51.3 % at 0.003 N");
  EXPECT_CONTAINS(lammps, "pull-off force h_n = 3.2e-06 N");
  EXPECT_CONTAINS(engine_input("mercurydpm", p, {}),
                  "torsion stiffness, which is 8 G a (2 R_e)^2 with that G and cannot be set: +500.0 %");
  EXPECT_CONTAINS(engine_input("liggghts", p, {}), "-100.0 % at every load");
  EXPECT_CONTAINS(engine_input("kratos", p, {}), "spin included");
}

TEST(EngineInput_behaviour, load_outside_of_the_fitted_ones_is_said_to_be_outside) {
  EngineInputOptions options;
  options.load = 5e-4;
  EXPECT_CONTAINS(
      engine_input("lammps", read_contact_parameters(test::paper_run("parameters_silicon.json")), options),
      "-8.6 % at 0.0001 N; 0.0005 N lies outside of the loads it was fitted on");
}

TEST(EngineInput_behaviour, length_scale_that_grows_with_the_contact_is_fixed_and_said_to_be) {
  ContactParameters p = test::canonical_contact();
  p.rolling_friction->length_scale = LengthScale::contact_radius;
  EXPECT_CONTAINS(message_of<InputError>([&] { engine_input("lammps", p, {}); }),
                  "give the load at which it shall be right with --load");
  p.rolling_friction->load_range = LoadRange{1e-4, 2.7e-3};
  // a grows threefold over this range: 2/(1 + 1/3) = 1.5 times the lower one.
  EXPECT_CONTAINS(engine_input("lammps", p, {}),
                  "rolling limit, whose length scale grows with the contact radius and is fixed here: +50.0 "
                  "% at 0.0001 N, -50.0 % at 0.0027 N");
}

TEST(EngineInput_behaviour, shear_stiffness_that_no_Poisson_ratio_gives_is_said_to_be_out_of_reach) {
  ContactParameters p = test::canonical_contact();
  EXPECT_EQ(engine_input("liggghts", p, {}).find("lateral stiffness, which follows"), std::string::npos);
  p.reduced_shear_modulus->value = 1.2096e9;  // the published loop's slope: a tenth of Mindlin's
  EXPECT_CONTAINS(
      engine_input("liggghts", p, {}),
      "lateral stiffness, which follows from E and nu here and cannot be as that of the record: +");
  p.reduced_shear_modulus->value = 12.5e9;
  EXPECT_CONTAINS(engine_input("liggghts", p, {}), "E and nu are those of two equal bodies");
}

TEST(EngineInput_behaviour, names_the_engine_that_was_meant) {
  EXPECT_EQ(message_of<InputError>([] { engine_input("ligghts", test::canonical_contact(), {}); }),
            "there is no engine 'ligghts'; did you mean 'liggghts'?");
}

}  // namespace
}  // namespace asperity

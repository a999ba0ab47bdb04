// Many particles that yield, as engines take them: Luding's law (2008) of every pair, at the size of its
// bodies.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/error.h"
#include "dem_compare/laws/luding.h"
#include "engines/many_particles/matrix_inputs.h"
#include "engines/many_particles/particle_box.h"
#include "engines/many_particles/time_step.h"
#include "tests/engines/box_support.h"
#include "tests/engines/engine_support.h"
#include "tests/engines/luding_support.h"

namespace asperity {
namespace {

using test::BoxRun;
using test::canonical_contact;
using test::expect_that_energy_never_rises;
using test::expect_the_law;
using test::Liggghts;
using test::message_of;
using test::number_after;
using test::run_box;
using test::run_script;

constexpr double R = 8.5e-6, nm = 1e-9;

/// A sphere of 8.5 um on a plane of silicon: k1, k_p and k_c in N/m, k_l = k1 as LIGGGHTS has it.
ContactParameters yielded(const std::string& file, const std::string& particle, double k1, double kp,
                          double kc, double full_approach) {
  ContactParameters p = canonical_contact();
  p.file = file;
  p.particle.material = particle;
  p.sliding_friction->load_range = LoadRange{1e-5, 3e-4};
  p.rolling_friction.reset(), p.torsion_friction.reset();
  p.rolling_stiffness.reset(), p.torsion_stiffness.reset();
  p.reduced_shear_modulus.reset();
  p.lateral_stiffness = EffectiveQuantity{k1};
  p.luding_k1 = EffectiveQuantity{k1};
  p.luding_kp = EffectiveQuantity{kp};
  p.luding_kc = EffectiveQuantity{kc};
  p.luding_delta_p = EffectiveQuantity{full_approach};
  return p;
}

MaterialMatrix two_materials(double kc, double restitution = 1) {
  MatrixOptions options;
  options.normal_law = "luding";
  options.restitution = restitution;
  return material_matrix({yielded("glass.json", "glass", 20e3, 50e3, kc, 40 * nm),
                          yielded("hard.json", "hard glass", 24e3, 40e3, kc, 30 * nm)},
                         options);
}

/// By hand: stiffness over R_e and phi_f are the mean of both materials', of R_e = 8.5 um.
TEST(YieldingMatrix_analytic, pairs_without_a_record_are_the_mean_at_their_own_size) {
  const MaterialMatrix m = two_materials(8e3);
  const LudingPair& mixed = *m.pair(0, 2).law.luding;
  EXPECT_TRUE(m.pair(0, 2).is_mixed);
  EXPECT_NEAR(mixed.k1 * R, 22e3, 1e-6);
  EXPECT_NEAR(mixed.kp * R, 45e3, 1e-6);
  EXPECT_NEAR(mixed.kc * R, 8e3, 1e-6);
  EXPECT_NEAR(mixed.lateral * R, 22e3, 1e-6);
  const double phi = (40 * nm * 30e3 / 50e3 + 30 * nm * 16e3 / 40e3) / 2 / (2 * R);
  EXPECT_NEAR(mixed.phi / phi, 1, 1e-12);
  EXPECT_NEAR(m.pair(0, 1).law.luding->full_approach(R), 40 * nm, 1e-15);
  EXPECT_DOUBLE_EQ(m.constant_radius(0, 1), R);
  EXPECT_DOUBLE_EQ(m.constant_radius(0, 2), R / 2);
}

/// The stiffest spring is k_p of a pair: two glass spheres have half of it over half of their mass.
TEST(YieldingMatrix_analytic, time_step_and_speed_of_the_box_follow_its_springs) {
  const MaterialMatrix m = two_materials(0);
  const double mass = 4.0 / 3 * M_PI * R * R * R * canonical_contact().particle.density;
  EXPECT_NEAR(time_step_of(m).shortest_period / (2 * M_PI * std::sqrt(0.4 * mass / 24e3)), 1, 1e-9)
      << time_step_of(m).spring;  // lateral, of hard glass: k_l R^2 over (2/5) m R^2
  // Half of 300 uN is on the straight line k1 of two spheres of a kind, whose work is m v^2.
  const double load = 1.5e-4, k1 = 24e3 / 2;
  EXPECT_LT(load, k1 * 30 * nm / 2);
  EXPECT_NEAR(particle_box(m, 8).speed / std::sqrt(load * load / (2 * k1) / mass), 1, 1e-9);
}

TEST(YieldingMatrix_behaviour, says_what_it_lacks_and_which_engines_take_it) {
  MatrixOptions options;
  options.normal_law = "luding";
  ContactParameters elastic = yielded("glass.json", "glass", 20e3, 50e3, 0, 40 * nm);
  elastic.luding_k1.reset();
  EXPECT_NE(message_of<InputError>([&] { material_matrix({elastic}, options); }).find("'luding_k1'"),
            std::string::npos);
  const MaterialMatrix m = two_materials(0);
  for (const std::string& key : {"lammps", "kratos", "musen"})
    EXPECT_NE(message_of<InputError>([&] {
                matrix_input_of(written_engine_of(key), m);
              }).find("it does for liggghts, mercurydpm and yade"),
              std::string::npos);
  ContactParameters sticky = yielded("glass.json", "glass", 20e3, 50e3, 0, 40 * nm);
  sticky.pull_off_force = EffectiveQuantity{1e-6};
  EXPECT_NE(matrix_input_of(written_engine_of("liggghts"), material_matrix({sticky}, options))
                .find("the record has no luding_kc"),
            std::string::npos);
  options.normal_law = "mdr";
  EXPECT_NE(
      message_of<InputError>([&] { material_matrix({elastic}, options); }).find("one contact at a time"),
      std::string::npos);
  const std::string mercury = matrix_input_of(written_engine_of("mercurydpm"), m);
  EXPECT_NE(mercury.find("type_1_2->setLoadingStiffness(20000)"), std::string::npos) << mercury;
  EXPECT_NE(mercury.find("type_1->setUnloadingStiffnessMax(25000)"), std::string::npos) << mercury;
  options.normal_law = "luding";
  options.radii = LoadRange{4e-6, 8e-6};
  const MaterialMatrix sizes =
      material_matrix({yielded("glass.json", "glass", 20e3, 50e3, 0, 40 * nm)}, options);
  EXPECT_NE(matrix_input_of(written_engine_of("liggghts"), sizes).find("2 times what it should be"),
            std::string::npos);
}

/// The law of a pair at an effective radius.
Luding law_at(const MaterialMatrix& m, std::size_t i, std::size_t j, double effective_radius) {
  const LudingPair& pair = *m.pair(i, j).law.luding;
  return {pair.k1 * effective_radius, pair.kp * effective_radius, pair.kc * effective_radius,
          pair.full_approach(effective_radius), effective_radius};
}

TEST(YieldingParticles_other_code, pair_and_plane_follow_the_law_in_liggghts) {
  ASPERITY_ENGINE_OR_SKIP(Liggghts());
  const MaterialMatrix m = two_materials(8e3);
  for (const bool on_plane : {false, true}) {
    const Luding law = on_plane ? law_at(m, 0, 1, R) : law_at(m, 0, 2, R / 2);
    const int steps = int(law.full_approach / (0.5 * nm) + 1e-6);  // beyond it engines are stiffer
    const std::string lower = on_plane ? "" : "create_atoms 3 single 0 0 8.5e-6 units box\n",
                      height = on_plane ? "8.5e-6" : "25.5e-6", moved = on_plane ? "1" : "2";
    std::string script =
        "hard_particles yes\natom_style granular\natom_modify map array\nboundary f f f\nnewton "
        "off\ncommunicate single vel yes\nunits si\nregion reg block -8e-5 8e-5 -4e-5 4e-5 -1e-6 8e-5 units "
        "box\ncreate_box 3 reg\nneighbor 1e-6 bin\nneigh_modify delay 0\n" +
        matrix_input_of(written_engine_of("liggghts"), m) + "timestep 1e-9\n" + lower +
        "create_atoms 1 single 0 0 " + height + " units box\nset group all diameter 17e-6 density 2230\n" +
        (on_plane ? "fix floor all wall/gran ${on_plane} primitive type 2 zplane 0.0\n" : "") +
        "group moved id " + moved + "\nvariable f equal fz[" + moved + "]\nvariable d equal " + height +
        "-z[" + moved + "]\nthermo_style custom step v_f v_d\nthermo 1000\n";
    const auto drive = [&](const char* fix, const char* speed, int count) {
      script += std::string("fix ") + fix + " moved move linear 0 0 " + speed + " units box\n";
      for (int i = 0; i < count; ++i) script += "run 1000\nprint \"at ${d} ${f}\"\n";
      script += std::string("unfix ") + fix + "\n";
    };
    drive("down", "-5e-4", steps);
    drive("up", "5e-4", int(0.9 * steps));
    expect_the_law(
        run_script(Liggghts(), script), law, law.full_approach,
        on_plane ? "LIGGGHTS, many particles, on a plane" : "LIGGGHTS, many particles, a mixed pair");
  }
}

TEST(YieldingParticles_other_code, pair_and_plane_follow_the_law_in_yade_at_other_sizes) {
  ASPERITY_ENGINE_OR_SKIP(Yade());
  const MaterialMatrix m = two_materials(8e3);
  for (const bool on_plane : {false, true}) {
    // 5 um on 10 um, or on a wall.
    const Luding law = on_plane ? law_at(m, 0, 1, 5e-6) : law_at(m, 0, 2, 10e-6 / 3);
    const std::string output =
        run_script(Yade(), "from yade import *\nimport os, sys\n" + matrix_input_of(Yade(), m) +
                               "on_plane, deepest = " + (on_plane ? "True" : "False") + ", " +
                               std::to_string(law.full_approach * 1e9) + R"(e-9
glass, silicon, hard = asperity_materials
O.bodies.append(utils.wall(0, axis=2, material=silicon) if on_plane
                else utils.sphere((0, 0, -10e-6), 10e-6, material=hard, fixed=True))
upper = O.bodies.append(utils.sphere((0, 0, 5e-6), 5e-6, material=glass))
state = O.bodies[upper].state
state.blockedDOFs = 'xyzXYZ'
O.dt = 1e-9
O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()]),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()],
                    [asperity_functor], [asperity_law]),
    PyRunner(command='asperity_step()', iterPeriod=1, initRun=True), NewtonIntegrator(damping=0)]
print()
for speed, count in ((-1e-3, 40), (1e-3, 35)):
    state.vel = (0, 0, speed)
    for i in range(count):
        O.run(round(deepest/40/1e-12), True)
        force = O.forces.f(upper)[2]  # at the step's beginning
        print('at %.9g %.9g' % (5e-6 - (state.pos[2] - speed*O.dt), force))
sys.stdout.flush(); os._exit(0)
)");
    expect_the_law(output, law, law.full_approach,
                   on_plane ? "YADE, many particles, on a wall" : "YADE, many particles, a mixed pair");
  }
}

/// Pressed by 10 nm and slid on a wall: k_l of the shift, then mu k1 delta. k_l is not k1 here.
TEST(YieldingParticles_other_code, a_contact_slides_by_its_own_stiffness_and_friction_in_yade) {
  ASPERITY_ENGINE_OR_SKIP(Yade());
  ContactParameters record = yielded("glass.json", "glass", 20e3, 50e3, 0, 40 * nm);
  record.lateral_stiffness = EffectiveQuantity{13e3};
  MatrixOptions options;
  options.normal_law = "luding", options.restitution = 1;
  const std::string output =
      run_script(Yade(), "from yade import *\nimport os, sys\n" +
                             matrix_input_of(Yade(), material_matrix({record}, options)) + R"(
R, d = 8.5e-6, 10e-9
O.bodies.append(utils.wall(0, axis=2, material=asperity_materials[1]))
b = O.bodies.append(utils.sphere((0, 0, R - d), R, material=asperity_materials[0]))
O.bodies[b].state.blockedDOFs = 'xyzXYZ'
O.dt = 1e-9
O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()]),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()],
                    [asperity_functor], [asperity_law]),
    PyRunner(command='asperity_step()', iterPeriod=1, initRun=True), NewtonIntegrator(damping=0)]
O.run(1, True)
O.bodies[b].state.vel = (1e-3, 0, 0)
for name, steps in (('sticks', 1001), ('slips', 20000)):
    O.run(steps, True)
    print('\n%s: %.9g end' % (name, abs(O.forces.f(b)[0])))
sys.stdout.flush(); os._exit(0)
)");
  const double lateral = record.lateral_stiffness_at(20e3 * 10 * nm);
  EXPECT_NEAR(number_after(output, "\nsticks: ") / (lateral * 1 * nm), 1, 0.01) << output;
  EXPECT_NEAR(number_after(output, "\nslips: ") / (0.23 * 20e3 * 10 * nm), 1, 0.01) << output;
}

/// Two spheres of a kind whose k_p is hardly more than k1 come apart at the restitution asked for: 0.8 of the
/// speed at which they met.
TEST(YieldingParticles_other_code, an_impact_that_hardly_yields_has_the_restitution_asked_for) {
  ASPERITY_ENGINE_OR_SKIP(Liggghts());
  constexpr double asked = 0.8, within = 0.02;  // with the time step advised
  MatrixOptions options;
  options.normal_law = "luding", options.restitution = asked;
  const MaterialMatrix m =
      material_matrix({yielded("glass.json", "glass", 20e3, 20.01e3, 0, 400 * nm)}, options);
  const std::string liggghts = run_script(
      Liggghts(),
      "hard_particles yes\natom_style granular\natom_modify map array\nboundary f f f\nnewton "
      "off\ncommunicate "
      "single vel yes\nunits si\nregion reg block -8e-5 8e-5 -4e-5 4e-5 -1e-6 8e-5 units box\ncreate_box 2 "
      "reg\nneighbor 1e-6 bin\nneigh_modify delay 0\n" +
          matrix_input_of(written_engine_of("liggghts"), m) +
          "create_atoms 1 single 0 0 2e-5 units box\ncreate_atoms 1 single 0 0 3.7001e-5 units box\nset "
          "group all "
          "diameter 17e-6 density 2230\ngroup upper id 2\nvelocity upper set 0.0 0.0 -0.05 units box\nfix "
          "move "
          "all nve/sphere\nvariable a equal vz[1]\nvariable b equal vz[2]\nthermo_style "
          "custom step "
          "v_a v_b\nrun 1000\nvariable gone equal (v_b-v_a)/0.05\nprint \"gone: ${gone}\"\n");
  EXPECT_NEAR(number_after(liggghts, "\ngone: "), asked, within) << liggghts;
  ASPERITY_ENGINE_OR_SKIP(Yade());
  const std::string yade =
      run_script(Yade(), "from yade import *\nimport os, sys\n" + matrix_input_of(Yade(), m) + R"(
bodies = [O.bodies.append(utils.sphere((0, 0, z), 8.5e-6, material=asperity_materials[0]))
          for z in (0, 17.001e-6)]
O.bodies[bodies[1]].state.vel = (0, 0, -0.05)
O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb()]),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [asperity_functor], [asperity_law]),
    PyRunner(command='asperity_step()', iterPeriod=1, initRun=True), NewtonIntegrator(damping=0)]
O.run(1000, True)
lower, upper = (O.bodies[b].state.vel[2] for b in bodies)
print('\ngone: %.9g end' % ((upper - lower)/0.05))
sys.stdout.flush(); os._exit(0)
)");
  EXPECT_NEAR(number_after(yade, "\ngone: "), asked, within) << yade;
}

/// Energy goes into yielding alone: there is no damping.
TEST(YieldingParticles_other_code, boxes_of_two_materials_cool_alike_in_liggghts_and_yade) {
  ASPERITY_ENGINE_OR_SKIP(Liggghts());
  const MaterialMatrix m = two_materials(0);
  constexpr double least = 0.02;
  constexpr int few = 125, many = 1000;
  const BoxRun thousand = run_box(written_engine_of("liggghts"), Liggghts(), m, many, {"-in", "in.box"});
  expect_that_energy_never_rises(thousand, m, particle_box(m, many), least);
  ASPERITY_ENGINE_OR_SKIP(Yade());
  const BoxRun liggghts = run_box(written_engine_of("liggghts"), Liggghts(), m, few, {"-in", "in.box"}),
               yade = run_box(Yade(), Yade(), m, few, {"-n", "-x", "box.py"});
  expect_that_energy_never_rises(yade, m, particle_box(m, few), least);
  // Two programs that share nothing but the files' numbers.
  EXPECT_NEAR(yade.energy.back() / liggghts.energy.back(), 1, 0.1);
}

}  // namespace
}  // namespace asperity

// A matrix of materials as each engine takes it: pairs found and mixed, contacts that give the law back in
// the engine itself, and boxes of particles that run from the files as written.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/error.h"
#include "core/shear_moduli.h"
#include "engines/engine_input.h"
#include "engines/many_particles/material_matrix.h"
#include "engines/many_particles/matrix_header.h"
#include "engines/many_particles/particle_box.h"
#include "engines/many_particles/time_step.h"
#include "tests/engines/box_support.h"
#include "tests/engines/engine_support.h"

namespace asperity {
namespace {

using test::BoxRun;
using test::canonical_contact;
using test::expect_that_energy_never_rises;
using test::Liggghts;
using test::message_of;
using test::number_after;
using test::run_box;
using test::run_script;

constexpr double radius = 8.5e-6, restitution = 0.8;

/// Borosilicate on silicon with rolling and torsion that are alike in all loads.
ContactParameters glass_on_silicon() {
  ContactParameters p = canonical_contact();
  p.file = "glass.json";
  p.sliding_friction->load_range = LoadRange{1e-5, 1e-4};
  for (auto* stiffness : {&p.rolling_stiffness, &p.torsion_stiffness})
    (*stiffness)->length_scale = LengthScale::particle_radius;
  p.torsion_stiffness->value /= 4;
  return p;
}

ContactParameters polystyrene_on_silicon() {
  ContactParameters p = glass_on_silicon();
  p.file = "polystyrene.json";
  p.particle = {"polystyrene", radius, 3.4e9, 0.33, 1050};
  const ElasticBody plastic{3.4e9, 0.33}, silicon{179e9, 0.25};
  p.reduced_modulus->value = reduced_modulus(plastic, silicon);
  p.reduced_shear_modulus->value = reduced_shear_modulus(plastic, silicon);
  p.sliding_friction->value = 0.41;
  p.rolling_friction->value *= 2;
  p.rolling_stiffness->value /= 4;
  return p;
}

MaterialMatrix two_materials(double e = restitution) {
  MatrixOptions options;
  options.restitution = e;
  return material_matrix({glass_on_silicon(), polystyrene_on_silicon()}, options);
}

TEST(MaterialMatrix_analytic, pairs_are_found_or_mixed_from_both_materials) {
  const MaterialMatrix m = two_materials();
  ASSERT_EQ(m.materials.size(), 3u);
  EXPECT_EQ(m.materials[0].name + m.materials[1].name + m.materials[2].name,
            "borosilicatesiliconpolystyrene");
  ASSERT_EQ(m.pairs.size(), 6u);
  EXPECT_EQ(m.wall(), 1u);
  const PairLaw& found = m.pair(1, 0).law;
  EXPECT_FALSE(m.pair(0, 1).is_mixed);
  EXPECT_DOUBLE_EQ(found.sliding, 0.23);
  EXPECT_DOUBLE_EQ(found.rolling, 5.304e-3);
  EXPECT_DOUBLE_EQ(found.torsion, 0.0056);
  EXPECT_NEAR(found.rolling_stiffness, 1.56385e-6 / radius / radius, 1e-4 * found.rolling_stiffness);
  // The pair that no record has: moduli of both bodies, the mean of the rest.
  const MaterialPair& mixed = m.pair(0, 2);
  EXPECT_TRUE(mixed.is_mixed);
  EXPECT_NEAR(mixed.law.reduced_modulus, 1 / ((1 - 0.17 * 0.17) / 71e9 + (1 - 0.33 * 0.33) / 3.4e9), 1);
  EXPECT_NEAR(mixed.law.shear_modulus, 1 / ((2 - 0.17) * 2 * 1.17 / 71e9 + (2 - 0.33) * 2 * 1.33 / 3.4e9), 1);
  EXPECT_DOUBLE_EQ(mixed.law.sliding, (0.23 + 0.41) / 2);
  EXPECT_DOUBLE_EQ(mixed.law.rolling, 1.5 * 5.304e-3);
  EXPECT_NE(mixed.origin.find("no record has this pair"), std::string::npos);
  // A record of two equal particles comes before what others say of the material.
  ContactParameters like = glass_on_silicon();
  like.target = like.particle;
  like.sliding_friction->value = 0.5;
  const MaterialMatrix with_like = material_matrix({glass_on_silicon(), polystyrene_on_silicon(), like}, {});
  EXPECT_DOUBLE_EQ(with_like.pair(0, 0).law.sliding, 0.5);
  EXPECT_DOUBLE_EQ(with_like.pair(0, 2).law.sliding, (0.5 + 0.41) / 2);
  EXPECT_NEAR(with_like.pair(0, 0).law.rolling_stiffness, 4 * found.rolling_stiffness,
              1e-9 * found.rolling_stiffness);  // its K over its own R_e^2
}

TEST(MaterialMatrix_analytic, resistance_that_one_of_both_lacks_is_not_made_up) {
  ContactParameters bare = polystyrene_on_silicon();
  bare.rolling_friction.reset();
  const MaterialMatrix m = material_matrix({glass_on_silicon(), bare}, {});
  EXPECT_EQ(m.pair(0, 2).law.rolling, 0);
  EXPECT_GT(m.pair(0, 1).law.rolling, 0);
  EXPECT_EQ(m.pair(1, 1).law.rolling, 0);  // silicon: one of its pairs lacks it
}

TEST(MaterialMatrix_analytic, zero_friction_is_a_value_and_not_one_that_is_missing) {
  ContactParameters smooth = polystyrene_on_silicon();
  smooth.sliding_friction->value = 0;
  EXPECT_DOUBLE_EQ(material_matrix({glass_on_silicon(), smooth}, {}).pair(0, 2).law.sliding, 0.23 / 2);
}

TEST(MaterialMatrix_regression, refuses_what_records_cannot_say) {
  const auto refused = [](std::vector<ContactParameters> records, const MatrixOptions& options = {}) {
    return message_of<InputError>([&] { material_matrix(records, options); });
  };
  ContactParameters other = polystyrene_on_silicon();
  other.target.youngs_modulus = 170e9;
  EXPECT_NE(
      refused({glass_on_silicon(), other}).find("polystyrene.json: Young's modulus of 'silicon' is another"),
      std::string::npos);
  EXPECT_NE(refused({glass_on_silicon(), glass_on_silicon()}).find("give each pair once"), std::string::npos);
  ContactParameters nameless = glass_on_silicon();
  nameless.particle.material.clear();
  EXPECT_NE(refused({nameless}).find("'particle/material' is missing"), std::string::npos);
  ContactParameters unknown = polystyrene_on_silicon();
  unknown.particle.youngs_modulus = std::nan("");
  EXPECT_NE(refused({glass_on_silicon(), unknown}).find("cannot be mixed"), std::string::npos);
  ContactParameters no_range = glass_on_silicon();
  no_range.sliding_friction->load_range.reset();
  EXPECT_NE(refused({no_range}).find("--load"), std::string::npos);
  MatrixOptions options;
  options.restitution = 1.5;
  EXPECT_NE(refused({glass_on_silicon()}, options).find("restitution"), std::string::npos);
}

TEST(MaterialMatrix_analytic, time_step_is_a_share_of_rayleigh_time_and_of_the_shortest_period) {
  const MaterialMatrix m = two_materials();
  const TimeStep step = time_step_of(m);
  const double G = 71e9 / 2 / 1.17;
  EXPECT_NEAR(step.rayleigh, M_PI * radius * std::sqrt(2230 / G) / (0.1631 * 0.17 + 0.8766), 1e-14);
  // Of polystyrene, the lighter one, on silicon: k_l R^2 + K_ro over (2/5) m R^2, or two particles of it.
  EXPECT_NE(step.spring.find("lateral and rolling"), std::string::npos) << step.spring;
  // A sphere on a plane, or two of a kind, with masses m and m/2 on the springs of R and R/2; silicon has no
  // density.
  double fastest = 0;
  for (const std::size_t own : {0, 2})
    for (const std::size_t other : {0, 1, 2})
      for (const int spheres : {1, 2}) {
        const double mass = 4.0 / 3 * M_PI * std::pow(radius, 3) * (own == 0 ? 2230 : 1050);
        const PairLaw& law = m.pair(own, other).law;
        const double R_e = radius / spheres;
        const double delta = std::pow(0.75 * 1e-4 / (law.reduced_modulus * std::sqrt(R_e)), 2.0 / 3);
        const double k_l = 8 * law.shear_modulus * std::sqrt(R_e * delta),
                     K = law.rolling_stiffness * R_e * R_e;
        fastest = std::max(fastest, (k_l + K / (radius * radius)) / (0.4 * mass / spheres));
      }
  EXPECT_NEAR(step.shortest_period / (2 * M_PI / std::sqrt(fastest)), 1, 1e-9);
  EXPECT_DOUBLE_EQ(step.advised, std::min(step.rayleigh / 5, step.shortest_period / 30));
  EXPECT_NEAR(damping_ratio(1), 0, 1e-15);
  EXPECT_NEAR(damping_ratio(std::exp(-M_PI)), std::sqrt(0.5), 1e-12);
}

TEST(MaterialMatrix_regression, every_engine_names_all_pairs_and_escapes_their_names) {
  ContactParameters hostile = glass_on_silicon();
  hostile.particle.material = "glass\n\"\"\"&\nshell rm";
  const MaterialMatrix m = material_matrix({hostile, polystyrene_on_silicon()}, {});
  for (const std::string& key : engine_input_names()) {
    if (key == "own") continue;
    const std::string text = written_engine_of(key).matrix_input(m);
    EXPECT_EQ(text.find("\nshell"), std::string::npos) << key;
    EXPECT_NE(text.find("polystyrene"), std::string::npos) << key;
    EXPECT_NE(text.find("ime step advised"), std::string::npos) << key << text;
    EXPECT_NE(text.find("0.32"), std::string::npos) << key << ": friction of the mixed pair";
  }
}

/// A pair as an engine has it, prescribed at one overlap.
struct Contact {
  double force = 0, sliding = 0, rolling = 0, torsion = 0;  ///< [N], [N], [N m], [N m]
};

constexpr double overlap = 6e-9;

Contact law_of(const PairLaw& law, double effective_radius) {
  const double F = Hertz{law.reduced_modulus, effective_radius}.force(overlap);
  return {F, law.sliding * F, law.rolling * effective_radius * F, law.torsion * effective_radius * F};
}

void expect_law(const Contact& found, const PairLaw& law, double effective_radius, bool twists = true) {
  const Contact wanted = law_of(law, effective_radius);
  constexpr double asked = 0.01;
  EXPECT_NEAR(found.force / wanted.force, 1, asked);
  EXPECT_NEAR(found.sliding / wanted.sliding, 1, asked);
  EXPECT_NEAR(found.rolling / wanted.rolling, 1, asked);
  if (twists) {
    EXPECT_NEAR(found.torsion / wanted.torsion, 1, asked);
  }
}

std::string file_of(const WrittenEngine& engine, const MaterialMatrix& matrix) {
  return engine.matrix_input(matrix);
}

/// Particles 1 and 2 of types 1 and 3, the second above the first, or particle 1 above a plane of type 2;
/// held where they are, while the second (or the only one) slides along x, spins about y and about z.
Contact in_script(const Engine& engine, const std::string& begin, const std::string& contacts, bool on_plane,
                  const std::string& plane) {
  const auto text = [](double value) {
    std::ostringstream out;
    out.precision(15);
    out << value;
    return out.str();
  };
  const std::string moved = on_plane ? "1" : "2";
  const std::string bodies = on_plane
                                 ? "create_atoms 1 single 0 0 " + text(radius - overlap) + " units box\n"
                                 : "create_atoms 1 single 0 0 3e-5 units box\ncreate_atoms 3 single 0 0 " +
                                       text(3e-5 + 2 * radius - overlap) + " units box\n";
  const auto measured = [&](const std::string& motion, const std::string& what) {
    return std::abs(number_after(
        run_script(engine, begin + contacts + "timestep 1e-9\n" + bodies +
                               "set group all diameter 17e-6 density 2230\n" + (on_plane ? plane : "") +
                               "compute f all property/atom fx fz tqx tqy tqz\nvariable r equal "
                               "c_f[" +
                               moved + "][" + what + "]\nthermo_style custom step v_r\ngroup moved id " +
                               moved + "\n" + motion + "run 2000\nprint \"response: ${r}\"\n"),
        "\nresponse: "));
  };
  constexpr double rolling_rate = 20, spin_rate = 100;  // [rad/s]
  const auto spin = [&](double about_y, double about_z) {
    if (engine.name() == "LAMMPS")
      return "set group moved omega 0 " + text(about_y) + " " + text(about_z) + "\n";
    return "set group moved omegay " + text(about_y) + " omegaz " + text(about_z) + "\n";
  };
  const std::string slide = "velocity moved set 1e-3 0.0 0.0 units box\n",
                    roll = "velocity moved set " + text(rolling_rate * radius) + " 0.0 0.0 units box\n";
  return {measured("", "2"), measured(slide, "1"), measured(roll + spin(rolling_rate, 0), "4"),
          measured(spin(0, spin_rate), "5")};
}

const std::string lammps_begin =
    "units si\natom_style sphere\natom_modify map array\nboundary f f f\nnewton off\ncomm_modify vel "
    "yes\nregion "
    "box block -8e-5 8e-5 -4e-5 4e-5 -1e-7 8e-5\ncreate_box 3 box\nneighbor 1e-6 bin\n";
const std::string liggghts_begin =
    "hard_particles yes\natom_style granular\natom_modify map array\nboundary f f f\nnewton off\ncommunicate "
    "single vel "
    "yes\nunits si\nregion reg block -8e-5 8e-5 -4e-5 4e-5 -1e-7 8e-5 units box\ncreate_box 3 reg\nneighbor "
    "1e-6 "
    "bin\nneigh_modify delay 0\n";

TEST(ManyParticles_other_code, pair_and_plane_give_the_law_in_lammps) {
  ASPERITY_ENGINE_OR_SKIP(Lammps());
  const MaterialMatrix m = two_materials();
  const std::string contacts = file_of(Lammps(), m);
  const auto scene = [&](bool on_plane) {
    return in_script(Lammps(), lammps_begin, contacts, on_plane,
                     "fix floor all wall/gran granular ${on_plane_1_2} zplane 0 NULL\n");
  };
  expect_law(scene(false), m.pair(0, 2).law, radius / 2);
  expect_law(scene(true), m.pair(0, 1).law, radius);
}

TEST(ManyParticles_other_code, pair_and_plane_give_the_law_in_liggghts) {
  ASPERITY_ENGINE_OR_SKIP(Liggghts());
  const MaterialMatrix m = two_materials();
  const std::string contacts = file_of(written_engine_of("liggghts"), m);
  const auto scene = [&](bool on_plane) {
    return in_script(Liggghts(), liggghts_begin, contacts, on_plane,
                     "fix floor all wall/gran ${on_plane} primitive type 2 zplane 0.0\n");
  };
  constexpr bool twists = false;  // its header says that it has no torsion
  expect_law(scene(false), m.pair(0, 2).law, radius / 2, twists);
  expect_law(scene(true), m.pair(0, 1).law, radius, twists);
}

TEST(ManyParticles_other_code, pair_and_plane_give_the_law_in_yade) {
  ASPERITY_ENGINE_OR_SKIP(Yade());
  const MaterialMatrix m = two_materials();
  const auto scene = [&](bool on_plane) {
    const std::string output =
        run_script(Yade(), "from yade import *\nimport os, sys\n" + file_of(Yade(), m) +
                               "R, d, on_plane = 8.5e-6, 6e-9, " + (on_plane ? "True" : "False") + R"(
glass, silicon, plastic = asperity_materials
lower = O.bodies.append(utils.wall(0, axis=2, material=silicon) if on_plane
                        else utils.sphere((0, 0, -R), R, material=glass, fixed=True))
upper = O.bodies.append(utils.sphere((0, 0, R - d), R, material=glass if on_plane else plastic))
state = O.bodies[upper].state
state.blockedDOFs = 'xyzXYZ'
O.dt = 1e-9
O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()]),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()], [asperity_functor],
                    [Law2_ScGeom_MindlinPhys_Mindlin(includeMoment=True)]),
    PyRunner(command='asperity_step()', iterPeriod=1, initRun=True), NewtonIntegrator(damping=0)]
O.run(1, True)
print('force: %.12g end' % O.forces.f(upper)[2])
state.vel = (1e-3, 0, 0)
O.run(2000, True)
print('sliding: %.12g end' % abs(O.forces.f(upper)[0]))
def turn(axis):
    O.interactions.clear()
    state.vel, state.pos = (0, 0, 0), (0, 0, R - d)
    state.angVel = [100 if i == axis else 0 for i in range(3)]
    O.run(2000, True)
    moment = O.interactions[lower, upper].phys
    return (moment.momentBend if axis == 1 else moment.momentTwist).norm()
print('rolling: %.12g end' % turn(1))
print('torsion: %.12g end' % turn(2))
sys.stdout.flush(); os._exit(0)
)");
    EXPECT_NE(output.find("torsion: "), std::string::npos) << output;
    return Contact{number_after(output, "force: "), number_after(output, "sliding: "),
                   number_after(output, "rolling: "), number_after(output, "torsion: ")};
  };
  expect_law(scene(false), m.pair(0, 2).law, radius / 2);
  expect_law(scene(true), m.pair(0, 1).law, radius);
}

TEST(ManyParticles_other_code, thousand_particles_of_two_materials_cool_alike_in_lammps_and_liggghts) {
  ASPERITY_ENGINE_OR_SKIP(Lammps());
  const MaterialMatrix m = two_materials();
  const ParticleBox box = particle_box(m, 1000);
  const BoxRun lammps = run_box(Lammps(), Lammps(), m, 1000, {"-in", "in.box"});
  expect_that_energy_never_rises(lammps, m, box);
  ASPERITY_ENGINE_OR_SKIP(Liggghts());
  const BoxRun liggghts = run_box(written_engine_of("liggghts"), Liggghts(), m, 1000, {"-in", "in.box"});
  expect_that_energy_never_rises(liggghts, m, box);
  // Two programs that share nothing but the files' numbers; LIGGGHTS has no torsion.
  EXPECT_NEAR(liggghts.energy.back() / lammps.energy.back(), 1, 0.1);
}

void cool_in_yade(int count) {
  const MaterialMatrix m = two_materials();
  const BoxRun yade = run_box(Yade(), Yade(), m, count, {"-n", "-x", "box.py"});
  expect_that_energy_never_rises(yade, m, particle_box(m, count));
  ASPERITY_ENGINE_OR_SKIP(Lammps());
  const BoxRun lammps = run_box(Lammps(), Lammps(), m, count, {"-in", "in.box"});
  EXPECT_NEAR(yade.energy.back() / lammps.energy.back(), 1, 0.1);
}

TEST(ManyParticles_other_code, box_of_two_materials_cools_in_yade_as_in_lammps) {
  ASPERITY_ENGINE_OR_SKIP(Yade());
  cool_in_yade(125);
}

TEST(ManyParticlesNightly_other_code, thousand_particles_of_two_materials_cool_in_yade_as_in_lammps) {
  ASPERITY_ENGINE_OR_SKIP(Yade());
  cool_in_yade(1000);
}

/// Speed after over before of a head-on impact of two particles, from a box of two.
TEST(ManyParticles_other_code, impact_has_the_restitution_asked_for) {
  ASPERITY_ENGINE_OR_SKIP(Lammps());
  const MaterialMatrix m = two_materials();
  const std::string scene =
      "create_atoms 1 single 0 0 2e-5 units box\ncreate_atoms 3 single 0 0 3.7001e-5 units box\nset group "
      "all "
      "diameter 17e-6 density 2230\ngroup upper id 2\nvelocity upper set 0.0 0.0 -0.05 units box\nfix move "
      "all "
      "nve/sphere\ntimestep 1e-9\nvariable a equal vz[1]\nvariable b equal vz[2]\nthermo_style custom step "
      "v_a v_b\n"
      "run 20000\nvariable gone equal (v_a-v_b)/-0.05\nprint \"gone: ${gone}\"\n";
  const auto gone = [&](const Engine& engine, const std::string& begin, const WrittenEngine& written) {
    return -number_after(run_script(engine, begin + file_of(written, m) + scene), "\ngone: ");
  };
  EXPECT_NEAR(-gone(Lammps(), lammps_begin, Lammps()), restitution, 0.02);
  ASPERITY_ENGINE_OR_SKIP(Liggghts());
  EXPECT_NEAR(-gone(Liggghts(), liggghts_begin, written_engine_of("liggghts")), restitution, 0.02);
}

}  // namespace
}  // namespace asperity

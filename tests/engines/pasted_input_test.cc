// What asperity writes for a user to paste, in scenes with motion and materials of their own: a spinning
// impact gains no energy, and a second pair of materials keeps what it had.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "engines/engine_input.h"
#include "tests/engines/engine_support.h"

namespace asperity {
namespace {

using test::canonical_contact;
using test::Liggghts;
using test::number_after;
using test::run_script;

constexpr double radius = 8.5e-6;

std::string pasted(const std::string& engine, const ContactParameters& parameters = canonical_contact()) {
  EngineInputOptions options;
  options.load = 1e-4;
  return engine_input(engine, parameters, options);
}

/// All numbers behind `label`, in order.
std::vector<double> numbers_after(const std::string& text, const std::string& label) {
  std::vector<double> numbers;
  for (auto at = text.find(label); at != std::string::npos; at = text.find(label, at + 1))
    numbers.push_back(std::strtod(text.c_str() + at + label.size(), nullptr));
  return numbers;
}

/// "lateral:" and "normal:" are twice the energy over mass in spin and lateral motion, and in normal motion
/// [m^2/s^2], at the start and every ten steps of an impact at 0.1 m/s with a spin of 10 rad/s about x and z.
void expect_that_spin_decays(const std::string& output) {
  const std::vector<double> lateral = numbers_after(output, "\nlateral: "),
                            normal = numbers_after(output, "\nnormal: ");
  ASSERT_GE(lateral.size(), 50u) << output;
  ASSERT_EQ(lateral.size(), normal.size());
  EXPECT_NEAR(lateral.front() / (0.4 * radius * radius * 200), 1, 1e-9) << output;
  EXPECT_NEAR(normal.front(), 0.01, 1e-9);
  EXPECT_LT(*std::min_element(normal.begin(), normal.end()), 1e-3) << "there was no impact";
  EXPECT_LE(*std::max_element(lateral.begin(), lateral.end()), lateral.front() * (1 + 1e-9)) << output;
  EXPECT_LE(normal.back(), normal.front() * (1 + 1e-4));  // explicit integration, without damping
  EXPECT_GT(normal.back(), 0.04 * normal.front());
}

const std::string lammps_scene =
    "units si\natom_style sphere\natom_modify map array\nboundary f f f\nnewton off\ncomm_modify vel yes\n"
    "region box block -8e-5 8e-5 -4e-5 4e-5 -1e-7 8e-5\ncreate_box 3 box\nneighbor 1e-6 bin\n";

TEST(PastedInput_other_code, sphere_that_touches_spinning_gains_no_energy_in_lammps) {
  ASPERITY_ENGINE_OR_SKIP(Lammps());
  expect_that_spin_decays(run_script(
      Lammps(),
      lammps_scene +
          "create_atoms 1 single 0 0 8.5001e-6\nset atom 1 diameter 17e-6 density 2230 omega 10 0 10\n"
          "pair_style granular\npair_coeff * * hertz 1 0 tangential linear_nohistory 0 0\n" +
          pasted("lammps") +
          "fix move all nve/sphere\ncompute w all property/atom omegax omegay omegaz\ntimestep "
          "1e-9\nvelocity all set 0 0 -0.1\n"
          "variable l equal (c_w[1][1]^2+c_w[1][2]^2+c_w[1][3]^2)*0.4*8.5e-6^2+vx[1]^2+vy[1]^2\nvariable n "
          "equal vz[1]^2\n"
          "thermo_style custom step v_l\nrun 0\nprint \"lateral: $(v_l:%.15g)\"\nprint \"normal: "
          "$(v_n:%.15g)\"\nvariable i loop 60\n"
          "label again\nrun 10\nprint \"lateral: $(v_l:%.15g)\"\nprint \"normal: $(v_n:%.15g)\"\nnext "
          "i\njump SELF again\n"));
}

const std::string liggghts_scene =
    "hard_particles yes\natom_style granular\natom_modify map array\nboundary f f f\nnewton off\ncommunicate "
    "single vel yes\nunits si\n"
    "region reg block -8e-5 8e-5 -4e-5 4e-5 -1e-7 8e-5 units box\ncreate_box 2 reg\nneighbor 1e-6 "
    "bin\nneigh_modify delay 0\n";

/// As it is pasted, but for the line that must stand before the box.
std::string pasted_in_liggghts() {
  const std::string input = pasted("liggghts");
  return input.substr(input.find("# type 1 is"));
}

TEST(PastedInput_other_code, sphere_that_touches_spinning_gains_no_energy_in_liggghts) {
  ASPERITY_ENGINE_OR_SKIP(Liggghts());
  expect_that_spin_decays(run_script(
      Liggghts(),
      liggghts_scene + pasted_in_liggghts() +
          "timestep 1e-9\ncreate_atoms 1 single 0 0 8.5001e-6 units box\nset group all diameter 17e-6 "
          "density 2230\nfix move all nve/sphere\n"
          "velocity all set 0 0 -0.1 units box\nset group all omegax 10\nset group all omegaz 10\ncompute w "
          "all property/atom omegax omegay omegaz\n"
          "variable l equal (c_w[1][1]^2+c_w[1][2]^2+c_w[1][3]^2)*0.4*8.5e-6^2+vx[1]^2+vy[1]^2\nvariable n "
          "equal vz[1]^2\n"
          "thermo_style custom step v_l\nrun 0\nprint \"lateral: ${l}\"\nprint \"normal: ${n}\"\nvariable i "
          "loop 60\n"
          "label again\nrun 10\nprint \"lateral: ${l}\"\nprint \"normal: ${n}\"\nnext i\njump SELF again\n"));
}

/// A scene of YADE with what is pasted, two materials labelled as it says and a third, glass.
std::string yade_scene(const std::string& input, const std::string& bodies, const std::string& functor = "") {
  return "from yade import *\nimport os, sys\n" + input +
         "R, large = 8.5e-6, 8.5e-1\n"
         "def material(label): return O.materials.append(FrictMat(young=71e9, poisson=0.17, "
         "frictionAngle=0.1, density=2230, label=label))\n"
         "particle, target, glass = material(PARTICLE), material(TARGET), material('glass')\n" +
         bodies +
         "O.dt = 1e-9\nO.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb(), "
         "Bo1_Wall_Aabb(), Bo1_Facet_Aabb()]),\n"
         "    InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom(), "
         "Ig2_Facet_Sphere_ScGeom()],\n"
         "                    [Ip2_FrictMat_FrictMat_MindlinPhys(" +
         functor +
         ")], [Law2_ScGeom_MindlinPhys_Mindlin(includeMoment=True)]),\n"
         "    PyRunner(command='asperity_step()', iterPeriod=1, initRun=True), "
         "NewtonIntegrator(damping=0)]\n";
}
const std::string yade_end = "sys.stdout.flush(); os._exit(0)\n";

TEST(PastedInput_other_code, sphere_that_touches_spinning_gains_no_energy_in_yade) {
  ASPERITY_ENGINE_OR_SKIP(Yade());
  // Twice: with the functor as it comes, and with the moments that an earlier version of the header asked
  // for.
  for (const std::string functor : {"", "krot=1, ktwist=1, eta=1"}) {
    SCOPED_TRACE(functor);
    expect_that_spin_decays(run_script(
        Yade(),
        yade_scene(pasted("yade"),
                   "s = O.bodies.append(utils.sphere((0, 0, -large), large, material=target, fixed=True))\n"
                   "b = O.bodies.append(utils.sphere((0, 0, R + 1e-10), R, material=particle))\n",
                   functor) +
            "state = O.bodies[b].state\nstate.vel, state.angVel = (0, 0, -0.1), (10, 0, 10)\n"
            "def tell():\n    print('lateral: %.15g' % (state.angVel.norm()**2*0.4*R**2 + state.vel[0]**2 + "
            "state.vel[1]**2))\n"
            "    print('normal: %.15g' % state.vel[2]**2)\n"
            "print()\ntell()\nfor i in range(60):\n    O.run(10, True)\n    tell()\n" +
            yade_end));
  }
}

/// 4/3 E* R_e^(1/2) delta^(3/2) of two equal spheres of one material.
double hertz_of_equal_spheres(double youngs_modulus, double poissons_ratio, double overlap) {
  const double reduced = youngs_modulus / 2 / (1 - poissons_ratio * poissons_ratio);
  return 4.0 / 3 * reduced * std::sqrt(radius / 2) * std::pow(overlap, 1.5);
}

TEST(PastedInput_other_code,
     second_pair_of_materials_stays_untouched_in_yade_and_walls_and_facets_count_as_planes) {
  ASPERITY_ENGINE_OR_SKIP(Yade());
  const ContactParameters p = canonical_contact();
  const std::string output = run_script(
      Yade(),
      yade_scene(pasted("yade"),
                 "d = 6e-9\ndef sphere(x, z, material): return O.bodies.append(utils.sphere((x, 0, z), R, "
                 "material=material))\n"
                 "s = O.bodies.append(utils.sphere((0, 0, -large), large, material=target, fixed=True))\n"
                 "named, other = sphere(0, R - d, particle), sphere(3*R, R - d - (3*R)**2/2/large, glass)\n"
                 "lower, upper = sphere(-3*R, 5*R, glass), sphere(-3*R, 7*R - d, glass)\n"
                 "like, alike = sphere(-6*R, 5*R, particle), sphere(-6*R, 7*R - d, particle)\n"
                 "wall = O.bodies.append(utils.wall(10*R, axis=2, material=target))\non_wall = sphere(0, "
                 "11*R - d, particle)\n"
                 "f = O.bodies.append(utils.facet([(-9*R, -9*R, 20*R), (9*R, -9*R, 20*R), (0, 9*R, 20*R)], "
                 "material=target, fixed=True))\n"
                 "on_facet = sphere(0, 21*R - d, particle)\n"
                 "for b in O.bodies: b.state.blockedDOFs = 'xyzXYZ'\n") +
          "O.run(1, True)\nfor name in ('named', 'on_wall', 'on_facet', 'upper', 'alike', 'other'):\n"
          "    print(name + ': %.12g end' % abs(O.forces.f(globals()[name])[2]))\n"
          "O.bodies[upper].state.angVel = (0, 1e3, 1e3)\nO.run(10, True)\n"
          "print('moment: %.12g end' % O.interactions[lower, upper].phys.momentBend.norm())\n" +
          yade_end);
  const double of_record = p.hertz().force(6e-9), of_glass = hertz_of_equal_spheres(71e9, 0.17, 6e-9);
  for (const char* name : {"named: ", "on_wall: ", "on_facet: "})
    EXPECT_NEAR(number_after(output, name) / of_record, 1, 1e-4) << name << output;
  for (const char* name : {"upper: ", "alike: "})
    EXPECT_NEAR(number_after(output, name) / of_glass, 1, 1e-4) << name << output;
  // On the target, glass has YADE's own law: two equal moduli, R_e = R.
  EXPECT_NEAR(number_after(output, "other: ") / (std::sqrt(2) * of_glass), 1, 1e-4) << output;
  EXPECT_EQ(number_after(output, "moment: "), 0) << output;
}

TEST(PastedInput_other_code, label_that_no_material_has_is_an_error_in_yade) {
  ASPERITY_ENGINE_OR_SKIP(Yade());
  const std::string output = run_script(
      Yade(), yade_scene(pasted("yade") + "TARGET = 'silikon'\n", "") + "O.run(1, True)\n" + yade_end);
  EXPECT_NE(output.find("No material labeled `silicon'"), std::string::npos) << output;
}

TEST(PastedInput_other_code, second_material_stays_untouched_in_lammps) {
  ASPERITY_ENGINE_OR_SKIP(Lammps());
  // The record's sphere, and one of type 2, at the same depth in the plane; a pair of type 2 with a law of
  // its own.
  const std::string own = "hertz 5e10 0 tangential mindlin 6e10 0 0.4\n";
  const std::string plane =
      run_script(Lammps(), lammps_scene +
                               "create_atoms 1 single 0 0 8.494e-6\ncreate_atoms 2 single 3e-5 0 "
                               "8.494e-6\ncreate_atoms 2 single -3e-5 0 4e-5\n"
                               "create_atoms 2 single -3e-5 0 5.6994e-5\nset group all diameter 17e-6 "
                               "density 2230\npair_style granular\npair_coeff * * " +
                               own + pasted("lammps") +
                               "variable a equal fz[1]\nvariable b equal fz[2]\nvariable c equal "
                               "fz[4]\nthermo_style custom step v_a v_b v_c\n"
                               "run 0\nprint \"named: $(v_a:%.12g)\"\nprint \"other: $(v_b:%.12g)\"\nprint "
                               "\"pair: $(v_c:%.12g)\"\n");
  EXPECT_NEAR(number_after(plane, "\nnamed: ") / canonical_contact().hertz().force(6e-9), 1, 1e-6) << plane;
  EXPECT_EQ(number_after(plane, "\nother: "), 0) << plane;
  const double of_own = 5e10 * std::sqrt(radius / 2) * std::pow(6e-9, 1.5);
  EXPECT_NEAR(number_after(plane, "\npair: ") / of_own, 1, 1e-6) << plane;

  // The record of two spheres, pasted before the laws of the other pairs.
  ContactParameters p = canonical_contact();
  p.target.radius = radius;
  const std::string spheres = run_script(
      Lammps(), lammps_scene +
                    "create_atoms 1 single 0 0 2e-5\ncreate_atoms 2 single 0 0 3.6994e-5\ncreate_atoms 1 "
                    "single -3e-5 0 2e-5\n"
                    "create_atoms 1 single -3e-5 0 3.6994e-5\nset group all diameter 17e-6 density 2230\n" +
                    pasted("lammps", p) + "pair_coeff 1 1 " + own + "pair_coeff 2 2 " + own +
                    "pair_coeff * 3 " + own +
                    "variable a equal fz[2]\nvariable b equal fz[4]\nthermo_style custom step v_a v_b\n"
                    "run 0\nprint \"named: $(v_a:%.12g)\"\nprint \"pair: $(v_b:%.12g)\"\n");
  EXPECT_NEAR(number_after(spheres, "\nnamed: ") / p.hertz().force(6e-9), 1, 1e-6) << spheres;
  EXPECT_NEAR(number_after(spheres, "\npair: ") / of_own, 1, 1e-6) << spheres;
}

TEST(PastedInput_other_code, particles_among_themselves_keep_their_own_friction_in_liggghts) {
  ASPERITY_ENGINE_OR_SKIP(Liggghts());
  // One particle dragged over another, far beyond sliding: without friction of its own by default, with what
  // the user set before.
  const auto dragged = [](const std::string& before) {
    return run_script(
        Liggghts(),
        liggghts_scene + before + pasted_in_liggghts() +
            "timestep 1e-9\ncreate_atoms 1 single 0 0 3e-5 units box\ncreate_atoms 1 single 0 0 4.6994e-5 "
            "units box\n"
            "set group all diameter 17e-6 density 2230\ngroup upper id 2\nfix held upper setforce 0. 0. "
            "0.\ngroup lower id 1\nfix hold lower setforce 0. 0. 0.\n"
            "fix move all nve\nvelocity upper set 1e-2 0. 0. units box\nvariable x equal f_held[1]\n"
            "variable z equal f_held[3]\nthermo_style custom step v_x v_z\nrun 2000\nprint \"lateral: "
            "${x}\"\nprint \"normal: ${z}\"\n");
  };
  const double force = hertz_of_equal_spheres(71e9, 0.17, 6e-9);
  const std::string none = dragged(""), own = dragged("variable friction_11 index 0.4\n");
  EXPECT_NEAR(number_after(none, "\nnormal: ") / force, 1, 1e-2) << none;
  EXPECT_NEAR(number_after(none, "\nlateral: ") / force, 0, 2e-3) << none;
  EXPECT_NEAR(-number_after(own, "\nlateral: ") / number_after(own, "\nnormal: "), 0.4, 4e-3) << own;
}

}  // namespace
}  // namespace asperity

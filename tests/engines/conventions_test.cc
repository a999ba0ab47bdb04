// Conventions of engines that converters rely on: lever arms, what a stiffness is multiplied with, what is
// refused.
#include <gtest/gtest.h>

#include "dem_compare/laws/hertzian_torsion.h"
#include "engines/engine_input.h"
#include "tests/engines/engine_support.h"

namespace asperity {
namespace {

using test::Liggghts;
using test::number_after;
using test::run_script;

constexpr double radius = 8.5e-6, overlap = 100e-9;  // deep enough to tell R from R - delta/2

TEST(EngineConventions_other_code,
     torque_of_lammps_has_the_arm_r_at_walls_and_r_less_half_the_overlap_between_spheres) {
  const Lammps lammps;
  ASPERITY_ENGINE_OR_SKIP(lammps);
  const std::string law = "hertz 7.04912e10 0 tangential mindlin 9.43912e10 0 10\n",
                    none = "pair_coeff * * hertz 1 0 tangential linear_nohistory 0 0\n";
  const std::string wall = run_script(
      lammps,
      "units si\natom_style sphere\natom_modify map array\nboundary f f f\nnewton off\ncomm_modify vel yes\n"
      "region box block -4e-5 4e-5 -4e-5 4e-5 -4e-5 4e-5\ncreate_box 1 box\nneighbor 1e-6 bin\npair_style "
      "granular\n" +
          none +
          "create_atoms 1 single 0 0 8.4e-6\nset group all diameter 1.7e-5 density 2230\n"
          "fix w all wall/gran granular hertz 7.04912e10 0 tangential mindlin 9.43912e10 0 10 zplane 0 NULL\n"
          "compute torque all property/atom tqy\nfix hold all setforce 0 0 0\nfix move all nve\ntimestep "
          "1e-9\nvelocity all set 1e-3 0 0\n"
          "variable t equal c_torque[1]\nthermo_style custom step f_hold[1] v_t\nrun 100\nprint \"arm: "
          "$(c_torque[1]/f_hold[1]:%.12g)\"\n");
  EXPECT_NEAR(std::abs(number_after(wall, "\narm: ")) / radius, 1, 1e-6);

  // Between spheres the line of centres turns as the upper one moves on: the lateral force is the part across
  // it.
  const std::string pair = run_script(
      lammps,
      "units si\natom_style sphere\natom_modify map array\nboundary f f f\nnewton off\ncomm_modify vel yes\n"
      "region box block -4e-5 4e-5 -4e-5 4e-5 -4e-5 4e-5\ncreate_box 1 box\nneighbor 1e-6 bin\npair_style "
      "granular\npair_coeff * * " +
          law +
          "create_atoms 1 single 0 0 0\ncreate_atoms 1 single 0 0 1.69e-5\nset group all diameter 1.7e-5 "
          "density 2230\ngroup upper id 2\n"
          "compute torque all property/atom tqy\nfix hold upper setforce 0 0 0\nfix rest all setforce 0 0 "
          "0\nfix move upper nve\ntimestep 1e-9\n"
          "velocity upper set 1e-3 0 0\nvariable t equal c_torque[2]\nthermo_style custom step f_hold[1] "
          "f_hold[3] v_t\nrun 100\n"
          "print \"x: $(x[2]:%.15g)\"\nprint \"z: $(z[2]:%.15g)\"\nprint \"fx: $(f_hold[1]:%.12g)\"\nprint "
          "\"fz: $(f_hold[3]:%.12g)\"\n"
          "print \"torque: $(c_torque[2]:%.12g)\"\n");
  const double x = number_after(pair, "\nx: "), z = number_after(pair, "\nz: "), distance = std::hypot(x, z);
  const double lateral = (number_after(pair, "\nfx: ") * z - number_after(pair, "\nfz: ") * x) / distance;
  EXPECT_NEAR(std::abs(number_after(pair, "\ntorque: ") / lateral) / (radius - overlap / 2), 1, 1e-5) << pair;
}

TEST(EngineConventions_other_code, torque_of_yade_has_the_arm_r_less_half_the_overlap) {
  const Yade yade;
  ASPERITY_ENGINE_OR_SKIP(yade);
  const std::string output = run_script(yade, R"(
from yade import *
import os, sys
R, overlap = 8.5e-6, 100e-9
m = O.materials.append(FrictMat(young=71e9, poisson=0.17, frictionAngle=1.5, density=2230))
s = O.bodies.append(utils.sphere((0, 0, -1e5*R), 1e5*R, material=m, fixed=True))
b = O.bodies.append(utils.sphere((0, 0, R - overlap), R, material=m))
O.bodies[b].state.blockedDOFs = 'xyzXYZ'
O.dt = 1e-9
O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb()]),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()],
    [Ip2_FrictMat_FrictMat_MindlinPhys()], [Law2_ScGeom_MindlinPhys_Mindlin()]), NewtonIntegrator(damping=0)]
O.run(2, True)
O.bodies[b].state.vel = (1e-3, 0, 0)
O.run(100, True)
i = O.interactions[s, b]
print('arm: %.12g end' % (O.forces.t(b).norm()/i.phys.shearForce.norm()))
sys.stdout.flush(); os._exit(0)
)");
  EXPECT_NEAR(number_after(output, "arm: ") / (radius - overlap / 2), 1, 1e-5) << output;
}

TEST(EngineConventions_other_code,
     cohesive_friction_of_yade_takes_rolling_from_shear_stiffness_times_both_radii_and_the_smaller_radius) {
  const Yade yade;
  ASPERITY_ENGINE_OR_SKIP(yade);
  const std::string output = run_script(yade, R"(
from yade import *
import os, sys
R1, R2 = 8.5e-6, 20e-6
m = CohFrictMat(young=1e9, poisson=0.3, density=2230, frictionAngle=0.4, alphaKr=0.7, alphaKtw=0.4,
    etaRoll=0.1, etaTwist=0.2, momentRotationLaw=True)
k = O.materials.append(m)
a = O.bodies.append(utils.sphere((0, 0, 0), R1, material=k))
b = O.bodies.append(utils.sphere((0, 0, R1 + R2 - 10e-9), R2, material=k))
for n in (a, b): O.bodies[n].state.blockedDOFs = 'xyzXYZ'
O.dt = 1e-10
O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb()]),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom6D()],
    [Ip2_CohFrictMat_CohFrictMat_CohFrictPhys()],
        [Law2_ScGeom6D_CohFrictPhys_CohesionMoment(always_use_moment_law=True)]), NewtonIntegrator(damping=0)]
O.run(2, True)
p = O.interactions[a, b].phys
F = p.normalForce.norm()
O.bodies[b].state.angVel = (0, 1e3, 0)
O.run(20000, True)
print('rolling: %.10g end' % (p.kr/(p.ks*R1*R2)), 'twisting: %.10g end' % (p.ktw/(p.ks*R1*R2)))
print('limit: %.10g end' % (p.moment_bending.norm()/(0.1*min(R1, R2)*p.normalForce.norm())),
    'rolling adhesion: %d end' % hasattr(m, 'rollingAdhesion'))
sys.stdout.flush(); os._exit(0)
)");
  EXPECT_NEAR(number_after(output, "rolling: "), 0.7, 1e-6) << output;
  EXPECT_NEAR(number_after(output, "twisting: "), 0.4, 1e-6);
  EXPECT_NEAR(number_after(output, "limit: "), 1, 1e-3);
  if (number_after(output, "rolling adhesion: ") != 0)
    GTEST_SKIP() << "this YADE has an offset of rolling of its own";
}

/// A sphere dragged over a plane under 100 uN.
std::string liggghts_slide(const std::string& first, const std::string& properties) {
  return first +
         "atom_style granular\natom_modify map array\nboundary f f f\nnewton off\ncommunicate single vel "
         "yes\nunits si\n"
         "region reg block -2e-5 2e-5 -2e-5 2e-5 -1e-7 4e-5 units box\ncreate_box 2 reg\nneighbor 1e-6 "
         "bin\nneigh_modify delay 0\n" +
         properties +
         "timestep 2e-9\ncreate_atoms 1 single 0 0 8.4938e-6 units box\nset group all diameter 17e-6 density "
         "2230\n"
         "fix load all addforce 0 0 -1e-4\nfix hold all setforce 0.0 0.0 NULL\nfix integr all nve\nvelocity "
         "all set 0 0 0\nrun 50000\n"
         "thermo_style custom step f_hold[1]\nvelocity all set 1e-2 0 0\nrun 10\nprint \"x0: "
         "$(x[1])\"\nprint \"f0: $(f_hold[1])\"\n"
         "run 20\nprint \"x1: $(x[1])\"\nprint \"f1: $(f_hold[1])\"\nrun 50000\n"
         "print \"plateau: $(-f_hold[1])\"\n";
}

TEST(EngineConventions_other_code,
     liggghts_slides_with_the_file_written_for_it_and_refuses_it_without_its_first_line) {
  const Liggghts liggghts;
  ASPERITY_ENGINE_OR_SKIP(liggghts);
  ContactParameters p = test::canonical_contact();
  p.torsion_friction.reset();
  const std::string hard = "hard_particles yes\n", input = engine_input("liggghts", p, {});
  std::string properties = input;  // as it is pasted, but for the line that must stand before the box
  properties.erase(
      properties.find("hard_particles"),
      properties.find('\n', properties.find("hard_particles")) - properties.find("hard_particles"));
  const std::string output = run_script(liggghts, liggghts_slide(hard, properties));
  const auto change = [&](const std::string& what) {
    return number_after(output, "\n" + what + "1: ") - number_after(output, "\n" + what + "0: ");
  };
  EXPECT_NEAR(-change("f") / change("x"), 21645.0, 0.005 * 21645) << output;
  EXPECT_NEAR(number_after(output, "\nplateau: "), 23e-6, 23e-9);
  EXPECT_NE(run_script(liggghts, liggghts_slide("", properties)).find("hard_particles"), std::string::npos);
  std::string manual = properties;
  manual.replace(manual.find("global rollingStiffness"), std::string("global rollingStiffness").size(),
                 "global coeffRollingStiffness");
  EXPECT_NE(run_script(liggghts, liggghts_slide(hard, manual)).find("ERROR"), std::string::npos);
}

TEST(EngineConventions_analytic, twisting_marshall_is_0_415_of_no_slip_and_13_percent_above_full_slip) {
  const ContactParameters p = test::canonical_contact();
  const double a = p.contact_radius(1e-4), k = p.lateral_stiffness_at(1e-4);
  const double shear = 1 / (2 * 1.17 / 71e9 + 2 * 1.25 / 179e9),
               no_slip = no_slip_torsion_stiffness(shear, a);
  EXPECT_NEAR(no_slip, 1.371e-9, 5e-13);
  EXPECT_NEAR(0.5 * k * a * a / no_slip, 0.415, 5e-4);
  const double full_slip = full_slip_torsion_moment(0.23, 1e-4, a);
  EXPECT_NEAR(full_slip, 3.107e-12, 5e-16);
  EXPECT_NEAR(2.0 / 3 * 0.23 * a * 1e-4 / full_slip, 1.13, 5e-3);
}

TEST(EngineConventions_analytic,
     one_rolling_coefficient_stands_for_an_offset_5_7_times_the_load_at_one_end_and_a_fifth_at_the_other) {
  const ContactParameters p = read_contact_parameters(test::paper_run("parameters_silicon.json"));
  EXPECT_NEAR(p.rolling_offset->value / 1e-4, 5.7, 0.05);
  EXPECT_NEAR(p.rolling_offset->value / 3e-3, 0.19, 0.005);
}

}  // namespace
}  // namespace asperity

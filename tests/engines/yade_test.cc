// YADE run as users run it, against closed forms and against the figures measured once by hand.
#include <gtest/gtest.h>

#include "tests/engines/engine_support.h"

namespace asperity {
namespace {

using test::canonical_experiment;
using test::expect_closed_form;
using test::number_after;
using test::rail_experiment;
using test::run;

constexpr double asked = 0.01;  // of every engine against its law

test::Verified yade_against(const char* figure, const char* what) {
  return {"Engines", std::string("YADE, ") + what, figure};
}

double value(const EngineRun& r, const std::string& name) { return named(r.measurements, name).measured; }

TEST(Yade_other_code, sliding_loop_has_mindlins_slope_and_coulombs_plateau) {
  const Yade yade;
  ASPERITY_ENGINE_OR_SKIP(yade);
  const EngineRun r = run(yade, canonical_experiment(Motion::sliding));
  expect_closed_form("sliding loop", r, asked);
  const double slope = value(r, "slope after reversal") / 21645.1, plateau = value(r, "plateau") / 23e-6;
  EXPECT_TRUE(
      yade_against("8 G* a, 21645.1 N/m", "sliding loop: slope after reversal").below(slope - 1, 1e-5));
  EXPECT_TRUE(yade_against("mu P, 23.000 uN", "sliding loop: plateau").below(plateau - 1, 1e-5));
  EXPECT_EQ(r.version.rfind("20", 0), 0u) << r.version;
}

TEST(Yade_other_code, twisting_follows_its_spring_up_to_the_limit_laid_on_it) {
  const Yade yade;
  ASPERITY_ENGINE_OR_SKIP(yade);
  expect_closed_form("twisting", run(yade, canonical_experiment(Motion::torsion)), asked);
}

TEST(Yade_other_code, rolling_sphere_needs_half_the_sum_of_both_coefficients) {
  const Yade yade;
  ASPERITY_ENGINE_OR_SKIP(yade);
  EngineExperiment e = canonical_experiment(Motion::rolling);
  e.amplitude = 20e-9;
  const EngineRun r = run(yade, e);
  expect_closed_form("rolling", r, asked);
  EXPECT_TRUE(yade_against("mean coefficient times P, 0.5304 uN", "rolling: plateau")
                  .below(value(r, "plateau") / 0.5304e-6 - 1, 1e-3));
}

TEST(Yade_other_code, rail_coefficient_is_that_of_the_torque_balance) {
  const Yade yade;
  ASPERITY_ENGINE_OR_SKIP(yade);
  expect_closed_form("rail at 45 degrees", run(yade, rail_experiment(45)), asked);
}

TEST(YadeNightly_other_code, long_loops_and_all_rails_follow_the_law) {
  const Yade yade;
  ASPERITY_ENGINE_OR_SKIP(yade);
  expect_closed_form("rolling, long loop", run(yade, canonical_experiment(Motion::rolling)), asked);
  for (const int angle : {25, 60})
    expect_closed_form("rail at " + std::to_string(angle) + " degrees", run(yade, rail_experiment(angle)),
                       asked);
}

/// What a YADE user gets from material constants: stiffness at 100 uN on a plane made in three ways, and a
/// slope by a step of drag.
const char* const shapes = R"(
from yade import *
import math, os, sys
R, f, mu = 8.5e-6, 1e-4, 0.23
reduced, shear = 52.8684e9, 11.7989e9
approach = (f/(4/3*reduced*R**0.5))**(2/3)
def run(shape, law):
    O.reset()
    sphere = O.materials.append(FrictMat(young=71e9, poisson=0.17, frictionAngle=math.atan(mu), density=2230))
    plane = O.materials.append(FrictMat(young=179e9, poisson=0.25, frictionAngle=math.atan(mu), density=2330))
    if shape == 'wall':
        O.bodies.append(utils.wall(0., axis=2, material=plane))
        bounds, geometry = [Bo1_Wall_Aabb()], [Ig2_Wall_Sphere_ScGeom()]
    elif shape == 'facet':
        O.bodies.append(utils.facet([(-1e-4, -1e-4, 0), (1e-4, -1e-4, 0), (0, 1e-4, 0)], material=plane,
            fixed=True))
        bounds, geometry = [Bo1_Facet_Aabb()], [Ig2_Facet_Sphere_ScGeom()]
    else:
        O.bodies.append(utils.sphere((0, 0, -1000*R), 1000*R, material=plane, fixed=True))
        bounds, geometry = [], []
    b = O.bodies.append(utils.sphere((0, 0, R - approach), R, material=sphere))
    O.bodies[b].state.blockedDOFs = 'xyXYZ'
    O.dt = 2e-9
    O.engines = [ForceResetter(), InsertionSortCollider(bounds + [Bo1_Sphere_Aabb()]),
        InteractionLoop(geometry + [Ig2_Sphere_Sphere_ScGeom()],
            [Ip2_FrictMat_FrictMat_MindlinPhys(betan=0.5)], [law]),
        NewtonIntegrator(damping=0)]
    O.forces.setPermF(b, (0, 0, -f))
    O.run(20000, True)
    i = [k for k in O.interactions][0]
    O.bodies[b].state.vel = (1e-2, 0, 0)
    O.run(10, True); first = i.phys.shearForce.norm(); x = O.bodies[b].state.pos[0]
    O.run(10, True); slope = (i.phys.shearForce.norm() - first)/(O.bodies[b].state.pos[0] - x)
    O.run(5000, True)
    print(shape, type(law).__name__,
        'kno: %.6g slope: %.6g plateau: %.6g end' % (i.phys.kno/(4/3*reduced*R**0.5), slope,
        i.phys.shearForce.norm()))
for shape in ('wall', 'facet', 'sphere'): run(shape, Law2_ScGeom_MindlinPhys_Mindlin())
run('sphere', Law2_ScGeom_MindlinPhys_MindlinDeresiewitz())
sys.stdout.flush(); os._exit(0)
)";

TEST(Yade_other_code, takes_walls_and_facets_for_spheres_so_that_a_plane_is_made_of_a_large_sphere) {
  const Yade yade;
  ASPERITY_ENGINE_OR_SKIP(yade);
  const std::string output = test::run_script(yade, shapes);
  const auto of = [&](const std::string& shape, const std::string& label) {
    const auto at = output.find(shape + " Law2_ScGeom_MindlinPhys_Mindlin kno");
    return at == std::string::npos ? std::nan("") : number_after(output.substr(at), label);
  };
  EXPECT_NEAR(of("wall", "kno: "), std::sqrt(1.0 / 2), 1e-4);
  EXPECT_NEAR(of("facet", "kno: "), std::sqrt(2.0 / 3), 1e-4);
  EXPECT_NEAR(of("sphere", "kno: "), std::sqrt(1000.0 / 1001), 1e-4);
  EXPECT_NEAR(of("wall", "slope: "), 17187.5, 17);
  EXPECT_NEAR(of("facet", "slope: "), 18908.7, 19);
  EXPECT_NEAR(of("sphere", "slope: "), 21637.8, 22);
  EXPECT_NEAR(of("sphere", "plateau: "), 23e-6, 23e-9);
  // The class named after Mindlin and Deresiewicz gives no shear force at all.
  const auto partial_slip = output.find("MindlinDeresiewitz kno");
  ASSERT_NE(partial_slip, std::string::npos) << output;
  EXPECT_EQ(number_after(output.substr(partial_slip), "plateau: "), 0);
}

}  // namespace
}  // namespace asperity

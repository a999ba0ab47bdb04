// Luding's law as asperity writes it, driven in the engines down and back: force against approach is that of
// the law.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "core/error.h"
#include "dem_compare/laws/luding.h"
#include "engines/engine_input.h"
#include "tests/engines/engine_support.h"
#include "tests/engines/luding_support.h"

namespace asperity {
namespace {

using test::canonical_contact;
using test::expect_the_law;
using test::Liggghts;
using test::run_script;

constexpr double radius = 8.5e-6, nm = 1e-9, deepest = 40 * nm;
const Luding law{20e3, 50e3, 8e3, deepest, radius};

ContactParameters yielded_contact() {
  ContactParameters p = canonical_contact();
  p.rolling_friction.reset(), p.torsion_friction.reset();
  p.luding_k1 = EffectiveQuantity{law.loading_stiffness};
  p.luding_kp = EffectiveQuantity{law.unloading_stiffness};
  p.luding_kc = EffectiveQuantity{law.adhesion_stiffness};
  p.luding_delta_p = EffectiveQuantity{law.full_approach};
  p.unloading_modulus = EffectiveQuantity{50e9};
  p.yield_pressure = EffectiveQuantity{6e9};
  return p;
}

std::string written(const std::string& engine, const std::string& normal_law,
                    const ContactParameters& parameters = yielded_contact()) {
  EngineInputOptions options;
  options.load = 1e-4;
  options.normal_law = normal_law;
  return engine_input(engine, parameters, options);
}

TEST(ElastoplasticInput_other_code, yade_follows_ludings_law) {
  ASPERITY_ENGINE_OR_SKIP(Yade());
  expect_the_law(run_script(Yade(), "from yade import *\nimport os, sys\n" + written("yade", "luding") + R"(
R, large = 8.5e-6, 8.5e-1
O.bodies.append(utils.sphere((0, 0, -large), large, material=TARGET, fixed=True))
b = O.bodies.append(utils.sphere((0, 0, R), R, material=PARTICLE))
state = O.bodies[b].state
state.blockedDOFs = 'xyzXYZ'
O.dt = 1e-9
O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb()]),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_LudingMat_LudingMat_LudingPhys()],
                    [Law2_ScGeom_LudingPhys_Basic()]), NewtonIntegrator(damping=0)]
print()
for speed, count in ((-1e-3, 40), (1e-3, 35)):
    state.vel = (0, 0, speed)
    for i in range(count):
        O.run(1000, True)
        force = O.forces.f(b)[2]  # at the step's beginning
        print('at %.9g %.9g' % (R - (state.pos[2] - speed*O.dt), force))
sys.stdout.flush(); os._exit(0)
)"),
                 law, deepest, "YADE, Luding's law as written");
}

TEST(ElastoplasticInput_other_code, liggghts_follows_ludings_law) {
  ASPERITY_ENGINE_OR_SKIP(Liggghts());
  const std::string input = written("liggghts", "luding");
  std::string script =
      "hard_particles yes\natom_style granular\natom_modify map array\nboundary f f f\nnewton "
      "off\ncommunicate "
      "single vel yes\nunits si\nregion reg block -8e-5 8e-5 -4e-5 4e-5 -1e-6 8e-5 units box\ncreate_box 2 "
      "reg\nneighbor 1e-6 bin\nneigh_modify delay 0\n" +
      input.substr(input.find("# type 1 is")) +
      "timestep 1e-9\ncreate_atoms 1 single 0 0 8.5e-6 units box\nset group all diameter 17e-6 density 2230\n"
      "compute f all reduce sum fz\ncompute z all reduce sum z\nvariable f equal c_f\nvariable d equal "
      "8.5e-6-c_z\nthermo_style custom step c_f c_z\nthermo 1000\n";
  const auto drive = [&](const char* fix, const char* speed, int count) {
    script += std::string("fix ") + fix + " all move linear 0 0 " + speed + " units box\n";
    for (int i = 0; i < count; ++i) script += "run 1000\nprint \"at ${d} ${f}\"\n";
    script += std::string("unfix ") + fix + "\n";
  };
  drive("down", "-1e-3", 40);
  drive("up", "1e-3", 35);
  expect_the_law(run_script(Liggghts(), script), law, deepest, "LIGGGHTS, Luding's law as written");
}

TEST(ElastoplasticInput_behaviour, each_engine_says_which_law_it_has_and_what_it_cannot) {
  EXPECT_NE(written("mercurydpm", "luding").find("setUnloadingStiffnessMax(50000)"), std::string::npos);
  EXPECT_NE(written("mercurydpm", "luding").find("was not run"), std::string::npos);
  const std::string mdr = written("lammps", "mdr");
  EXPECT_NE(mdr.find("mdr 45500000000 0.3 "), std::string::npos) << mdr;
  EXPECT_NE(mdr.find("was not run"), std::string::npos);
  try {
    written("lammps", "luding");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("--normal-law is hertz or mdr"), std::string::npos)
        << error.what();
  }
  EXPECT_THROW(written("musen", "luding"), InputError);
  try {
    written("yade", "luding", canonical_contact());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("'luding_k1'"), std::string::npos) << error.what();
  }
  ContactParameters softer = yielded_contact();
  softer.luding_kp->value = 10e3;
  EXPECT_THROW(written("yade", "luding", softer), InputError);
}

}  // namespace
}  // namespace asperity

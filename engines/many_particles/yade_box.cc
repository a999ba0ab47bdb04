#include "engines/many_particles/particle_box.h"
#include "engines/text_number.h"

namespace asperity {

std::vector<WrittenFile> yade_box(const MaterialMatrix& matrix, const ParticleBox& box,
                                  const std::string& contacts) {
  std::string table = "type,radius,x,y,z,vx,vy,vz\n";
  for (const BoxParticle& p : box.particles) {
    table += std::to_string(p.material) + "," + text_number(p.radius);
    for (const double value : p.position) table += "," + text_number(value);
    for (const double value : p.velocity) table += "," + text_number(value);
    table += "\n";
  }
  const std::string script =
      "# asperity: a closed box of particles that cools by its impacts; energy.csv has its energy. Run with: "
      "yade -n -x box.py\n"
      "from yade import *\nimport os, sys, traceback\n"
      "exec(open('" +
      contacts + "').read())\nedge, wall = " + text_number(box.edge) + ", asperity_materials[" +
      std::to_string(matrix.wall()) + "]\n" + R"(
for axis in range(3):
    for side, sense in ((0, 1), (edge, -1)):
        O.bodies.append(utils.wall(side, axis=axis, sense=sense, material=wall))
spheres = []
with open('particles.csv') as rows:
    next(rows)
    for row in rows:
        type, *numbers = row.split(',')
        radius, x, y, z, *velocity = map(float, numbers)
        material = asperity_materials[int(type)]
        spheres.append(O.bodies.append(utils.sphere((x, y, z), radius, material=material)))
        O.bodies[spheres[-1]].state.vel = velocity

def energy():
    states = [O.bodies[s].state for s in spheres]
    translation = sum(0.5*s.mass*s.vel.squaredNorm() for s in states)
    rotation = sum(0.5*s.inertia[0]*s.angVel.squaredNorm() for s in states)
    print('%.12g,%.12g,%.12g' % (O.time, translation, rotation), file=out)

O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()]),
             InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()],
                             [asperity_functor], [asperity_law]),
             PyRunner(command='asperity_step()', iterPeriod=1, initRun=True), NewtonIntegrator(damping=0),
             PyRunner(command='energy()', iterPeriod=)" +
      std::to_string(box.every) + R"(, initRun=True)]
try:
    with open('energy.csv', 'w') as out:
        print('time,translation,rotation', file=out)
        O.run()" +
      std::to_string(box.steps) + R"(, True)
except Exception:
    traceback.print_exc()
    sys.stdout.flush()
    os._exit(1)
print('asperity: all steps done')
sys.stdout.flush()
os._exit(0)
)";
  return {{"box.py", script}, {"particles.csv", table}};
}

}  // namespace asperity

// LudingMat has one set of numbers for a material; each pair's own are set on its contacts as they come into
// being, scaled with their size.
#include <cmath>

#include "engines/many_particles/matrix_header.h"
#include "engines/many_particles/matrix_inputs.h"
#include "engines/many_particles/time_step.h"
#include "engines/text_number.h"
#include "engines/yade_contacts.h"

namespace asperity {
namespace {

const char* const luding_functions = R"(
def asperity_begin(i, pair):
    # the law has acted once with the material's numbers: that is taken back, and the pair's act in the same
    # step
    phys, radius, depth = i.phys, asperity_radius(i), i.geom.penetrationDepth
    force = phys.normalForce + phys.shearForce
    for key in ('k1', 'kp', 'kc', 'ks'):
        setattr(phys, key, pair[key]*radius)
    phys.PhiF, phys.tangensOfFrictionAngle = pair['PhiF'], pair['friction']
    phys.DeltPNull = phys.PhiF*2*radius
    phys.DeltPMax = phys.kp/(phys.kp - phys.k1)*phys.DeltPNull
    phys.DeltMax, phys.DeltNull, phys.DeltPrev = depth, 0, depth
    masses = [O.bodies[b].state.mass for b in (i.id1, i.id2) if isinstance(O.bodies[b].shape, Sphere)]
    mass = masses[0]*masses[1]/sum(masses) if len(masses) == 2 else masses[0]
    phys.G0 = 2*asperity_damping_ratio*(mass*phys.k1)**0.5
    phys.shearForce = Vector3.Zero
    beyond = max(0, depth - phys.DeltPMax)
    phys.normalForce = i.geom.normal*(phys.k1*(depth - beyond) + phys.kp*beyond)
    asperity_add(i, phys.normalForce - force, Vector3.Zero)

def asperity_step():
    global asperity_known
    now = set()
    for i in O.interactions:
        key = (i.id1, i.id2, i.iterMadeReal)
        now.add(key)
        if key not in asperity_known:
            pair = asperity_contacts.get(frozenset(O.bodies[b].material.label for b in (i.id1, i.id2)))
            if pair is not None:
                asperity_begin(i, pair)
    asperity_known = now
)";

}  // namespace

std::string yade_luding_matrix(const MaterialMatrix& matrix) {
  MatrixHeader header;
  header.engine = "YADE";
  header.sizes = "asperity_step() scales stiffness with R_e.";
  header.damping = "G0 = 2 beta (m k1)^(1/2) of each contact, beta = -ln e/(ln^2 e + pi^2)^(1/2).";
  each_pair(matrix, [&](std::size_t i, std::size_t j) {
    const PairLaw& law = matrix.pair(i, j).law;
    if (law.rolling > 0 || law.torsion > 0)
      header.not_expressed.push_back(
          pair_name(matrix, i, j) +
          ": rolling and torsion: this law of YADE has neither; -100 % at every load");
  });
  std::string text = header_text(matrix, header, python_comment) + R"(
# O.engines: InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom(),
#                             Ig2_Facet_Sphere_ScGeom()], [asperity_functor], [asperity_law]),
#            # behind it and before NewtonIntegrator(damping=0), at every step
#            PyRunner(command='asperity_step()', iterPeriod=1, initRun=True),
asperity_materials = []  # ids of the types, in their order
)";
  const double R = matrix.pair_radius();
  for (std::size_t i = 0; i < matrix.materials.size(); ++i) {
    const MatrixMaterial& m = matrix.materials[i];
    const LudingPair& luding = *matrix.pair(i, i).law.luding;
    text += "asperity_materials.append(O.materials.append(LudingMat(label=" + python_literal(m.name) +
            ", k1=" + text_number(luding.k1 * R) + ", kp=" + text_number(luding.kp * R) +
            ",\n    kc=" + text_number(luding.kc * R) + ", ks=" + text_number(luding.lateral * R) +
            ", PhiF=" + text_number(luding.phi) +
            ", G0=0, frictionAngle=0, density=" + text_number(std::isfinite(m.density) ? m.density : 1000) +
            ")))  # replaced on each contact\n";
  }
  text +=
      "asperity_functor = Ip2_LudingMat_LudingMat_LudingPhys()\nasperity_law = "
      "Law2_ScGeom_LudingPhys_Basic()\nasperity_damping_ratio = " +
      text_number(damping_ratio(matrix.restitution)) +
      "\nO.dt = " + text_number(time_step_of(matrix).advised) + "\n" + yade_contact_functions +
      luding_functions + "\n";
  each_pair(matrix, [&](std::size_t i, std::size_t j) {
    const PairLaw& law = matrix.pair(i, j).law;
    const LudingPair& luding = *law.luding;
    text += "asperity_contacts[frozenset([" + python_literal(matrix.materials[i].name) + ", " +
            python_literal(matrix.materials[j].name) +
            "])] = dict(  # stiffness over R_e\n    k1=" + text_number(luding.k1) +
            ", kp=" + text_number(luding.kp) + ", kc=" + text_number(luding.kc) +
            ", ks=" + text_number(luding.lateral) + ", PhiF=" + text_number(luding.phi) +
            ", friction=" + text_number(law.sliding) + ")\n";
  });
  return text;
}

}  // namespace asperity

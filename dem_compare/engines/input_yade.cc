// YADE: functions that put the numbers on each interaction, since the functor's own depend on both radii.
#include <cmath>

#include "dem_compare/engines/input_notes.h"
#include "dem_compare/engines/text_number.h"

namespace asperity {

std::string yade_input(InputNotes& notes) {
  const double root = std::sqrt(notes.effective_radius());
  const double kno = 4.0 / 3 * notes.record().hertz().reduced_modulus * root, kso = 8 * notes.shear_modulus() * root;
  notes.meaning("kno", kno, "N/m^(3/2)", "4/3 E* R_e^(1/2), F = kno delta^(3/2)");
  notes.meaning("kso", kso, "N/m^(3/2)", "8 G* R_e^(1/2), lateral stiffness kso delta^(1/2)");
  const double mu = notes.sliding();
  notes.meaning("tangensOfFrictionAngle", mu, "", "|f_l| <= tan F");
  double kr = 0, bend = 0, ktw = 0, twist = 0;
  if (notes.has_rolling()) {
    kr = notes.constant_rolling_stiffness();
    bend = notes.rolling();
    notes.meaning("kr", kr, "N m/rad", "K_ro (krot of the functor)");
    notes.meaning("maxBendPl", bend, "m", "C_ro, |M| <= maxBendPl F; the functor would make it eta times the mean of both radii");
  }
  if (notes.has_torsion()) {
    ktw = notes.constant_torsion_stiffness();
    twist = notes.torsion();
    notes.meaning("ktw", ktw, "N m/rad", "K_to (ktwist of the functor)");
    notes.meaning("twist_limit", twist, "m", "C_to, |M| <= twist_limit F: MindlinPhys has no such limit, limit_torsion() lays it on");
  }
  if (notes.record().pull_off_force)
    notes.cannot("pull-off force h_n = " + text_number(notes.record().pull_off_force->value) +
                 " N: includeAdhesion (DMT, 4 pi gamma R_e) would add it to the limits of all modes; left out");
  if (notes.record().target.is_plane())
    notes.meaning("plane", 1e5 * notes.record().particle.radius, "m",
                  "make it a sphere of at least this radius: walls and facets count as spheres (R/2 and 2/3 R)");
  std::string text = notes.text("#");
  text += R"(
# O.engines: InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_MindlinPhys(krot=1, ktwist=1, eta=1, betan=0.5, betas=0)],
#                            [Law2_ScGeom_MindlinPhys_Mindlin(includeMoment=True)]),
#            PyRunner(command='contact_numbers(); limit_torsion()', iterPeriod=1), behind it and before NewtonIntegrator
numbers = dict(kno=)" + text_number(kno) + ", kso=" + text_number(kso) + ", tangensOfFrictionAngle=" + text_number(mu) +
          ",\n               kr=" + text_number(kr) + ", ktw=" + text_number(ktw) + ", maxBendPl=" + text_number(bend) + ")\ntwist_limit = " +
          text_number(twist) + R"(

def contact_numbers():
    for i in O.interactions:  # those that are new
        if i.phys.kno != numbers['kno']:
            for key, value in numbers.items(): setattr(i.phys, key, value)

def limit_torsion():
    for i in O.interactions:
        most, moment = twist_limit*i.phys.normalForce.norm(), i.phys.momentTwist.norm()
        if twist_limit > 0 and moment > most: i.phys.momentTwist = i.phys.momentTwist*(most/moment)
)";
  return text;
}

}  // namespace asperity

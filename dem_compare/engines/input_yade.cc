// YADE: functions that put the numbers on each contact of the two materials, since the functor's own are one for all.
#include <cmath>

#include "dem_compare/engines/input_notes.h"
#include "dem_compare/engines/text_number.h"
#include "dem_compare/engines/yade_contacts.h"

namespace asperity {

std::string yade_input(InputNotes& notes) {
  const double root = std::sqrt(notes.effective_radius());
  YadeContact contact;
  contact.kno = 4.0 / 3 * notes.record().hertz().reduced_modulus * root;
  contact.kso = 8 * notes.shear_modulus() * root;
  notes.meaning("kno", contact.kno, "N/m^(3/2)", "4/3 E* R_e^(1/2), F = kno delta^(3/2)");
  notes.meaning("kso", contact.kso, "N/m^(3/2)", "8 G* R_e^(1/2), lateral stiffness kso delta^(1/2)");
  contact.friction = notes.sliding();
  notes.meaning("tangensOfFrictionAngle", contact.friction, "", "|f_l| <= tan F");
  if (notes.has_rolling()) {
    contact.kr = notes.constant_rolling_stiffness();
    contact.bend = notes.rolling();
    notes.meaning("kr", contact.kr, "N m/rad", "K_ro (krot of the functor)");
    notes.meaning("maxBendPl", contact.bend, "m", "C_ro, |M| <= maxBendPl F; the functor would make it eta times the mean of both radii");
  }
  if (notes.has_torsion()) {
    contact.ktw = notes.constant_torsion_stiffness();
    contact.twist = notes.torsion();
    notes.meaning("ktw", contact.ktw, "N m/rad", "K_to (ktwist of the functor)");
    notes.meaning("twist_limit", contact.twist, "m", "C_to, |M| <= twist_limit F: MindlinPhys has no such limit, asperity_step() lays it on");
  }
  if (notes.record().pull_off_force)
    notes.cannot("pull-off force h_n = " + text_number(notes.record().pull_off_force->value) +
                 " N: includeAdhesion (DMT, 4 pi gamma R_e) would add it to the limits of all modes; left out");
  notes.cannot("other radii: kno and kso follow R_e^(1/2) of each contact, kr, ktw, maxBendPl and twist_limit are those of the R_e above");
  return notes.text(python_comment) + R"(
# Materials: O.materials.append(FrictMat(..., label=PARTICLE)) and label=TARGET; contacts of other materials stay as they are.
# O.engines: InteractionLoop([Ig2_Sphere_Sphere_ScGeom()],
#                            [Ip2_FrictMat_FrictMat_MindlinPhys(betan=0.5)],  # not in the record: choose the damping
#                            [Law2_ScGeom_MindlinPhys_Mindlin(includeMoment=True)]),
#            PyRunner(command='asperity_step()', iterPeriod=1, initRun=True),  # behind it and before NewtonIntegrator, at every step
PARTICLE = )" + python_literal(notes.particle_name()) + "\nTARGET = " + python_literal(notes.target_name()) + "\n" + yade_functions +
         "\n" + yade_contact_entry("PARTICLE", "TARGET", notes.effective_radius(), contact);
}

}  // namespace asperity

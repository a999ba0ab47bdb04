// YADE 2023.02a: LudingMat and Law2_ScGeom_LudingPhys_Basic.
#include <cmath>

#include "engines/elastoplastic/elastoplastic_inputs.h"
#include "engines/elastoplastic/luding_numbers.h"
#include "engines/escaped_text.h"
#include "engines/text_number.h"

namespace asperity {

std::string yade_luding(InputNotes& notes) {
  const LudingNumbers luding = luding_numbers(notes, {"k1", "kp", "kc", "PhiF"});
  notes.meaning("ks", luding.lateral, "N/m", "lateral stiffness, constant");
  if (notes.has_rolling() || notes.has_torsion())
    notes.cannot("rolling and torsion: this law of YADE has neither; -100.0 % at every load");
  notes.cannot(
      "walls and facets: this law of YADE gives them no plastic range; make a plane of a sphere 100 000 "
      "times as large");
  notes.cannot("pairs of one material with itself: they take this law too");
  const auto material = [&](const char* label, double density) {
    return std::string("O.materials.append(LudingMat(label=") + label + ", **luding" +
           (density > 0 ? ", density=" + text_number(density) : "") + "))\n";
  };
  return notes.text(python_comment) +
         "from math import atan\nPARTICLE = " + python_literal(notes.particle_name()) +
         "\nTARGET = " + python_literal(notes.target_name()) +
         "\nluding = dict(k1=" + text_number(luding.k1) + ", kp=" + text_number(luding.kp) +
         ", kc=" + text_number(luding.kc) + ", ks=" + text_number(luding.lateral) +
         ", PhiF=" + text_number(luding.phi) + ",\n              frictionAngle=atan(" +
         text_number(luding.sliding) +
         "), G0=0)  # G0, the damping [N s/m], is not in the record: choose it\n" +
         material("PARTICLE", notes.record().particle.density) +
         material("TARGET", notes.record().target.density) +
         R"(# O.engines: InteractionLoop([Ig2_Sphere_Sphere_ScGeom()],
#                            [Ip2_LudingMat_LudingMat_LudingPhys()],
#                            [Law2_ScGeom_LudingPhys_Basic()]),
)";
}

}  // namespace asperity

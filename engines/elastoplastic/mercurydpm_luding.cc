// MercuryDPM: LinearPlasticViscoelasticFrictionSpecies, whose springs are constant. Not run here: MercuryDPM
// is no package of Debian.
#include "engines/elastoplastic/elastoplastic_inputs.h"
#include "engines/elastoplastic/luding_numbers.h"
#include "engines/escaped_text.h"
#include "engines/text_number.h"

namespace asperity {

std::string mercurydpm_luding(InputNotes& notes) {
  const double R = notes.effective_radius();
  const LudingNumbers luding = luding_numbers(
      notes, {"LoadingStiffness", "UnloadingStiffnessMax", "CohesionStiffness", "PenetrationDepthMax"});
  notes.meaning("SlidingStiffness", luding.lateral, "N/m", "k_l, constant");
  double rolling = 0, rolling_spring = 0, torsion = 0, torsion_spring = 0;
  if (notes.has_rolling()) {
    rolling = notes.rolling() / R;
    rolling_spring = notes.constant_rolling_stiffness() / (R * R);
    notes.meaning("RollingFrictionCoefficient", rolling, "", "C_ro/R_e, |M| <= mu R_e F");
    notes.meaning("RollingStiffness", rolling_spring, "N/m", "K_ro/R_e^2");
  }
  if (notes.has_torsion()) {
    torsion = notes.torsion() / (2 * R);
    torsion_spring = notes.constant_torsion_stiffness() / (4 * R * R);
    notes.meaning("TorsionFrictionCoefficient", torsion, "", "C_to/(2 R_e), |M| <= mu 2 R_e F");
    notes.meaning("TorsionStiffness", torsion_spring, "N/m", "K_to/(2 R_e)^2");
  }
  notes.cannot(
      "nothing more is known to be missing, but this input was not run: MercuryDPM is not installed here");
  const std::string species = "LinearPlasticViscoelasticFrictionSpecies";
  std::string text =
      notes.text(cplusplus_comment) + "\n#include <Species/" + species +
      ".h>\n\nauto particle = problem.speciesHandler.copyAndAddObject(" + species +
      "());\nauto target = problem.speciesHandler.copyAndAddObject(" + species +
      "());\n// each with itself is not in the record: particle->setLoadingStiffness(...) and so on\n";
  const ContactParameters& p = notes.record();
  if (p.particle.density > 0) text += "particle->setDensity(" + text_number(p.particle.density) + ");\n";
  if (p.target.density > 0) text += "target->setDensity(" + text_number(p.target.density) + ");\n";
  text += "auto contact = problem.speciesHandler.getMixedObject(particle, target);\n";
  const auto set = [&](const std::string& what, double value) {
    text += "contact->set" + what + "(" + text_number(value) + ");\n";
  };
  set("LoadingStiffness", luding.k1);
  set("UnloadingStiffnessMax", luding.kp);
  set("CohesionStiffness", luding.kc);
  set("PenetrationDepthMax", luding.phi);
  set("SlidingStiffness", luding.lateral);
  set("SlidingFrictionCoefficient", luding.sliding);
  if (rolling > 0) set("RollingStiffness", rolling_spring), set("RollingFrictionCoefficient", rolling);
  if (torsion > 0) set("TorsionStiffness", torsion_spring), set("TorsionFrictionCoefficient", torsion);
  return text + "// not in the record: contact->setDissipation(...)\n";
}

}  // namespace asperity

// MercuryDPM: HertzianViscoelasticMindlinRollingTorsionSpecies.
#include "engines/elastoplastic/elastoplastic_inputs.h"
#include "engines/engine_registry.h"
#include "engines/input_notes.h"
#include "engines/many_particles/matrix_inputs.h"
#include "engines/text_number.h"

namespace asperity {
namespace {

std::string mercurydpm_input(InputNotes& notes) {
  const ContactParameters& p = notes.record();
  const double R = notes.effective_radius(), E = p.hertz().reduced_modulus;
  // Its lateral stiffness is (2/3) 8 G a, and rolling and torsion take their springs from 8 G a itself.
  constexpr double mercury_share = 2.0 / 3;
  const double G = notes.shear_modulus() / mercury_share;
  notes.meaning("EffectiveElasticModulus", E, "Pa",
                "E*; set it directly, the setter from modulus and Poisson's ratio computes another one");
  notes.meaning("EffectiveShearModulus", G, "Pa",
                "3/2 G*, because the lateral stiffness is 2/3 of 8 G a there");
  const double mu = notes.sliding();
  notes.meaning("SlidingFrictionCoefficient", mu, "", "|f_l| <= mu F");
  const OfLoad k = [&](double load) { return 8 * G * p.contact_radius(load); };
  double rolling = 0, torsion = 0;
  if (notes.has_rolling()) {
    rolling = notes.rolling() / R;
    notes.meaning("RollingFrictionCoefficient", rolling, "", "C_ro/R_e, |M| <= mu R_e F");
    notes.rolling_stiffness_is([&](double load) { return k(load) * R * R; }, "8 G a R_e^2 with that G");
  }
  if (notes.has_torsion()) {
    torsion = notes.torsion() / (2 * R);
    notes.meaning("TorsionFrictionCoefficient", torsion, "", "C_to/(2 R_e), |M| <= mu 2 R_e F");
    notes.torsion_stiffness_is([&](double load) { return k(load) * 4 * R * R; },
                               "8 G a (2 R_e)^2 with that G");
    notes.cannot(
        "torsion that reverses: in copies of July 2024 the torsion spring of the Mindlin species doubles "
        "every step and never unloads; check yours");
  }
  notes.leaves_out_pull_off(
      "a ReversibleAdhesive species takes it by setAdhesionForceMax, and then adds it to the limits of all "
      "modes");
  std::string text = notes.text(cplusplus_comment) + R"(
#include <Species/HertzianViscoelasticMindlinRollingTorsionSpecies.h>

auto particle = problem.speciesHandler.copyAndAddObject(HertzianViscoelasticMindlinRollingTorsionSpecies());
auto target = problem.speciesHandler.copyAndAddObject(HertzianViscoelasticMindlinRollingTorsionSpecies());
// each with itself is not in the record: particle->setEffectiveElasticModulus(...) and so on
)";
  if (p.particle.density > 0) text += "particle->setDensity(" + text_number(p.particle.density) + ");\n";
  if (p.target.density > 0) text += "target->setDensity(" + text_number(p.target.density) + ");\n";
  text += "auto contact = problem.speciesHandler.getMixedObject(particle, target);\n";
  const auto set = [&](const std::string& what, double value) {
    text += "contact->set" + what + "(" + text_number(value) + ");\n";
  };
  set("EffectiveElasticModulus", E);
  set("EffectiveShearModulus", G);
  set("SlidingFrictionCoefficient", mu);
  if (rolling > 0) set("RollingFrictionCoefficient", rolling);
  if (torsion > 0) set("TorsionFrictionCoefficient", torsion);
  text += "// not in the record: contact->setDissipation(...), by its own definition of damping\n";
  return text;
}

}  // namespace

namespace engines {
std::unique_ptr<WrittenEngine> make_mercurydpm() {
  return written_engine(
      "mercurydpm", "MercuryDPM",
      {mercurydpm_input, mercurydpm_matrix, nullptr, "luding", mercurydpm_luding, mercurydpm_luding_matrix});
}
}  // namespace engines

}  // namespace asperity

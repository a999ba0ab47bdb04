// MUSEN: lines for a job script, which set the properties of its materials database.
#include "engines/engine_registry.h"
#include "engines/input_notes.h"
#include "engines/many_particles/matrix_inputs.h"
#include "engines/musen_script.h"

namespace asperity {
namespace {

std::string musen_input(InputNotes& notes) {
  const ContactParameters& p = notes.record();
  const EngineElasticity elasticity = engine_elasticity(notes);
  notes.meaning("YOUNG_MODULUS", elasticity.youngs_modulus[0], "Pa",
                "of the particle; MUSEN makes E* and k_l = 8 G* a of both compounds");
  const double mu = notes.sliding(), R = p.particle.radius;
  notes.meaning("SLIDING_FRICTION", mu, "", "|f_l| <= mu F");
  double rolling = 0;
  if (notes.has_rolling()) {
    rolling = notes.rolling() / R;
    notes.meaning("ROLLING_FRICTION", rolling, "", "C_ro/R, |M| <= mu R F along the whole angular velocity");
    notes.cannot("rolling stiffness: the torque has no spring");
  }
  if (notes.has_torsion()) notes.cannot("torsion: merged with rolling, the same coefficient holds for spin");
  notes.leaves_out_pull_off(
      "the model Popov-JKR makes it 1.5 pi gamma R_e with gamma the full work of adhesion");
  std::string text = notes.text(plain_comment) + "\n# For a job of a script; contact model Hertz-Mindlin\n";
  for (std::size_t i = 0; i < 2; ++i) {
    text += musen_compound(i + 1, i == 0 ? notes.particle_name() : notes.target_name());
    const double density = (i == 0 ? p.particle : p.target).density;
    if (density > 0) text += musen_material("DENSITY", i + 1, density);
    text += musen_material("YOUNG_MODULUS", i + 1, elasticity.youngs_modulus[i]) +
            musen_material("POISSON_RATIO", i + 1, elasticity.poissons_ratio[i]);
  }
  text += musen_interaction("SLIDING_FRICTION", 1, 2, mu);
  if (rolling > 0) text += musen_interaction("ROLLING_FRICTION", 1, 2, rolling);
  text += "# not in the record, choose it: INTERACTION_PROPERTY RESTITUTION_COEFFICIENT KEY_1 KEY_2 ...\n";
  return text;
}

}  // namespace

namespace engines {
std::unique_ptr<WrittenEngine> make_musen() {
  return written_engine("musen", "MUSEN", {musen_input, musen_matrix});
}
}  // namespace engines

}  // namespace asperity

// MUSEN: the properties that its materials editor asks for, as a list to type in.
#include "core/printable.h"
#include "engines/engine_registry.h"
#include "engines/input_notes.h"
#include "engines/many_particles/matrix_inputs.h"
#include "engines/text_number.h"

namespace asperity {
namespace {

std::string musen_input(InputNotes& notes) {
  const ContactParameters& p = notes.record();
  const EngineElasticity elasticity = engine_elasticity(notes);
  notes.meaning("Young modulus", elasticity.youngs_modulus[0], "Pa",
                "of the particle; MUSEN makes E* and k_l = 8 G* a of both compounds");
  const double mu = notes.sliding(), R = p.particle.radius;
  notes.meaning("Sliding friction", mu, "", "|f_l| <= mu F");
  double rolling = 0;
  if (notes.has_rolling()) {
    rolling = notes.rolling() / R;
    notes.meaning("Rolling friction", rolling, "", "C_ro/R, |M| <= mu R F along the whole angular velocity");
    notes.cannot("rolling stiffness: the torque has no spring");
  }
  if (notes.has_torsion()) notes.cannot("torsion: merged with rolling, the same coefficient holds for spin");
  notes.leaves_out_pull_off(
      "the model Popov-JKR makes it 1.5 pi gamma R_e with gamma the full work of adhesion");
  std::string text = notes.text(plain_comment) + "\n# Materials editor, compounds\n";
  for (int i = 0; i < 2; ++i)
    text += printable(i == 0 ? notes.particle_name() : notes.target_name()) + ": Young modulus [Pa] " +
            text_number(elasticity.youngs_modulus[i]) + ", Poisson ratio [-] " +
            text_number(elasticity.poissons_ratio[i]) + "\n";
  text += "# Materials editor, interaction of both; contact model Hertz-Mindlin\nSliding friction [-] " +
          text_number(mu) + "\n";
  if (rolling > 0) text += "Rolling friction [-] " + text_number(rolling) + "\n";
  text += "# Restitution coefficient [-]: not in the record, choose it\n";
  return text;
}

}  // namespace

namespace engines {
std::unique_ptr<WrittenEngine> make_musen() {
  return written_engine("musen", "MUSEN", {musen_input, musen_matrix});
}
}  // namespace engines

}  // namespace asperity

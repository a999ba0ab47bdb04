// LIGGGHTS 3.8: 'model luding', whose k_p and k_c are given over k1.
#include "engines/elastoplastic/elastoplastic_inputs.h"
#include "engines/elastoplastic/luding_numbers.h"
#include "engines/escaped_text.h"
#include "engines/text_number.h"

namespace asperity {
namespace {

/// One number for all pairs of types 1 and 2: the law needs k_p above k1 of each of them.
std::string all_pairs(const std::string& fix, const std::string& name, const std::string& value) {
  std::string text = "fix " + fix + " all property/global " + name + " peratomtypepair 2";
  for (int i = 0; i < 4; ++i) text += " " + value;
  return text + "\n";
}

}  // namespace

std::string liggghts_luding(InputNotes& notes) {
  const double R = notes.effective_radius();
  const LudingNumbers luding =
      luding_numbers(notes, {"LoadingStiffness", "UnloadingStiffness times it",
                             "coefficientAdhesionStiffness times it", "coefficientPlasticityDepth"});
  notes.cannot("lateral stiffness: it is k1 here and cannot be set; the record's " +
               text_number(luding.lateral) + " N/m, so " + text_number(luding.k1 / luding.lateral) +
               " times as much");
  double rolling = 0, prefactor = 0;
  if (notes.has_rolling()) {
    rolling = notes.rolling() / R;
    notes.meaning("coefficientRollingFriction", rolling, "", "C_ro/R_e, |M| <= mu R_e F");
    prefactor = notes.rolling_stiffness_over([&](double) { return luding.k1 * rolling * rolling * R * R; },
                                             "which is prefactor k1 mu^2 R_e^2 here");
    notes.meaning("rollingStiffness", prefactor, "", "K_ro/(k1 mu^2 R_e^2)");
  }
  if (notes.has_torsion()) notes.cannot("torsion limit and stiffness: -100.0 % at every load");
  notes.cannot("pairs of one type with itself: they take this law too");
  const std::string model =
      std::string("model luding tangential history") + (rolling > 0 ? " rolling_friction epsd3" : "");
  std::string text = notes.text(lammps_comment) +
                     "\nhard_particles yes  # before the box: moduli above 1e9 Pa are refused otherwise\n"
                     "# type 1 is the particle's material, type 2 the target's; the restitution that damping "
                     "makes is not in the record: choose it\nvariable restitution index 0.99\n";
  const ContactParameters& p = notes.record();
  const auto known = [](double value, double otherwise) {
    return text_number(std::isfinite(value) ? value : otherwise);
  };
  // Asked for by the engine, not used by this law.
  text += "fix m1 all property/global youngsModulus peratomtype " + known(p.particle.youngs_modulus, 1e9) +
          " " + known(p.target.youngs_modulus, 1e9) +
          "\nfix m2 all property/global poissonsRatio peratomtype " + known(p.particle.poissons_ratio, 0.3) +
          " " + known(p.target.poissons_ratio, 0.3) + "\n";
  text += all_pairs("m3", "coefficientFriction", text_number(luding.sliding)) +
          all_pairs("m4", "coefficientRestitution", "${restitution}") +
          all_pairs("m5", "LoadingStiffness", text_number(luding.k1)) +
          all_pairs("m6", "UnloadingStiffness", text_number(luding.kp / luding.k1)) +
          all_pairs("m7", "coefficientAdhesionStiffness", text_number(luding.kc / luding.k1)) +
          all_pairs("m8", "coefficientPlasticityDepth", text_number(luding.phi)) +
          all_pairs("m9", "pullOffForce", "0");
  if (rolling > 0)
    text += all_pairs("m10", "coefficientRollingFriction", text_number(rolling)) +
            all_pairs("m11", "coefficientRollingViscousDamping", "0") +
            "fix m12 all property/global rollingStiffness scalar " + text_number(prefactor) + "\n";
  text += "pair_style gran " + model + "\npair_coeff * *\n";
  if (p.target.is_plane()) text += "fix contact all wall/gran " + model + " primitive type 2 zplane 0.0\n";
  return text;
}

}  // namespace asperity

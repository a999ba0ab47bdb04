// LIGGGHTS 3.8: properties by type, rolling by the model epsd3.

#include "engines/elastoplastic/elastoplastic_inputs.h"
#include "engines/engine_registry.h"
#include "engines/input_notes.h"
#include "engines/many_particles/matrix_inputs.h"
#include "engines/many_particles/particle_box.h"
#include "engines/text_number.h"

namespace asperity {
namespace {

/// Of types 1 and 2 with one another; with themselves they keep what the user chooses.
std::string pair(const std::string& name, const std::string& of_1, double value, const std::string& of_2) {
  const std::string v = text_number(value);
  return " all property/global " + name + " peratomtypepair 2 " + of_1 + " " + v + " " + v + " " + of_2 +
         "\n";
}

void name_what_is_left_out(InputNotes& notes) {
  if (notes.has_torsion())
    notes.cannot(
        "torsion limit and stiffness: there is no torsion beside 'luding', which takes rolling's coefficient "
        "and history for it; -100.0 % at every load");
  notes.leaves_out_pull_off("cohesion sjkr is an area law of its own");
  notes.cannot(
      "relaxation of the lateral spring as a contact unloads: without damping, a spinning impact gains up to "
      "a tenth of its lateral energy; keep coefficientRestitution at 0.9 or below");
}

std::string liggghts_input(InputNotes& notes) {
  const ContactParameters& p = notes.record();
  const double R = notes.effective_radius();
  const EngineElasticity elasticity = engine_elasticity(notes);
  notes.meaning("youngsModulus", elasticity.youngs_modulus[0], "Pa",
                "of type 1, the particle; LIGGGHTS makes E* and k_l = 8 G* a of them");
  const double mu = notes.sliding();
  notes.meaning("coefficientFriction", mu, "",
                "|f_l| <= mu |F|; the normal damping is part of F, the tangential one comes on top");
  double rolling = 0, prefactor = 0;
  if (notes.has_rolling()) {
    rolling = notes.rolling() / R;
    // k_n of LIGGGHTS' Hertz is 4/3 E* a.
    const OfLoad k = [&](double load) {
      return 4.0 / 3 * p.hertz().reduced_modulus * p.contact_radius(load) * rolling * rolling * R * R;
    };
    prefactor = notes.rolling_stiffness_over(k, "which is prefactor k_n mu^2 R_e^2 here, k_n = 4/3 E* a");
    notes.meaning("coefficientRollingFriction", rolling, "", "C_ro/R_e, |M| <= mu R_e F");
    notes.meaning("rollingStiffness", prefactor, "",
                  "K_ro/(k_n mu^2 R_e^2), k_n = 4/3 E* a; the manual calls it coeffRollingStiffness, which "
                  "3.8.0 refuses");
  }
  name_what_is_left_out(notes);
  const std::string model =
      std::string("model hertz tangential history") + (rolling > 0 ? " rolling_friction epsd3" : "");
  std::string text = notes.text(lammps_comment) +
                     "\nhard_particles yes  # before the box: moduli above 1e9 Pa are refused otherwise\n";
  text +=
      "# type 1 is the particle's material, type 2 the target's. Each with itself is not in the record, nor "
      "is restitution: set these before, or here.\n"
      "variable friction_11 index 0\nvariable friction_22 index 0\nvariable rolling_friction_11 index 0\n"
      "variable rolling_friction_22 index 0\nvariable restitution index 0.5\n";
  text += "fix m1 all property/global youngsModulus peratomtype " +
          text_number(elasticity.youngs_modulus[0]) + " " + text_number(elasticity.youngs_modulus[1]) +
          "\nfix m2 all property/global poissonsRatio peratomtype " +
          text_number(elasticity.poissons_ratio[0]) + " " + text_number(elasticity.poissons_ratio[1]) + "\n";
  text += "fix m3" + pair("coefficientFriction", "${friction_11}", mu, "${friction_22}");
  if (rolling > 0) {
    text += "fix m4" +
            pair("coefficientRollingFriction", "${rolling_friction_11}", rolling, "${rolling_friction_22}");
    text += "fix m5" + pair("coefficientRollingViscousDamping", "0", 0, "0");
    text += "fix m6 all property/global rollingStiffness scalar " + text_number(prefactor) +
            "  # one for all pairs of types\n";
  }
  text +=
      "fix m7 all property/global coefficientRestitution peratomtypepair 2 ${restitution} ${restitution} "
      "${restitution} ${restitution}\n";
  text += "pair_style gran " + model + "\npair_coeff * *\n";
  if (p.target.is_plane()) text += "fix contact all wall/gran " + model + " primitive type 2 zplane 0.0\n";
  return text;
}

}  // namespace

namespace engines {
std::unique_ptr<WrittenEngine> make_liggghts() {
  return written_engine(
      "liggghts", "LIGGGHTS",
      {liggghts_input, liggghts_matrix, liggghts_box, "luding", liggghts_luding, liggghts_luding_matrix});
}
}  // namespace engines

}  // namespace asperity

// LAMMPS of 2025 on: normal model mdr (Zunker & Kamrin 2024, J. Mech. Phys. Solids 183, 105492). Not run
// here: Debian's LAMMPS is of 2022.
#include "engines/elastoplastic/elastoplastic_inputs.h"
#include "engines/elastoplastic/luding_numbers.h"
#include "engines/escaped_text.h"
#include "engines/text_number.h"

namespace asperity {

std::string lammps_mdr(InputNotes& notes) {
  using P = ContactParameters;
  const double R = notes.effective_radius(), E = elastoplastic_number(notes, &P::unloading_modulus),
               p_y = elastoplastic_number(notes, &P::yield_pressure),
               w = value_or_zero(notes.record().yielded_work_of_adhesion);
  // Two equal bodies with this E* in a pair; mdr's walls are rigid, so that on a wall E/(1 - nu^2) is E*
  // itself.
  constexpr double nu = 0.3;
  const double youngs = E * (1 - nu * nu) * (notes.record().target.is_plane() ? 1 : 2);
  constexpr double hardness_over_yield = 2.75;  // of small contacts in mdr, 1.75 + 1
  notes.meaning("mdr E", youngs, "Pa", "E* (1 - nu^2) on a rigid wall, twice that of a pair; nu = 0.3");
  notes.meaning("mdr Y", p_y / hardness_over_yield, "Pa",
                "p_y/2.75: fully plastic small contacts carry 2.75 Y in mdr, p_y in Thornton & Ning's law");
  notes.meaning("mdr dgamma", w, "J/m^2", "work of adhesion");
  const double mu = notes.sliding(), lateral = notes.constant_lateral_stiffness();
  notes.meaning("linear_history k", lateral, "N/m", "k_l, constant");
  notes.meaning("linear_history mu", mu, "", "|f_l| <= mu F");
  std::string friction = " tangential linear_history " + text_number(lateral) + " 1.0 " + text_number(mu);
  if (notes.has_rolling()) {
    const double spring = notes.constant_rolling_stiffness() / (R * R), rolling = notes.rolling() / R;
    notes.meaning("sds", rolling, "", "C_ro/R_e, |M| <= mu R_e F; spring K_ro/R_e^2");
    friction += " rolling sds " + text_number(spring) + " 0.0 " + text_number(rolling);
  }
  notes.cannot("torsion: left out");
  notes.cannot(
      "mdr is a law of the material, not of the contact: both coefficients are those that the solved "
      "contact's "
      "unloading and yield give, and the rest of mdr (bulk response, free area) is as its authors set it");
  notes.cannot("this input was not run: mdr came after the LAMMPS that asperity is tested with");
  std::string text =
      notes.text(lammps_comment) + "\n# psi_b = 0.5 and restitution 0.5 are not in the record: choose them\n";
  const std::string model = "mdr " + text_number(youngs) + " " + text_number(nu) + " " +
                            text_number(p_y / hardness_over_yield) + " " + text_number(w) + " 0.5 0.5" +
                            friction + " damping none\n";
  text += "pair_style granular\npair_coeff 1 1 " + model;
  if (notes.record().target.is_plane())
    text += "region contact plane 0 0 0 0 0 1\nfix contact all wall/gran/region granular " +
            model.substr(0, model.size() - 1) + " region contact\n";
  return text;
}

}  // namespace asperity

// LAMMPS: fix wall/gran for a plane, pair_coeff for two spheres.
#include <cmath>

#include "dem_compare/engines/input_notes.h"
#include "dem_compare/engines/lammps.h"
#include "dem_compare/engines/text_number.h"

namespace asperity {

std::string lammps_input(InputNotes& notes) {
  const double R = notes.effective_radius();
  LammpsContact contact;
  contact.normal = 4.0 / 3 * notes.record().hertz().reduced_modulus;
  notes.meaning("hertz k", contact.normal, "Pa", "4/3 E*, F = k R_e^(1/2) delta^(3/2); given as a number: 'hertz/material' mixes walls' moduli wrongly up to 2024");
  contact.tangential = 8 * notes.shear_modulus();
  notes.meaning("mindlin k", contact.tangential, "Pa", "8 G*, lateral stiffness k a; given as a number: 'NULL' means another one at walls up to 2024");
  contact.sliding = notes.sliding();
  notes.meaning("mindlin mu", contact.sliding, "", "|f_l| <= mu F");
  if (notes.has_rolling()) {
    contact.rolling_stiffness = notes.constant_rolling_stiffness() / (R * R);
    contact.rolling = notes.rolling() / R;
    notes.meaning("rolling sds k", contact.rolling_stiffness, "N/m", "K_ro/R_e^2, torque k R_e^2 times angle");
    notes.meaning("rolling sds mu", contact.rolling, "", "C_ro/R_e, |M| <= mu R_e F");
  }
  if (notes.has_torsion()) {
    contact.torsion_stiffness = notes.constant_torsion_stiffness();
    contact.torsion = notes.torsion();
    notes.meaning("twisting sds k", contact.torsion_stiffness, "N m/rad", "K_to, torque k times angle");
    notes.meaning("twisting sds mu", contact.torsion, "m", "C_to, |M| <= mu F: a length");
  }
  if (notes.record().pull_off_force)
    notes.cannot("pull-off force h_n = " + text_number(notes.record().pull_off_force->value) +
                 " N: dmt and jkr would add twice of it to the limits of all modes, and walls lose that of dmt up to 2024; left out");
  notes.meaning("normal damping", 0, "1/(m s)", "not in the record; choose it, half of critical is g = (k_n/m)^(1/2)/a");
  // Without "rescale", a lateral force that is held while the contact unloads adds to the energy of a spinning impact.
  const std::string law = lammps_text(contact, "mindlin_rescale/force");
  const std::string header = notes.text(lammps_comment) + "\n";
  if (notes.record().target.is_plane())
    return header + "# type 1 is the particle's material; other types keep what they are given. Give this group again after creating atoms.\n"
                    "group particle type 1\nfix contact particle wall/gran granular " + law + " zplane 0 NULL contacts\n";
  return header + "pair_style granular  # once, before all pair_coeff\n"
                  "# of types 1 and 2 alone; give every pair of types, mixed ones silently become linear springs\npair_coeff 1 2 " + law + "\n";
}

}  // namespace asperity

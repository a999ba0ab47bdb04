#include "engines/lammps.h"

#include "engines/elastoplastic/elastoplastic_inputs.h"
#include "engines/engine_registry.h"
#include "engines/input_notes.h"
#include "engines/lammps_script.h"
#include "engines/many_particles/matrix_inputs.h"
#include "engines/many_particles/particle_box.h"
#include "engines/text_number.h"

namespace asperity {
namespace {

/// The line of `text` that holds `part`, from there on; "" if there is none.
std::string line_with(const std::string& text, const std::string& part) {
  const auto at = text.find(part);
  if (at == std::string::npos) return "";
  return text.substr(at, text.find('\n', at) - at);
}

}  // namespace

LammpsContact lammps_contact(const ContactParameters& p, double load) {
  const double R = p.effective_radius();
  LammpsContact contact;
  contact.normal = 4.0 / 3 * p.hertz().reduced_modulus;
  contact.tangential = p.lateral_stiffness_at(load) / p.contact_radius(load);
  contact.sliding = p.sliding_limit(load) / load;
  if (p.rolling_friction && p.rolling_stiffness) {
    contact.rolling_stiffness = p.rolling_stiffness_at(load) / (R * R);
    contact.rolling = p.rolling_limit(load) / (load * R);
  }
  if (p.torsion_friction && p.torsion_stiffness) {
    contact.torsion_stiffness = p.torsion_stiffness_at(load);
    contact.torsion = p.torsion_limit(load) / load;
  }
  return contact;
}

std::string lammps_text(const LammpsContact& c, const std::string& tangential_style) {
  std::string text = "hertz " + text_number(c.normal) + " " + text_number(c.normal_damping) + " tangential " +
                     tangential_style + " " + text_number(c.tangential) + " " +
                     text_number(c.tangential_damping) + " " + text_number(c.sliding);
  if (c.rolling_stiffness > 0)
    text += " rolling sds " + text_number(c.rolling_stiffness) + " 0 " + text_number(c.rolling);
  if (c.torsion_stiffness > 0)
    text += " twisting sds " + text_number(c.torsion_stiffness) + " 0 " + text_number(c.torsion);
  return text;
}

std::string Lammps::input(const EngineExperiment& experiment, const MotionPlan& plan) const {
  return lammps_script(experiment, plan, *this);
}

std::string Lammps::error_message(const std::string& log) const { return line_with(log, "ERROR"); }

std::string Lammps::remedy(const std::string& message) const {
  if (message.find("granular") != std::string::npos || message.find("wall/gran") != std::string::npos)
    return "this build lacks the GRANULAR package or is older than October 2018; Debian's package 'lammps' "
           "has it";
  return "asperity is tested with Debian's package 'lammps' (29 Sep 2021): use that one, or name it with "
         "--program";
}

std::string Lammps::version(const std::string& log) const {
  const std::string line = line_with(log, "LAMMPS (");
  return line.empty() ? "" : line.substr(8, line.find(')') - 8);
}

std::string Lammps::contact_input(InputNotes& notes) const {
  const double R = notes.effective_radius();
  LammpsContact contact;
  contact.normal = 4.0 / 3 * notes.record().hertz().reduced_modulus;
  notes.meaning("hertz k", contact.normal, "Pa",
                "4/3 E*, F = k R_e^(1/2) delta^(3/2); given as a number: 'hertz/material' mixes walls' "
                "moduli wrongly up to 2024");
  contact.tangential = 8 * notes.shear_modulus();
  notes.meaning(
      "mindlin k", contact.tangential, "Pa",
      "8 G*, lateral stiffness k a; given as a number: 'NULL' means another one at walls up to 2024");
  contact.sliding = notes.sliding();
  notes.meaning("mindlin mu", contact.sliding, "", "|f_l| <= mu F");
  if (notes.has_rolling()) {
    contact.rolling_stiffness = notes.constant_rolling_stiffness() / (R * R);
    contact.rolling = notes.rolling() / R;
    notes.meaning("rolling sds k", contact.rolling_stiffness, "N/m",
                  "K_ro/R_e^2, torque k R_e^2 times angle");
    notes.meaning("rolling sds mu", contact.rolling, "", "C_ro/R_e, |M| <= mu R_e F");
  }
  if (notes.has_torsion()) {
    contact.torsion_stiffness = notes.constant_torsion_stiffness();
    contact.torsion = notes.torsion();
    notes.meaning("twisting sds k", contact.torsion_stiffness, "N m/rad", "K_to, torque k times angle");
    notes.meaning("twisting sds mu", contact.torsion, "m", "C_to, |M| <= mu F: a length");
  }
  notes.leaves_out_pull_off(
      "dmt and jkr would add twice of it to the limits of all modes, and walls lose that of dmt up to 2024");
  notes.meaning("normal damping", 0, "1/(m s)",
                "not in the record; choose it, half of critical is g = (k_n/m)^(1/2)/a");
  // Without "rescale", a lateral force that is held while the contact unloads adds to the energy of a
  // spinning impact.
  const std::string law = lammps_text(contact, "mindlin_rescale/force");
  const std::string header = notes.text(lammps_comment) + "\n";
  if (notes.record().target.is_plane())
    return header +
           "# type 1 is the particle's material; other types keep what they are given. Give this group again "
           "after creating atoms.\n"
           "group particle type 1\nfix contact particle wall/gran granular " +
           law + " zplane 0 NULL contacts\n";
  return header +
         "pair_style granular  # once, before all pair_coeff\n"
         "# of types 1 and 2 alone; give every pair of types, mixed ones silently become linear "
         "springs\npair_coeff 1 2 " +
         law + "\n";
}

std::string Lammps::elastoplastic_input(InputNotes& notes) const { return lammps_mdr(notes); }

std::string Lammps::matrix_input(const MaterialMatrix& matrix) const { return lammps_matrix(matrix); }

std::vector<std::pair<std::string, std::string>> Lammps::box_files(const MaterialMatrix& matrix,
                                                                   const ParticleBox& box) const {
  return lammps_box(matrix, box, matrix_file());
}

namespace engines {
std::unique_ptr<WrittenEngine> make_lammps() { return std::make_unique<Lammps>(); }
}  // namespace engines

}  // namespace asperity

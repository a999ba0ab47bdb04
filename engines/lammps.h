// LAMMPS, pair_style granular and fix wall/gran (29 Sep 2021 and later; SI units).
//   normal "hertz k g":     F = k R_e^(1/2) delta^(3/2) + g a m v, so k = 4/3 E*.
//   "mindlin k x mu":       k_l = k a, so k = 8 G*; cap mu F. x: tangential over normal damping.
//   "rolling sds k g mu":   K = k R_e^2, |M| <= mu R_e F: mu = C/R_e with C the torque limit over the load.
//   "twisting sds K g mu":  |M| <= mu F: here mu is a length.
// Moduli are given as 4/3 E* and 8 G*, never as "hertz/material": there, versions up to 2024 mix walls'
// moduli wrongly.
#pragma once

#include <string>

#include "engines/engine.h"

namespace asperity {

class Lammps : public Engine {
 public:
  std::string key() const override { return "lammps"; }
  std::string name() const override { return "LAMMPS"; }
  std::string contact_input(InputNotes& notes) const override;
  std::string elastoplastic_law() const override { return "mdr"; }
  std::string elastoplastic_input(InputNotes& notes) const override;
  std::string matrix_input(const MaterialMatrix& matrix) const override;
  bool writes_boxes() const override { return true; }
  std::vector<std::pair<std::string, std::string>> box_files(const MaterialMatrix& matrix,
                                                             const ParticleBox& box) const override;
  std::string executable() const override { return "lmp"; }
  std::string package() const override { return "lammps"; }
  std::string input_file() const override { return "in.asperity"; }
  std::string input(const EngineExperiment& experiment, const MotionPlan& plan) const override;
  std::vector<std::string> arguments() const override { return {"-in", input_file(), "-log", "log.lammps"}; }
  std::string error_message(const std::string& log) const override;
  std::string remedy(const std::string& error_message) const override;
  std::string version(const std::string& log) const override;

  std::string tangential_style =
      "mindlin";  ///< or mindlin/force, mindlin_rescale, mindlin_rescale/force: alike at constant load
  bool marshall = false;  ///< "twisting marshall" (Marshall 2009): K = k_l a^2/2, M = (2/3) mu a F, in place
                          ///< of the record's torsion
};

/// Numbers of one contact in LAMMPS' terms.
struct LammpsContact {
  double normal = 0;          ///< 4/3 E* [Pa]
  double normal_damping = 0;  ///< g [1/(m s)]
  double tangential = 0;      ///< 8 G* or k_l/a [Pa]
  double tangential_damping = 0;
  double sliding = 0;                         ///< mu_l
  double rolling_stiffness = 0, rolling = 0;  ///< K_ro/R_e^2 [N/m], C_ro/R_e; zero: left out
  double torsion_stiffness = 0, torsion = 0;  ///< K_to [N m/rad], C_to [m]; zero: left out
};

/// At one load: friction limits with their offsets folded in.
LammpsContact lammps_contact(const ContactParameters& parameters, double load);

/// "hertz ... tangential ... rolling ... twisting ...".
std::string lammps_text(const LammpsContact& contact, const std::string& tangential_style = "mindlin");

}  // namespace asperity

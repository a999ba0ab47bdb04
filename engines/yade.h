// YADE, Law2_ScGeom_MindlinPhys_Mindlin (2023.02a).
//   F = kno delta^(3/2), kno = 4/3 E* R_e^(1/2);   k_l = kso delta^(1/2), kso = 8 G* R_e^(1/2);   |f_l| <=
//   tan(angle) F; rolling: spring kr, |M| <= maxBendPl F (maxBendPl = eta times the mean of both radii, a
//   length); torsion: spring ktw that never yields; the limit is laid on it by a function that YADE calls
//   each step (yade_contacts.h).
// Walls and facets count as spheres of the particle's own size there (R_e = R/2 and 2/3 R): a plane is made
// of a sphere 100 000 times as large, and all numbers are set on the contact itself.
#pragma once

#include <string>

#include "engines/engine.h"
#include "engines/yade_contacts.h"

namespace asperity {

class Yade : public Engine {
 public:
  std::string key() const override { return "yade"; }
  std::string name() const override { return "YADE"; }
  std::string contact_input(InputNotes& notes) const override;
  std::string elastoplastic_law() const override { return "luding"; }
  std::string elastoplastic_input(InputNotes& notes) const override;
  std::string matrix_input(const MaterialMatrix& matrix) const override;
  std::string elastoplastic_matrix_input(const MaterialMatrix& matrix) const override;
  std::string matrix_file() const override { return "contacts.py"; }
  bool writes_boxes() const override { return true; }
  std::vector<std::pair<std::string, std::string>> box_files(const MaterialMatrix& matrix,
                                                             const ParticleBox& box) const override;
  std::string executable() const override { return "yade"; }
  std::string package() const override { return "yade"; }
  std::string input_file() const override { return "asperity.py"; }
  std::string input(const EngineExperiment& experiment, const MotionPlan& plan) const override;
  std::vector<std::string> arguments() const override { return {"-n", "-x", input_file()}; }
  std::string error_message(const std::string& log) const override;
  std::string remedy(const std::string& error_message) const override;
  std::string version(const std::string& log) const override;
};

/// At one load: friction limits with their offsets folded in.
/// load [N].
YadeContact yade_contact(const ContactParameters& parameters, double load);

}  // namespace asperity

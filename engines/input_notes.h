// The header of an engine's input: what each number means there, and what the engine cannot express.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engines/engine_input.h"
#include "engines/escaped_text.h"

namespace asperity {

/// A record on its way into an engine; each number that is asked for leaves its line in the header.
class InputNotes {
 public:
  /// Throws InputError for a load that is not above zero and a record that lacks what the engine needs.
  InputNotes(const ContactParameters& parameters, const EngineInputOptions& options, std::string engine);

  const ContactParameters& record() const { return p_; }
  /// R_e [m].
  double effective_radius() const { return p_.effective_radius(); }
  bool has_rolling() const { return p_.rolling_friction.has_value(); }
  bool has_torsion() const { return p_.torsion_friction.has_value(); }

  /// mu_l of the engine's |f_l| <= mu F.
  /// A pure number [-].
  double sliding();
  /// C [m] of |M| <= C F.
  double rolling();
  double torsion();
  /// k_l/(8 a) [Pa], the G* that the engine's 8 G* a must be given.
  double shear_modulus();
  /// k_l [N/m] where the engine takes a constant.
  double constant_lateral_stiffness();
  /// K [N m/rad] where the engine takes a constant; zero where the record has none.
  double constant_rolling_stiffness();
  double constant_torsion_stiffness();
  /// K over k(f), which the engine multiplies it by; `factor` says which one; zero where the record has none.
  double rolling_stiffness_over(const OfLoad& k, const std::string& factor);
  /// The engine's own K, which cannot be set.
  void rolling_stiffness_is(const OfLoad& engine, const std::string& law);
  void torsion_stiffness_is(const OfLoad& engine, const std::string& law);

  /// "name = value unit: meaning".
  void meaning(const std::string& name, double value, const std::string& unit, const std::string& meaning);
  /// Something the engine cannot do at all.
  void cannot(const std::string& what);
  /// The record's pull-off force, if it has one, and why it is left out.
  void leaves_out_pull_off(const std::string& why);

  /// What the engine cannot express, each with its error, and what the record does not hold.
  std::vector<std::string> not_expressed() const;

  /// "particle" and "target", or the materials' names where the record has them: two that differ.
  std::string particle_name() const;
  std::string target_name() const;

  /// The header as comments of one language.
  std::string text(const CommentStyle& comment) const;
  /// Its lines as they are; texts of the record are in them.
  std::vector<std::string> lines() const;

 private:
  using Member = std::optional<EffectiveQuantity> ContactParameters::*;
  LoadRange range(Member friction, Member offset) const;
  double limit(const std::string& mode, Member friction, Member offset, const OfLoad& record);
  void state(const std::string& what, const Folded& folded);

  const ContactParameters& p_;
  const EngineInputOptions options_;
  std::string engine_;
  std::vector<std::string> meanings_, limits_, left_out_;
};

/// Young's modulus and Poisson's ratio for an engine that computes E* and G* from them.
struct EngineElasticity {
  double youngs_modulus[2] = {0, 0};  ///< particle, target [Pa]
  double poissons_ratio[2] = {0, 0};
};
/// The bodies' own where they give E* and k_l; else those of two equal bodies that do; notes what is left
/// over.
EngineElasticity engine_elasticity(InputNotes& notes);

}  // namespace asperity

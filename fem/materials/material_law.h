// What a body of the solver is beyond elastic, and the registry of the laws that say so: how it hardens
// (hardening.h) or relaxes (relaxation.h).
//
// A law is one file of hardening/ or relaxation/, which declares it: its entries of a case file, and how a
// body's material is made from them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/case.h"
#include "core/law_declaration.h"
#include "fem/materials/hardening.h"
#include "fem/materials/relaxation.h"

namespace asperity::fem {

/// What a body is beyond elastic, by its law.
struct MaterialLaw {
  double yield_stress;                           ///< initial [Pa]
  double kinematic_modulus = 0;                  ///< of Prager's hardening [Pa]
  std::shared_ptr<const Hardening> hardening{};  ///< null: perfectly plastic
  Relaxation relaxation{};
};

/// Why a body cannot be meant: the entry at fault, and a sentence that begins with the body's name.
struct MaterialObjection {
  std::string entry, sentence;
};

/// What a law of a body says of itself, how it is made and what it refuses.
struct MaterialDeclaration : LawDeclaration {
  /// From the values of all of its parameters.
  MaterialLaw (*make)(const LawValues&);
  /// Empty sentence: none. For a body's Young's modulus [Pa] and all of its values.
  MaterialObjection (*objection)(double youngs_modulus, const LawValues&);
};
/// All of them, by name.
const std::vector<MaterialDeclaration>& material_laws();

/// The yield stress, which every law takes: inf, elastic, where it is not given.
ParameterEntry yield_stress_parameter();
/// H of linear hardening; 0, none, where it is not given.
ParameterEntry hardening_modulus_parameter();

/// By the law whose parameters the body gives, all that it needs and none besides; an infinite yield stress
/// where it gives what none needs. Throws InputError where no law, or more than one, takes just those.
MaterialLaw make_material_law(const BodyInput& body);

/// Whether either body relaxes with time.
bool relaxes(const CaseInput& input);

/// First objection of any law to a body; an empty sentence: none.
MaterialObjection objection_to(const BodyInput& body);

}  // namespace asperity::fem

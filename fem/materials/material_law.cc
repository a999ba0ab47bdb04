#include "fem/materials/material_law.h"

#include <algorithm>

#include "core/error.h"
#include "hardening_files.h"   // all of hardening/; what they declare is linked for being included here
#include "relaxation_files.h"  // all of relaxation/, likewise

namespace asperity::fem {

const std::vector<MaterialDeclaration>& material_laws() { return declared_laws<MaterialDeclaration>(); }

ParameterEntry yield_stress_parameter() {
  return {"Yield stress",
          {"Y"},
          Dimension::pressure,
          "Initial uniaxial yield stress; inf: the body stays elastic.",
          "inf",
          positive_or_infinite};
}

ParameterEntry hardening_modulus_parameter() {
  ParameterEntry modulus{"Hardening modulus",
                         {"H"},
                         Dimension::pressure,
                         "H, growth of the yield stress per plastic strain; 0: perfectly plastic.",
                         "0 Pa"};
  modulus.optional = true;
  return modulus;
}

MaterialLaw make_material_law(const BodyInput& body) {
  const LawValues values = with_defaults(parameters_of(material_laws()), body.parameters);
  const bool yields = std::any_of(material_laws().begin(), material_laws().end(),
                                  [&](const auto& law) { return !first_missing(law, values); });
  if (!yields) return {default_of(yield_stress_parameter())};
  return the_law_meant(material_laws(), values, "law of a body").make(values);
}

bool relaxes(const CaseInput& input) {
  return make_material_law(input.particle).relaxation.is_there() ||
         make_material_law(input.substrate).relaxation.is_there();
}

MaterialObjection objection_to(const BodyInput& body) {
  const LawValues values = with_defaults(parameters_of(material_laws()), body.parameters);
  for (const auto& law : material_laws()) {
    MaterialObjection objection =
        law.objection ? law.objection(body.youngs_modulus, values) : MaterialObjection{};
    if (!objection.sentence.empty()) return objection;
  }
  return {};
}

}  // namespace asperity::fem

#include "fem/interface/adhesion_law.h"

#include "adhesion_files.h"  // all of adhesion/; what they declare is linked for being included here
#include "core/error.h"

namespace asperity::fem {

const std::vector<AdhesionLawDeclaration>& adhesion_laws() { return declared_laws<AdhesionLawDeclaration>(); }

ParameterEntry adhesion_range(const std::string& symbol) {
  ParameterEntry range{
      "Adhesion range", {symbol}, Dimension::length, "The length {symbols} of the law of adhesion.", "0 m"};
  range.if_missing = "give the length over which attraction falls, e.g. Adhesion range = 0.5 nm";
  return range;
}

std::unique_ptr<AdhesionLaw> make_adhesion_law(const std::string& name, double work,
                                               const LawValues& values) {
  std::string names;
  for (const auto& law : adhesion_laws()) {
    names += (names.empty() ? "" : ", ") + law.name;
    if (law.name != name) continue;
    const ParameterEntry* missing = first_missing(law, values);
    if (missing) throw InputError("Interface/" + missing->entry + " is 0: " + missing->if_missing);
    return law.make(work, with_defaults(law.parameters, values));
  }
  throw InputError("'" + name + "' is no law of adhesion; use one of " + names);
}

AdhesionLaws make_adhesion_laws(const InterfaceInput& input) {
  AdhesionLaws laws;
  if (input.work_of_adhesion == 0) return laws;
  laws.closing = make_adhesion_law(input.adhesion_law, input.work_of_adhesion, input.parameters);
  laws.opening = input.work_of_separation == 0
                     ? laws.closing
                     : make_adhesion_law(input.adhesion_law, input.work_of_separation, input.parameters);
  return laws;
}

}  // namespace asperity::fem

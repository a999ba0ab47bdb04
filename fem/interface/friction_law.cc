#include "fem/interface/friction_law.h"

#include "friction_files.h"  // all of friction/; what they declare is linked for being included here

namespace asperity::fem {
ShearLimit FrictionLaw::initial_limit(double pressure) const {
  InterfacePoint point;
  point.pressure = pressure;
  return limit(point, std::vector<double>(history().size(), 0.0).data());
}

const std::vector<FrictionLawDeclaration>& friction_laws() { return declared_laws<FrictionLawDeclaration>(); }

std::unique_ptr<FrictionLaw> make_friction_law(const InterfaceInput& input) {
  const auto parameters = parameters_of(friction_laws());
  const LawValues values = with_defaults(parameters, input.parameters);
  if (given_entries(parameters, values).empty()) return nullptr;
  return the_law_meant(friction_laws(), values, "law of friction").make(values);
}

}  // namespace asperity::fem

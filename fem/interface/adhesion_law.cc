#include "fem/interface/adhesion_law.h"

#include "core/error.h"
#include "fem/interface/dugdale.h"
#include "fem/interface/exponential_attraction.h"
#include "fem/interface/van_der_waals.h"

namespace asperity::fem {

const std::vector<AdhesionLawEntry>& adhesion_laws() {
  static const std::vector<AdhesionLawEntry> laws{Dugdale::entry(), ExponentialAttraction::entry(), VanDerWaals::entry()};
  return laws;
}

std::unique_ptr<AdhesionLaw> make_adhesion_law(const std::string& name, double work, double length) {
  std::string names;
  for (const auto& law : adhesion_laws()) {
    if (law.name == name) return law.make(work, length);
    names += (names.empty() ? "" : ", ") + law.name;
  }
  throw InputError("'" + name + "' is no law of adhesion; use one of " + names);
}

AdhesionLaws make_adhesion_laws(const InterfaceInput& input) {
  AdhesionLaws laws;
  if (input.work_of_adhesion == 0) return laws;
  laws.closing = make_adhesion_law(input.adhesion_law, input.work_of_adhesion, input.adhesion_range);
  laws.opening = input.opening_work == 0 ? laws.closing : make_adhesion_law(input.adhesion_law, input.opening_work, input.adhesion_range);
  return laws;
}

}  // namespace asperity::fem

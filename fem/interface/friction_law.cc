#include "fem/interface/friction_law.h"

#include "fem/interface/capped_coulomb.h"
#include "fem/interface/coulomb.h"
#include "fem/interface/shear_strength.h"

namespace asperity::fem {

const std::vector<FrictionLawEntry>& friction_laws() {
  static const std::vector<FrictionLawEntry> laws{Coulomb::entry(), ShearStrength::entry(), CappedCoulomb::entry()};
  return laws;
}

std::unique_ptr<FrictionLaw> make_friction_law(const InterfaceInput& input) {
  for (const auto& law : friction_laws())
    if (law.asked_for(input)) return law.make(input);
  return nullptr;
}

}  // namespace asperity::fem

// Coulomb friction up to a shear strength: |t| <= min(mu p, tau). Orowan (1943). mu [-], p and tau [Pa].
#pragma once

#include "fem/interface/friction/coulomb.h"
#include "fem/interface/friction/shear_strength.h"

namespace asperity::fem {

class CappedCoulomb : public FrictionLaw {
 public:
  /// coefficient mu [-], strength tau [Pa].
  CappedCoulomb(double coefficient, double strength) : coefficient_(coefficient), strength_(strength) {}
  ShearLimit limit(const InterfacePoint& point, const double*) const override {
    const double by_pressure = coefficient_ * point.pressure;
    return by_pressure < strength_ ? ShearLimit{by_pressure, coefficient_} : ShearLimit{strength_, 0};
  }

 private:
  double coefficient_, strength_;
};

inline const Registered<FrictionLawDeclaration> capped_coulomb_law{
    {{"Capped Coulomb",
      "|t| <= min(mu p, tau)",
      "Orowan (1943)",
      "pressures up to the hardness, where friction can no longer grow with the pressure",
      {Coulomb::parameter(), ShearStrength::parameter()}},
     [](const LawValues& values) -> std::unique_ptr<FrictionLaw> {
       return std::make_unique<CappedCoulomb>(values.at("Friction coefficient"), values.at("Shear strength"));
     }}};

}  // namespace asperity::fem

// Coulomb friction: |t| <= mu p. Amontons (1699), Coulomb (1785). p: contact pressure [Pa], mu: coefficient
// [-]. Taken at the scale of one node: asperities finer than the mesh are inside mu.
#pragma once

#include "fem/interface/friction_law.h"

namespace asperity::fem {

class Coulomb : public FrictionLaw {
 public:
  /// coefficient mu [-].
  explicit Coulomb(double coefficient) : coefficient_(coefficient) {}
  ShearLimit limit(const InterfacePoint& point, const double*) const override {
    return {coefficient_ * point.pressure, coefficient_};
  }

  /// The entry of mu, which other laws share.
  static ParameterEntry parameter() {
    ParameterEntry mu{"Friction coefficient", {"mu"}};
    mu.documentation =
        "Local Coulomb friction of the asperities (an input; the effective friction of the rough contact is "
        "a result).";
    return mu;
  }

 private:
  double coefficient_;
};

inline const Registered<FrictionLawDeclaration> coulomb_law{
    {{"Coulomb",
      "|t| <= mu p",
      "Coulomb (1785)",
      "where real contact grows in proportion to the load at scales below the mesh",
      {Coulomb::parameter()}},
     [](const LawValues& values) -> std::unique_ptr<FrictionLaw> {
       return std::make_unique<Coulomb>(values.at("Friction coefficient"));
     }}};

}  // namespace asperity::fem

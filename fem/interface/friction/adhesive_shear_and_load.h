// Shear that adhesion holds without load, and friction in proportion to it: |t| <= tau0 + mu p where the
// surfaces touch, with a cap tau if given: |t| <= min(tau0 + mu p, tau). Derjaguin (1934); Bowden & Tabor
// (1950); as shear strength of films that grows with the pressure, Briscoe & Evans (1982), Proc. R. Soc. A
// 380:389. tau0, tau and p [Pa], mu [-]. At the edge of contact at most 2 p, see shear_strength.h.
#pragma once

#include <algorithm>
#include <limits>

#include "core/error.h"
#include "fem/interface/friction/coulomb.h"
#include "fem/interface/friction/shear_strength.h"

namespace asperity::fem {

class AdhesiveShearAndLoad : public FrictionLaw {
 public:
  /// strength at no load tau0 [Pa], coefficient mu [-], cap tau [Pa]. Throws InputError where the cap lies
  /// below tau0.
  AdhesiveShearAndLoad(double at_no_load, double coefficient,
                       double cap = std::numeric_limits<double>::infinity())
      : at_no_load_(at_no_load), coefficient_(coefficient), cap_(cap) {
    if (cap < at_no_load)
      throw InputError(
          "Interface/Shear strength is below Adhesive shear strength, so that friction would not depend on "
          "the load; raise it, or leave out the other two entries of friction");
  }
  ShearLimit limit(const InterfacePoint& point, const double*) const override {
    const double by_load = at_no_load_ + coefficient_ * point.pressure;
    const ShearLimit inside = by_load <= cap_ ? ShearLimit{by_load, coefficient_} : ShearLimit{cap_, 0};
    return at_no_load_ > 0 ? ShearStrength::at_edge(point.pressure, inside) : inside;
  }

 private:
  double at_no_load_, coefficient_, cap_;
};

inline const Registered<FrictionLawDeclaration> adhesive_shear_and_load_law{
    {{"Adhesive shear and load",
      "|t| <= min(tau0 + mu p, tau, 2 p)",
      "Derjaguin (1934), Bowden & Tabor (1950), Briscoe & Evans (1982)",
      "where the mesh resolves the junctions; boundary films of constant thickness",
      {Coulomb::parameter(),
       {"Adhesive shear strength",
        {"tau0"},
        Dimension::pressure,
        "Local shear traction that surfaces in contact transmit without pressure; 0: none.",
        "0 Pa"},
       [] {
         ParameterEntry cap = ShearStrength::parameter();
         cap.optional = true;
         return cap;
       }()}},
     [](const LawValues& values) -> std::unique_ptr<FrictionLaw> {
       const double cap = values.at("Shear strength");
       return std::make_unique<AdhesiveShearAndLoad>(values.at("Adhesive shear strength"),
                                                     values.at("Friction coefficient"),
                                                     cap > 0 ? cap : std::numeric_limits<double>::infinity());
     }}};

}  // namespace asperity::fem

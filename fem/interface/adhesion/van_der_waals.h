// Van der Waals attraction of two half-spaces: s(g) = 2 w z0^2 / (z0 + g)^3, w = A/(12 pi z0^2) with
// Hamaker's constant A. Hamaker (1937); Israelachvili (2011), Intermolecular and Surface Forces, ch. 11. w:
// work of adhesion [J/m^2], z0: distance of surfaces in contact [m]. Long range: DMT's case. Attraction
// beyond the meshed contact region is left out.
#pragma once

#include "fem/interface/adhesion_law.h"

namespace asperity::fem {

class VanDerWaals : public AdhesionLaw {
 public:
  /// work w [J/m^2], distance z0 [m].
  VanDerWaals(double work, double distance) : work_(work), distance_(distance) {}

  Attraction at(double gap) const override {
    const double apart = distance_ + gap, ratio = distance_ / apart;
    return {2 * work_ * ratio * ratio / apart, -6 * work_ * ratio * ratio / (apart * apart),
            work_ * ratio * ratio};
  }
  double range() const override { return distances * distance_; }

 private:
  static constexpr double distances = 100;  // where 1e-4 of the work is left
  double work_, distance_;
};

inline const Registered<AdhesionLawDeclaration> van_der_waals_law{
    {{"van_der_waals",
      "s(g) = 2 w z0^2 / (z0 + g)^3",
      "Hamaker (1937); Israelachvili (2011) ch. 11",
      "no retardation: gaps below about 10 nm",
      {adhesion_range("z0")}},
     "2 w z0^2/(z0 + g)^3",
     [](double work, const LawValues& values) -> std::unique_ptr<AdhesionLaw> {
       return std::make_unique<VanDerWaals>(work, values.at("Adhesion range"));
     }}};

}  // namespace asperity::fem

// Attraction that falls exponentially: s(g) = (w/rho) exp(-g/rho). w: work of adhesion [J/m^2], rho: decay
// length [m]. Smooth everywhere, and so the easiest to solve. Universal binding without its repulsion: Rose,
// Smith & Ferrante (1983).
#pragma once

#include <cmath>

#include "fem/interface/adhesion_law.h"

namespace asperity::fem {

class ExponentialAttraction : public AdhesionLaw {
 public:
  /// work w [J/m^2], decay rho [m].
  ExponentialAttraction(double work, double decay) : work_(work), decay_(decay) {}

  Attraction at(double gap) const override {
    const double left = work_ * std::exp(-gap / decay_);
    return {left / decay_, -left / (decay_ * decay_), left};
  }
  double range() const override { return decays * decay_; }

 private:
  static constexpr double decays = 12;  // where 6e-6 of the work is left
  double work_, decay_;
};

inline const Registered<AdhesionLawDeclaration> exponential_attraction_law{
    {{"exponential",
      "s(g) = (w/rho) exp(-g/rho)",
      "Rose, Smith & Ferrante (1983), attraction only",
      "short-range attraction of unknown shape",
      {adhesion_range("rho")}},
     "(w/rho) exp(-g/rho)",
     [](double work, const LawValues& values) -> std::unique_ptr<AdhesionLaw> {
       return std::make_unique<ExponentialAttraction>(work, values.at("Adhesion range"));
     }}};

}  // namespace asperity::fem

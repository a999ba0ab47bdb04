// Any of the viscous laws, as one value. SI units.
#pragma once

#include "dem_compare/laws/any_law.h"

namespace asperity {

struct ViscousMode {
  static constexpr const char* name = "viscous";

  /// What every law of this kind gives.
  class Interface {
   public:
    virtual ~Interface() = default;
    /// Force over velocity [N s/m] for a particle's mass [kg] and a normal stiffness [N/m].
    virtual double factor(double mass, double normal_stiffness) const = 0;
  };

  /// A law held as one of this kind.
  template <class Law>
  class Held final : public Interface {
   public:
    explicit Held(Law law) : law_(std::move(law)) {}
    double factor(double mass, double normal_stiffness) const override {
      return law_.factor(mass, normal_stiffness);
    }

   private:
    Law law_;
  };
};

using ViscousLaw = LawOf<ViscousMode>;

}  // namespace asperity

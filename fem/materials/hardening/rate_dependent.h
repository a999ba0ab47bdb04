// A yield stress that grows with the logarithm of the strain rate, so that what has yielded creeps under a
// held load with the logarithm of time: sigma_y = (Y + H alpha) [1 + C ln(1 + t0 d alpha/dt)]. Johnson & Cook
// (1983), whose 1 + C ln(t0 d alpha/dt) has no limit at rest; with 1 + t0 d alpha/dt as Camacho & Ortiz
// (1997, Comput. Methods Appl. Mech. Eng. 142, 269). C [-], t0 [s]: one over the reference strain rate. The
// rate is the mean of a step. What the rate adds is dissipated.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>

#include "fem/materials/hardening.h"

namespace asperity::fem {

class RateDependent : public Hardening {
 public:
  /// modulus: H [Pa]; sensitivity: C [-]; time: t0 [s].
  RateDependent(double modulus, double sensitivity, double time)
      : modulus_(modulus), sensitivity_(sensitivity), time_(time) {}

  FlowStress flow(const YieldingPoint& point) const override {
    const double at_rest = point.initial + modulus_ * point.alpha;
    const double rates = time_ / point.time.step, faster = 1 + rates * std::max(0.0, point.increment);
    const double grown = 1 + sensitivity_ * std::log(faster);
    return {at_rest * grown, modulus_ * grown + at_rest * sensitivity_ * rates / faster};
  }
  double stored_energy(double alpha) const override { return 0.5 * modulus_ * alpha * alpha; }

 private:
  double modulus_, sensitivity_, time_;
};

inline const Registered<MaterialDeclaration> rate_dependent_law{
    {{"Rate dependent",
      "sigma_y = (Y + H alpha) [1 + C ln(1 + t0 d alpha/dt)]",
      "Johnson & Cook (1983), Camacho & Ortiz (1997)",
      "creep of what has yielded, over some decades of time; Experiment/Load time and Hold time say how fast",
      {yield_stress_parameter(),
       hardening_modulus_parameter(),
       {"Rate sensitivity",
        {"C"},
        Dimension::none,
        "C, growth of the yield stress by e times the strain rate, as a part of it; 0: none."},
       {"Creep time",
        {"t0"},
        Dimension::time,
        "One over the strain rate from which on the yield stress grows; 0: it does not.",
        "0 s"}}},
     [](const LawValues& values) -> Plasticity {
       return {values.at("Yield stress"), 0,
               std::make_shared<RateDependent>(values.at("Hardening modulus"), values.at("Rate sensitivity"),
                                               values.at("Creep time"))};
     },
     nullptr}};

}  // namespace asperity::fem

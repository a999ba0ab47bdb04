// A yield stress that grows with the strain rate, so that what has yielded creeps under a held load:
//   sigma_y = (Y + H alpha) [1 + C ((1 + t0 d alpha/dt)^m - 1)/m],
// with the logarithm of time for m = 0, its limit C ln(1 + t0 d alpha/dt): Johnson & Cook (1983), whose 1 + C
// ln(t0 d alpha/dt) has no limit at rest; with 1 + t0 d alpha/dt as Camacho & Ortiz (1997, Comput. Methods
// Appl. Mech. Eng. 142, 269). At fast rates a power of them, C/m (t0 d alpha/dt)^m, that of Cowper & Symonds
// (1957) and of Norton's (1929) creep beyond a threshold. C, m [-], t0 [s]: one over the reference strain
// rate. The rate is the mean of a step. What the rate adds is dissipated.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "fem/materials/material_law.h"

namespace asperity::fem {

class RateDependent : public Hardening {
 public:
  /// modulus: H [Pa]; sensitivity: C [-]; time: t0 [s]; exponent: m, from 0 to 1 [-].
  RateDependent(double modulus, double sensitivity, double time, double exponent = 0)
      : modulus_(modulus), sensitivity_(sensitivity), time_(time), exponent_(exponent) {}

  FlowStress flow(const YieldingPoint& point) const override {
    const double at_rest = point.initial + modulus_ * point.alpha;
    const double rates = time_ / point.time.step, faster = 1 + rates * std::max(0.0, point.increment);
    const double logarithm = std::log(faster), power = std::exp(exponent_ * logarithm),
                 by_rate = exponent_ > 0 ? std::expm1(exponent_ * logarithm) / exponent_ : logarithm,
                 grown = 1 + sensitivity_ * by_rate;
    return {at_rest * grown, modulus_ * grown + at_rest * sensitivity_ * rates * power / faster};
  }
  double stored_energy(double alpha) const override { return 0.5 * modulus_ * alpha * alpha; }

 private:
  double modulus_, sensitivity_, time_, exponent_;
};

/// Parameters of the law; without an exponent it is that of the logarithm.
inline std::vector<ParameterEntry> parameters_of_rate() {
  ParameterEntry exponent{
      "Rate exponent",
      {"m"},
      Dimension::none,
      "m, power of the strain rate that the growth comes to at fast rates; 0: the logarithm.",
      "0",
      below_one};
  exponent.optional = true;
  return {yield_stress_parameter(),
          hardening_modulus_parameter(),
          {"Rate sensitivity",
           {"C"},
           Dimension::none,
           "C, growth of the yield stress by e times the strain rate, as a part of it; 0: none."},
          exponent,
          {"Creep time",
           {"t0"},
           Dimension::time,
           "One over the strain rate from which on the yield stress grows; 0: it does not.",
           "0 s"}};
}

inline const Registered<MaterialDeclaration> rate_dependent_law{
    {{"Rate dependent",
      "sigma_y = (Y + H alpha) [1 + C ((1 + t0 d alpha/dt)^m - 1)/m], C ln(1 + t0 d alpha/dt) for m = 0",
      "Johnson & Cook (1983), Camacho & Ortiz (1997); Cowper & Symonds (1957)",
      "creep of what has yielded, over some decades of time; Experiment/Load time and Hold time say how fast",
      parameters_of_rate()},
     [](const LawValues& values) -> MaterialLaw {
       return {values.at("Yield stress"), 0,
               std::make_shared<RateDependent>(values.at("Hardening modulus"), values.at("Rate sensitivity"),
                                               values.at("Creep time"), values.at("Rate exponent"))};
     },
     nullptr}};

}  // namespace asperity::fem

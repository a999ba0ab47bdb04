// Friction with a rate and a state: |t| <= p a asinh(V/(2 V0) exp((mu + b ln(V0 theta/L))/a)), which is p (mu
// + a ln(V/V0) + b ln(V0 theta/L)) above creeping rates and goes to zero with V (Rice, Lapusta & Ranjith
// 2001, J. Mech. Phys. Solids 49:1865). The state, the age of the contact, grows with time and is renewed by
// slip: d theta/dt = 1 - V theta/L (ageing law: Dieterich 1979, J. Geophys. Res. 84:2161; Ruina 1983, J.
// Geophys. Res. 88:10359), integrated exactly over a step of constant V. A point begins with an age of zero
// where it first touches. mu, a, b [-], V, V0 [m/s], theta [s], L [m], p [Pa].
#pragma once

#include <algorithm>
#include <cmath>

#include "fem/interface/friction/coulomb.h"

namespace asperity::fem {

/// Constants of the law, in SI units as its equation has them.
struct RateAndStateConstants {
  double coefficient = 0, direct = 0, evolution = 0;  ///< mu, a, b [-]
  double length = 0;                                  ///< L [m]
  double reference = 0;                               ///< V0 [m/s]
};

class RateAndState : public FrictionLaw {
 public:
  explicit RateAndState(const RateAndStateConstants& constants) : c_(constants) {}

  ShearLimit limit(const InterfacePoint& point, const double* history) const override {
    const double coefficient = friction(point.slip_rate, age(point, history[0]));
    return {coefficient * point.pressure, coefficient};
  }
  bool resists_by_rate() const override { return true; }
  double steepest_fall(double pressure) const override {
    return std::max(0.0, c_.evolution - c_.direct) * pressure / c_.length;
  }
  std::vector<std::string> history() const override { return {"contact_age"}; }
  void remember(const InterfacePoint& point, double* history) const override {
    history[0] = point.pressure > 0 ? age(point, history[0]) : 0;
  }
  /// At the reference speed, steady.
  ShearLimit initial_limit(double pressure) const override {
    return {c_.coefficient * pressure, c_.coefficient};
  }

  /// Coefficient of friction [-] at a rate V [m/s] and an age theta [s].
  double friction(double rate, double age) const {
    if (!(rate > 0) || !(age > 0)) return 0;
    const double y = std::log(rate / c_.reference) +
                     (c_.coefficient + c_.evolution * std::log(c_.reference * age / c_.length)) / c_.direct;
    // asinh(exp(y)/2) without overflow.
    const double value =
        y > 0 ? y + std::log(0.5 * (1 + std::sqrt(1 + 4 * std::exp(-2 * y)))) : std::asinh(0.5 * std::exp(y));
    return c_.direct * value;
  }

 private:
  /// At the end of a step [s].
  double age(const InterfacePoint& point, double before) const {
    const double x = point.slip_rate * point.time_step / c_.length;
    constexpr double tiny = 1e-12;
    const double grown = x > tiny ? -std::expm1(-x) / x : 1;
    return before * std::exp(-x) + point.time_step * grown;
  }

  RateAndStateConstants c_;
};

inline const Registered<FrictionLawDeclaration> rate_and_state_law{
    {{"Rate and state",
      "|t| <= p a asinh(V/(2 V0) exp((mu + b ln(V0 theta/L))/a)), d theta/dt = 1 - V theta/L",
      "Dieterich (1979), Ruina (1983), Rice, Lapusta & Ranjith (2001)",
      "slow slip at known speeds (Experiment/Speed, Load time, Hold time); steps well below L; b - a below "
      "what "
      "the contact's stiffness follows",
      {Coulomb::parameter(),
       {"Direct effect",
        {"a"},
        Dimension::none,
        "a of rate-and-state friction: growth with the logarithm of the rate at once; 0: another law."},
       {"Evolution effect",
        {"b"},
        Dimension::none,
        "b of rate-and-state friction: growth with the logarithm of the age of the contact; 0: another law."},
       {"Renewal length",
        {"L"},
        Dimension::length,
        "Slip over which the contact is renewed (rate-and-state friction); 0: another law.",
        "0 m"},
       {"Reference speed",
        {"V0"},
        Dimension::speed,
        "At which steady rate-and-state friction has the Friction coefficient; 0: another law.",
        "0 m/s"}}},
     [](const LawValues& values) -> std::unique_ptr<FrictionLaw> {
       RateAndStateConstants c;
       c.coefficient = values.at("Friction coefficient"), c.direct = values.at("Direct effect");
       c.evolution = values.at("Evolution effect"), c.length = values.at("Renewal length");
       c.reference = values.at("Reference speed");
       return std::make_unique<RateAndState>(c);
     }}};

}  // namespace asperity::fem

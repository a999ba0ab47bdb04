// Friction that is larger at rest and weakens with slip: |t| <= mu(s) p, mu(s) = mu + (mu_s - mu) exp(-s/d).
// s [m]: slip since the point last stuck. A point that sticks for a whole step, or opens, is at rest again,
// so that the peak comes back after each reversal and stop, as Rabinowicz (1951), J. Appl. Phys. 22:1373,
// measured it; what fades for good with the whole path is running-in. Exponential weakening: Ida (1972), J.
// Geophys. Res. 77:3796; Matsu'ura et al. (1992), Tectonophysics 211:135. mu, mu_s [-], d [m], p [Pa].
#pragma once

#include <cmath>

#include "core/error.h"
#include "fem/interface/friction/coulomb.h"

namespace asperity::fem {

class StaticPeak : public FrictionLaw {
 public:
  /// kinetic mu and at rest mu_s [-], length d [m]. Throws InputError where there is no peak.
  StaticPeak(double kinetic, double at_rest, double length)
      : kinetic_(kinetic), at_rest_(at_rest), length_(length) {
    if (at_rest < kinetic)
      throw InputError(
          "Interface/Static friction coefficient is below Friction coefficient; raise it, or use Run-in "
          "friction coefficient for friction that grows with the path");
  }
  ShearLimit limit(const InterfacePoint& point, const double* history) const override {
    const double coefficient =
        kinetic_ + (at_rest_ - kinetic_) * std::exp(-(history[0] + step_slip(point)) / length_);
    return {coefficient * point.pressure, coefficient};
  }
  std::vector<std::string> history() const override { return {"slip_since_stick"}; }
  void remember(const InterfacePoint& point, double* history) const override {
    const double slip = step_slip(point);
    history[0] = slip > 0 ? history[0] + slip : 0;
  }
  double steepest_fall(double pressure) const override { return (at_rest_ - kinetic_) * pressure / length_; }

 private:
  static double step_slip(const InterfacePoint& point) { return std::hypot(point.slip[0], point.slip[1]); }

  double kinetic_, at_rest_, length_;
};

inline const Registered<FrictionLawDeclaration> static_peak_law{
    {{"Static peak",
      "|t| <= mu(s) p, mu(s) = mu + (mu_s - mu) exp(-s/d), s: slip since the point last stuck",
      "Rabinowicz (1951), Ida (1972)",
      "steps well below d, and d above what the contact gives way elastically: below, friction jumps "
      "(stick-slip), which is refused",
      {Coulomb::parameter(),
       {"Static friction coefficient",
        {"mu_s"},
        Dimension::none,
        "Friction coefficient of a point that has stuck; 0: no static peak."},
       {"Friction decay length",
        {"d"},
        Dimension::length,
        "Slip over which the static peak fades to a share 1/e; 0: no static peak.",
        "0 m"}}},
     [](const LawValues& values) -> std::unique_ptr<FrictionLaw> {
       return std::make_unique<StaticPeak>(values.at("Friction coefficient"),
                                           values.at("Static friction coefficient"),
                                           values.at("Friction decay length"));
     }}};

}  // namespace asperity::fem

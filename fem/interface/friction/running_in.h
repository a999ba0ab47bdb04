// Friction that changes for good with the path: |t| <= mu(S) p, mu(S) = mu_r + (mu - mu_r) exp(-S/l). S [m]:
// slip path of the point on the particle since it first touched; reversals and stops do not take it back. mu
// of fresh surfaces may lie above (films that smooth) or below (films that wear off) mu_r of run-in ones.
// Blau (2005), Tribol. Int. 38:1007, sec. 2. mu, mu_r [-], l [m], p [Pa].
#pragma once

#include <algorithm>
#include <cmath>

#include "fem/interface/friction/coulomb.h"

namespace asperity::fem {

class RunningIn : public FrictionLaw {
 public:
  /// fresh mu and run-in mu_r [-], length l [m].
  RunningIn(double fresh, double run_in, double length) : fresh_(fresh), run_in_(run_in), length_(length) {}
  ShearLimit limit(const InterfacePoint& point, const double*) const override {
    const double coefficient = run_in_ + (fresh_ - run_in_) * std::exp(-point.slip_path / length_);
    return {coefficient * point.pressure, coefficient};
  }
  double steepest_fall(double pressure) const override {
    return std::max(0.0, fresh_ - run_in_) * pressure / length_;
  }

 private:
  double fresh_, run_in_, length_;
};

inline const Registered<FrictionLawDeclaration> running_in_law{
    {{"Running-in",
      "|t| <= mu(S) p, mu(S) = mu_r + (mu - mu_r) exp(-S/l), S: slip path of the point",
      "Blau (2005)",
      "the particle's surface changes and the substrate's does not, such as a coating of the particle",
      {Coulomb::parameter(),
       {"Run-in friction coefficient",
        {"mu_r"},
        Dimension::none,
        "Friction coefficient to which that of fresh surfaces goes with the slip path; 0: no running-in."},
       {"Running-in length",
        {"l"},
        Dimension::length,
        "Slip path over which the change that is left fades to a share 1/e; 0: no running-in.",
        "0 m"}}},
     [](const LawValues& values) -> std::unique_ptr<FrictionLaw> {
       return std::make_unique<RunningIn>(values.at("Friction coefficient"),
                                          values.at("Run-in friction coefficient"),
                                          values.at("Running-in length"));
     }}};

}  // namespace asperity::fem

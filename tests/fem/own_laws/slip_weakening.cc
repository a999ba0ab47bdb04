// A law of friction from outside of the program: its limit falls with the slip, mu = mu_s - (mu_s - mu_k)
// min(1, s/d). Ida (1972).
#include <algorithm>
#include <cmath>

#include "fem/interface/friction/coulomb.h"

namespace asperity::fem {
namespace {

class SlipWeakening : public FrictionLaw {
 public:
  explicit SlipWeakening(const LawValues& values)
      : at_rest_(values.at("Friction coefficient")),
        kinetic_(values.at("Kinetic friction coefficient")),
        distance_(values.at("Weakening distance")) {}

  ShearLimit limit(const InterfacePoint& point, const double* history) const override {
    const double coefficient = at_rest_ - (at_rest_ - kinetic_) * weakened(point, history[0]);
    return {coefficient * point.pressure, coefficient};
  }
  std::vector<std::string> history() const override { return {"weakened"}; }
  void remember(const InterfacePoint& point, double* history) const override {
    history[0] = weakened(point, history[0]);
  }

 private:
  double weakened(const InterfacePoint& point, double before) const {
    return std::min(1.0, before + std::hypot(point.slip[0], point.slip[1]) / distance_);
  }

  double at_rest_, kinetic_, distance_;
};

ParameterEntry kinetic_coefficient() {
  ParameterEntry parameter{"Kinetic friction coefficient", {"mu_k"}};
  parameter.documentation = "Friction coefficient that is left after the Weakening distance.";
  parameter.optional = true;
  return parameter;
}

const Registered<FrictionLawDeclaration> slip_weakening_law{
    {{"Slip weakening",
      "|t| <= (mu - (mu - mu_k) min(1, s/d)) p",
      "Ida (1972)",
      "slip that goes on",
      {Coulomb::parameter(),
       kinetic_coefficient(),
       {"Weakening distance",
        {"d"},
        Dimension::length,
        "Slip over which friction falls to its kinetic coefficient; 0: it does not.",
        "0 m"}}},
     [](const LawValues& values) -> std::unique_ptr<FrictionLaw> {
       return std::make_unique<SlipWeakening>(values);
     }}};

}  // namespace
}  // namespace asperity::fem

// A material from outside of the program: its yield stress grows by a power of the plastic strain, sigma_y =
// Y (1 + alpha/e)^n. Swift (1952).
#include <cmath>

#include "fem/materials/material_law.h"

namespace asperity::fem {
namespace {

class SwiftHardening : public Hardening {
 public:
  explicit SwiftHardening(const LawValues& values)
      : yield_(values.at("Yield stress")),
        strain_(values.at("Swift strain")),
        exponent_(values.at("Swift exponent")) {}

  FlowStress flow(const YieldingPoint& point) const override {
    const double grown = 1 + point.alpha / strain_, stress = point.initial * std::pow(grown, exponent_);
    return {stress, exponent_ * stress / (strain_ * grown)};
  }
  double stored_energy(double alpha) const override {
    return yield_ * (strain_ / (exponent_ + 1) * (std::pow(1 + alpha / strain_, exponent_ + 1) - 1) - alpha);
  }

 private:
  double yield_, strain_, exponent_;
};

const Registered<MaterialDeclaration> swift_law{
    {{"Swift",
      "sigma_y = Y (1 + alpha/e)^n",
      "Swift (1952)",
      "metals far beyond yield",
      {yield_stress_parameter(),
       {"Swift strain",
        {"e"},
        Dimension::none,
        "Plastic strain over which the yield stress begins to grow; 0: another law."},
       {"Swift exponent",
        {"n"},
        Dimension::none,
        "Power by which the yield stress grows; 0: another law.",
        "0",
        {0, 1, false, false}}}},
     [](const LawValues& values) -> MaterialLaw {
       return {values.at("Yield stress"), 0, std::make_shared<SwiftHardening>(values)};
     },
     nullptr}};

}  // namespace
}  // namespace asperity::fem

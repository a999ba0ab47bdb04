// Linear hardening, isotropic or kinematic (Prager 1956), and isotropic hardening that saturates (Voce 1955),
// together: sigma_y = Y + H alpha + Q (1 - exp(-b alpha)). All of it isotropic hardening stores is taken for
// stored, as that of the back stress is.
#pragma once

#include <cmath>

#include "core/quantity.h"
#include "fem/materials/material_law.h"

namespace asperity::fem {

class LinearAndVoce : public Hardening {
 public:
  /// modulus: H [Pa]; saturation: Q [Pa]; rate: b [-].
  explicit LinearAndVoce(double modulus, double saturation = 0, double rate = 0)
      : modulus_(modulus), saturation_(saturation), rate_(rate) {}

  FlowStress flow(const YieldingPoint& point) const override {
    const double left = std::exp(-rate_ * point.alpha);
    return {point.initial + modulus_ * point.alpha + saturation_ * (1 - left),
            modulus_ + saturation_ * rate_ * left};
  }
  double stored_energy(double alpha) const override {
    const double voce = rate_ > 0 ? saturation_ * (alpha + (std::exp(-rate_ * alpha) - 1) / rate_) : 0;
    return 0.5 * modulus_ * alpha * alpha + voce;
  }
  bool is_linear() const override { return rate_ == 0; }

  /// Entries of the case file.
  static std::vector<ParameterEntry> parameters() {
    std::vector<ParameterEntry> all{
        yield_stress_parameter(),
        hardening_modulus_parameter(),
        {"Hardening",
         {},
         Dimension::none,
         "Whether the linear hardening widens the yield surface or shifts it (Prager).",
         "isotropic"},
        {"Voce saturation",
         {"Q"},
         Dimension::pressure,
         "Q of Voce's hardening Q (1 - exp(-b eps_p)), added to the yield stress.",
         "0 Pa"},
        {"Voce rate", {"b"}, Dimension::none, "b of Voce's hardening."}};
    all[2].words = {"isotropic", "kinematic"};
    for (std::size_t k = 1; k < all.size(); ++k) all[k].optional = true;
    return all;
  }
  /// From the values of all parameters.
  static MaterialLaw make(const LawValues& values) {
    const double modulus = values.at("Hardening modulus"), kinematic = values.at("Hardening");
    return {values.at("Yield stress"), kinematic * modulus,
            std::make_shared<LinearAndVoce>((1 - kinematic) * modulus, values.at("Voce saturation"),
                                            values.at("Voce rate"))};
  }
  /// youngs_modulus [Pa]; why these values cannot be meant, empty if they can.
  static MaterialObjection objection(double youngs_modulus, const LawValues& values) {
    const bool saturates = values.at("Voce saturation") > 0;
    if (saturates != (values.at("Voce rate") > 0))
      return {saturates ? "Voce saturation" : "Voce rate",
              "'s Voce hardening needs both Voce saturation and Voce rate above 0; set both or neither"};
    if (values.at("Hardening modulus") >= youngs_modulus)
      return {"Hardening modulus", "'s Hardening modulus must be less than its Young modulus of " +
                                       format_quantity(youngs_modulus, Dimension::pressure)};
    return {};
  }

 private:
  double modulus_, saturation_, rate_;
};

inline const Registered<MaterialDeclaration> linear_and_voce_law{
    {{"Linear and Voce",
      "sigma_y = Y + H alpha + Q (1 - exp(-b alpha)), beta = (2/3) H e_p where H is kinematic",
      "Prager (1956), Voce (1955)", "small strain, metals at one rate and temperature",
      LinearAndVoce::parameters()},
     LinearAndVoce::make,
     LinearAndVoce::objection}};

}  // namespace asperity::fem

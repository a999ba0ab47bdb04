// Liquid that condenses from humid air between the surfaces: constant suction s = gamma/r_K out to the gap h0
// = 2 r_K cos(theta) that a meniscus of the radius of Kelvin spans, r_K = gamma V_m/(R T ln(1/RH)). Work of
// adhesion 2 gamma cos(theta): Dugdale's law with these numbers, its end a ramp as there. Thomson (1871);
// Israelachvili (2011), Intermolecular and Surface Forces, ch. 17; Maugis & Gauthier-Manuel (1994), J. Adhes.
// Sci. Technol. 8:1311. gamma [N/m], theta [rad], V_m [m^3/mol], T [K], RH [-]. Both surfaces have the same
// contact angle. The meniscus is in equilibrium with the vapour at all times: slow motion.
//
// Condensation = on contact: no bridge forms across a gap; one that formed where the surfaces touched breaks
// when the gap leaves h0.
#pragma once

#include <cmath>

#include "fem/interface/adhesion/dugdale.h"

namespace asperity::fem {

/// Of a case's entries, in SI units.
class KelvinMeniscus {
 public:
  explicit KelvinMeniscus(const LawValues& values)
      : tension_(values.at("Surface tension")),
        cosine_(std::cos(values.at("Contact angle"))),
        radius_(tension_ * values.at("Molar volume") /
                (gas_constant * values.at("Temperature") * -std::log(values.at("Relative humidity")))) {}

  /// r_K [m].
  double radius() const { return radius_; }
  /// Gap that it spans [m].
  double height() const { return 2 * radius_ * cosine_; }
  /// Of adhesion, 2 gamma cos(theta) [J/m^2].
  double work() const { return 2 * tension_ * cosine_; }
  static constexpr double gas_constant = 8.314462618;  ///< [J/(mol K)]

 private:
  double tension_, cosine_, radius_;
};

/// What a bridge takes from a case file.
inline std::vector<ParameterEntry> capillary_entries() {
  ParameterEntry humidity{"Relative humidity", {"RH"}};
  humidity.documentation = "Vapour over saturated vapour of the liquid that condenses (capillary bridges).";
  humidity.range = {0, 1, false, true};
  humidity.if_missing = "give the humidity of the air, e.g. Relative humidity = 50 %";
  ParameterEntry tension{"Surface tension", {"gamma"}, Dimension::surface_energy};
  tension.documentation = "Of the liquid that condenses.", tension.default_text = "72.8 mN/m";
  ParameterEntry angle{"Contact angle", {"theta"}, Dimension::angle};
  angle.documentation = "Of the liquid on both surfaces, below 90 deg.", angle.default_text = "0 rad";
  angle.range = {0, M_PI / 2, false, true};
  ParameterEntry volume{"Molar volume", {"V_m"}, Dimension::molar_volume};
  volume.documentation = "Of the liquid that condenses.", volume.default_text = "18.05 cm^3/mol";
  ParameterEntry temperature{"Temperature", {"T"}, Dimension::temperature};
  temperature.documentation = "Of the vapour.", temperature.default_text = "293.15 K";
  for (auto* entry : {&tension, &volume, &temperature}) entry->range = positive;
  ParameterEntry condensation{"Condensation", {}};
  condensation.documentation =
      "Whether bridges form across gaps that they span, or only where surfaces have touched (adhesion "
      "hysteresis).";
  condensation.default_text = "across gaps", condensation.words = {"across gaps", "on contact"};
  for (auto* entry : {&tension, &angle, &volume, &temperature, &condensation}) entry->optional = true;
  return {humidity, tension, angle, volume, temperature, condensation};
}

inline const Registered<AdhesionLawDeclaration> capillary_bridge_law{
    {{"capillary",
      "s(g) = gamma/r_K for g < 2 r_K cos(theta), r_K = gamma V_m/(R T ln(1/RH)); w = 2 gamma cos(theta)",
      "Thomson (1871), Israelachvili (2011) ch. 17, Maugis & Gauthier-Manuel (1994)",
      "menisci in equilibrium with the vapour, far smaller than the sphere: humidities of some 10 to 90 %",
      capillary_entries()},
     "gamma/r_K out to 2 r_K cos(theta)",
     [](double work, const LawValues& values) -> std::unique_ptr<AdhesionLaw> {
       return std::make_unique<Dugdale>(work, KelvinMeniscus(values).height());
     },
     [](const LawValues& values) -> AdhesionWork {
       const double work = KelvinMeniscus(values).work();
       return {values.at("Condensation") == 0 ? work : 0, work};
     }}};

}  // namespace asperity::fem

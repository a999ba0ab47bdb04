// Electrostatic attraction of surfaces whose potential varies from patch to patch: mean stress over the
// patches s(z) = eps0 V^2 k^2 / (2 sinh^2(k z)), k = pi/L, at the electrical distance z = d + g. V [V]: rms
// of the difference of potential; L [m]: size of a patch (half a wave); d [m]: thickness of the insulating
// films between the charges of surfaces in contact, over their permittivity, which bounds the stress. For
// gaps far below L it is the plate capacitor's eps0 V^2/(2 z^2), beyond L it falls exponentially. Laplace's
// equation between plates; Speake & Trenkel (2003), Phys. Rev. Lett. 90:160403. Mean: patches are far smaller
// than the contact's surroundings, which the meshed contact region must hold.
#pragma once

#include <cmath>

#include "fem/interface/adhesion_law.h"

namespace asperity::fem {

class PatchPotentials : public AdhesionLaw {
 public:
  /// work [J/m^2] from contact, size L and film d [m].
  PatchPotentials(double work, double size, double film)
      : wave_number_(M_PI / size), film_(film), scale_(work / left(film)) {}

  Attraction at(double gap) const override {
    const double x = wave_number_ * (film_ + gap), s = std::sinh(x);
    if (!std::isfinite(s)) return {0, 0, 0};
    const double stress = scale_ * wave_number_ / (s * s);
    return {stress, -2 * stress * wave_number_ / std::tanh(x), scale_ * left(film_ + gap)};
  }
  /// Where 1e-4 of the work is left.
  double range() const override {
    constexpr double share = 1e-4;
    return std::log1p(std::expm1(2 * wave_number_ * film_) / share) / (2 * wave_number_) - film_;
  }
  /// From contact [J/m^2]. potential V [V], size L and film d [m].
  static double work(double potential, double size, double film) {
    const double k = M_PI / size;
    return 0.5 * permittivity * potential * potential * k * 2 / std::expm1(2 * k * film);
  }
  static constexpr double permittivity = 8.8541878128e-12;  ///< eps0 [F/m]

 private:
  /// coth(k z) - 1 [-], at a distance z [m].
  double left(double z) const { return 2 / std::expm1(2 * wave_number_ * z); }

  double wave_number_, film_, scale_;
};

/// What patches take from a case file.
inline std::vector<ParameterEntry> patch_entries() {
  ParameterEntry potential{"Patch potential", {"V"}, Dimension::voltage};
  potential.documentation =
      "Difference of the surfaces' electrical potential, root mean square over patches.";
  potential.default_text = "0 V", potential.if_missing = "give it, e.g. Patch potential = 100 mV";
  ParameterEntry size{"Patch size", {"L"}, Dimension::length};
  size.documentation = "Of patches of one potential: half a wave; far above all gaps for uniform surfaces.";
  size.default_text = "0 m", size.if_missing = "give it, e.g. Patch size = 100 nm";
  ParameterEntry film{"Insulating film", {"d"}, Dimension::length};
  film.documentation =
      "Thickness over relative permittivity of what separates the charges of surfaces in contact: the "
      "electrical distance at no gap.";
  film.default_text = "0 m", film.if_missing = "give it, e.g. Insulating film = 1 nm";
  return {potential, size, film};
}

inline const Registered<AdhesionLawDeclaration> patch_potentials_law{
    {{"patch_potentials",
      "s(g) = eps0 V^2 k^2/(2 sinh^2(k (d + g))), k = pi/L: eps0 V^2/(2 (d + g)^2) for d + g << L",
      "Speake & Trenkel (2003)", "conductors and charged films; gaps within the meshed contact region",
      patch_entries()},
     "eps0 V^2/(2 (d + g)^2) until it falls exponentially beyond L",
     [](double work, const LawValues& values) -> std::unique_ptr<AdhesionLaw> {
       return std::make_unique<PatchPotentials>(work, values.at("Patch size"), values.at("Insulating film"));
     },
     [](const LawValues& values) -> AdhesionWork {
       const double work = PatchPotentials::work(values.at("Patch potential"), values.at("Patch size"),
                                                 values.at("Insulating film"));
       return {work, work};
     }}};

}  // namespace asperity::fem

// Adhesion that takes more work on separation than it gave on approach: Dugdale's constant stress with a
// pinned edge (equations and source: pinned_dugdale.h). The contact forms at delta = 0; the edge of what has
// been in contact stays where it is on unloading until the attraction has come down to it, and again under a
// further load until the contact reaches it. It breaks beyond delta < 0. SI units.
#pragma once

#include "dem_compare/laws/law_registry.h"
#include "dem_compare/laws/maugis_units.h"
#include "dem_compare/laws/normal_state.h"

namespace asperity {

struct AdhesionHysteresisLaw {
  double reduced_modulus = 0;     ///< E* [Pa]
  double radius = 0;              ///< R [m]
  double work_of_separation = 0;  ///< w_o [J/m^2], both surfaces together
  double closing_ratio = 0;       ///< w_c/w_o, at most 1 [-]
  double range = 0;               ///< h0 of the attraction [m]

  /// Maugis' parameter of w_o [-]; at most 100, which is JKR's limit.
  double lambda() const;
  /// Largest tension under a dead load once it was pressed far enough [N].
  double pull_off_force() const;
  /// The stiffness is that of going on in the direction of the last step.
  NormalState advance(const NormalState& before, double approach) const;
  /// On first loading; throws InputError for a tension that this does not carry.
  double approach(double force) const;

 private:
  MaugisUnits units() const { return {reduced_modulus, radius, work_of_separation}; }
};

inline const LawEntry<AdhesionHysteresisLaw, NormalMode> adhesion_hysteresis_entry{
    {"adhesion_hysteresis",
     "f_n = a^3 - lambda [k (a S(c) + c^2 t(c)) + (1 - k) (a S(b) + b^2 t(b))], delta = a^2 - 4/3 lambda [k "
     "S(c) + (1 - k) S(b)], S(x) = (x^2 - a^2)^(1/2), t(x) = arccos(a/x), k = w_c/w_o, a <= b <= c; Maugis' "
     "units of w_o",
     "after Maugis 1992; Maugis & Barquins 1978",
     "any Tabor parameter; smooth, elastic, a << R; quasi-static, no attraction before first touch"},
    {{{"reduced_modulus", "Pa", "E*"}, &AdhesionHysteresisLaw::reduced_modulus},
     {{"radius", "m", "R"}, &AdhesionHysteresisLaw::radius},
     {{"work_of_separation", "J/m^2", "w_o spent on opening, of both surfaces together"},
      &AdhesionHysteresisLaw::work_of_separation},
     {{"closing_ratio", "", "w_c/w_o, what closing gives over that", 1e-3, 1},
      &AdhesionHysteresisLaw::closing_ratio},
     {{"range", "m", "h0, the gap across which surfaces attract each other"},
      &AdhesionHysteresisLaw::range}}};

}  // namespace asperity

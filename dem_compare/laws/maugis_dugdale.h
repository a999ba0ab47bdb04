// Adhesive contact between JKR's and DMT's limits: a constant stress s0 attracts across the gap around the
// contact out to the radius m a (Maugis 1992, J. Colloid Interface Sci. 150:243). With K = 4 E*/3, lengths
// over (pi w R^2/K)^(1/3), forces over pi w R, approaches over (pi^2 w^2 R/K^2)^(1/3), lambda = 2 s0 (R/(pi w
// K^2))^(1/3), u = (m^2 - 1)^(1/2), t = arctan u:
//   1 = (lambda a^2/2) [u + (m^2 - 2) t] + (4 lambda^2 a/3) [u t - m + 1]
//   f_n = a^3 - lambda a^2 (u + m^2 t),   delta = a^2 - (4/3) lambda a u.
// lambda > 5 is JKR's range, lambda < 0.1 DMT's. The paper's spheres have lambda of 1 to 2. The contact forms
// at delta = 0 and breaks where d(delta)/da = 0, or at a = 0; attraction before first touch is left out. SI
// units.
#pragma once

#include "dem_compare/laws/law_registry.h"
#include "dem_compare/laws/maugis_units.h"
#include "dem_compare/laws/normal_state.h"

namespace asperity {

struct MaugisDugdale {
  double reduced_modulus = 0;   ///< E* [Pa]
  double radius = 0;            ///< R [m]
  double work_of_adhesion = 0;  ///< w [J/m^2], both surfaces together
  double cohesive_stress = 0;   ///< s0 [Pa]; 1.03 w/z0 for the Lennard-Jones distance z0

  /// Maugis' parameter [-]: JKR's limit where large, DMT's where small.
  double lambda() const;
  /// Largest tension under a dead load [N].
  double pull_off_force() const;
  NormalState advance(const NormalState& before, double approach) const;
  /// Throws InputError for a force beyond pull-off.
  double approach(double force) const;

 private:
  MaugisUnits units() const { return {reduced_modulus, radius, work_of_adhesion}; }
};

inline const LawEntry<MaugisDugdale, NormalMode> maugis_dugdale_entry{
    {"maugis_dugdale",
     "f_n = a^3 - lambda a^2 (u + m^2 t), delta = a^2 - 4/3 lambda a u, 1 = lambda a^2/2 [u + (m^2 - 2) t] + "
     "4/3 lambda^2 a [u t - m + 1], u = (m^2 - 1)^(1/2) = tan t; Maugis' units",
     "Maugis 1992", "any Tabor parameter; smooth, elastic, a << R; no attraction before first touch"},
    {{{"reduced_modulus", "Pa", "E*"}, &MaugisDugdale::reduced_modulus},
     {{"radius", "m", "R"}, &MaugisDugdale::radius},
     {{"work_of_adhesion", "J/m^2", "w of both surfaces together"}, &MaugisDugdale::work_of_adhesion},
     {{"cohesive_stress", "Pa", "s0, 1.03 w/z0"}, &MaugisDugdale::cohesive_stress}}};

}  // namespace asperity

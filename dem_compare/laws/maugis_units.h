// Maugis' units of an adhesive contact (1992, J. Colloid Interface Sci. 150:243), with K = 4 E*/3: lengths
// along the surface over (pi w R^2/K)^(1/3), forces over pi w R, approaches over (pi^2 w^2 R/K^2)^(1/3). SI
// units.
#pragma once

#include <cmath>

namespace asperity {

struct MaugisUnits {
  double reduced_modulus = 0;   ///< E* [Pa]
  double radius = 0;            ///< R [m]
  double work_of_adhesion = 0;  ///< w of both surfaces together [J/m^2]

  double length() const { return std::cbrt(force() * radius / stiffness()); }  ///< [m]
  double force() const { return M_PI * work_of_adhesion * radius; }            ///< [N]
  double approach() const { return length() * length() / radius; }             ///< [m]
  /// Maugis' parameter [-] of a cohesive stress [Pa].
  double lambda(double stress) const {
    return 2 * stress * std::cbrt(radius / (M_PI * work_of_adhesion * stiffness() * stiffness()));
  }

 private:
  double stiffness() const { return 4.0 / 3 * reduced_modulus; }
};

}  // namespace asperity

// Torsion of a Hertzian contact with partial slip at constant load: an annulus c < r < a slips, the rest
// sticks (Lubkin 1951; Deresiewicz 1954; Johnson 1985, sec. 7.3). With k'^2 = 1 - x^2 and I(x) = K(k') -
// E(k'), x = c/a:
//   theta = 3 mu P/(4 pi Gt a^2) I(x),   M = (4 mu P a/pi) [x^3 I(x) + 3 int_x^1 y^2 I(y) dy],   full slip 3
//   pi mu P a/16.
// Full slip takes an infinite angle. Unloading and reloading after Masing's rule (Deresiewicz 1954): each
// branch is the virgin curve at twice the size, from the point of reversal. Constant normal load and no
// sliding beside it. SI units.
#pragma once

#include "dem_compare/laws/hertzian_torsion.h"
#include "dem_compare/laws/law_registry.h"

namespace asperity {

struct LubkinTorsion {
  double torsion_modulus = 0;  ///< Gt [Pa]
  double coefficient = 0;      ///< mu of sliding [-]
  double normal_force = 0;     ///< P [N]
  double contact_radius = 0;   ///< a [m]

  /// Twist and moment of the virgin curve where the part c/a of the contact sticks, 0 < c/a <= 1.
  double angle_at(double stick_ratio) const;
  double moment_at(double stick_ratio) const;
  double full_slip_moment() const {
    return full_slip_torsion_moment(coefficient, normal_force, contact_radius);
  }
  /// Virgin curve; odd in its argument. Throws InputError for a moment at or beyond full slip.
  double angle(double moment) const;
  double moment(double angle) const;
  /// On a branch that left (moment, angle) = (moment_0, angle_0).
  double angle_after_reversal(double moment, double reversal_moment, double reversal_angle) const {
    return reversal_angle + 2 * angle((moment - reversal_moment) / 2);
  }
  double moment_after_reversal(double angle, double reversal_angle, double reversal_moment) const {
    return reversal_moment + 2 * this->moment((angle - reversal_angle) / 2);
  }
};

/// The curve in a contact: Masing's rule at every turn, a loop that closes wiped out. The moment follows from
/// the angles alone, with the load and the radius of the moment.
struct PartialSlipTorsion {
  double torsion_modulus = 0;      ///< Gt [Pa]
  double sliding_coefficient = 0;  ///< mu [-]
  static constexpr LengthScale length = LengthScale::contact_radius;

  double limit(const NormalState& normal, double) const;
  TorsionHistory advance(const TorsionHistory& before, const NormalState& normal, double lever,
                         double increment) const;
};

inline const LawEntry<PartialSlipTorsion, TorsionMode> lubkin_torsion_entry{
    {"lubkin_torsion",
     "theta = 3 mu P/(4 pi Gt a^2) I(x), M = (4 mu P a/pi)[x^3 I(x) + 3 int_x^1 y^2 I(y) dy], I = K(k') - "
     "E(k'), k'^2 = 1 - x^2, x = c/a",
     "Lubkin 1951; Deresiewicz 1954; Johnson 1985, sec. 7.3",
     "constant normal load, no sliding beside the twist"},
    {{{"torsion_modulus", "Pa", "Gt"}, &PartialSlipTorsion::torsion_modulus},
     {{"sliding_coefficient", "", "mu of sliding"}, &PartialSlipTorsion::sliding_coefficient}}};

}  // namespace asperity

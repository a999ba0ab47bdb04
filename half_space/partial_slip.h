// Partial slip of a contact that is shifted along its plane under a pressure that does not change: each cell
// sticks, or slips under its largest shear traction in that direction.
//
// Of a step, with s the slip so far and u the shift, the tractions are those of least energy q.Kq/2 - q.(u -
// s) under |q| <= limit; what is left, u - Kq, is the slip afterwards, and its change points along q where
// cells slip (the implicit step of associated slip along the plane; Duvaut & Lions 1976). Found by projected
// gradients with momentum (Beck & Teboulle 2009, SIAM J. Imaging Sci. 2, 183), which begin anew where the
// energy would rise (O'Donoghue & Candes 2015, Found. Comput. Math. 15, 715).
#pragma once

#include "half_space/stuck_contact.h"

namespace asperity::half_space {

/// What a contact holds and has slipped.
struct SlipState {
  Shears traction;                  ///< [Pa]
  Shears slip;                      ///< of the bodies against each other, of each cell that touches [m]
  double force_x = 0, force_y = 0;  ///< sum of the tractions [N]
  double dissipated = 0;            ///< by slip, since the first state [J]
  double slipping = 0;              ///< share of the touching cells that are at their limit [-]
  int iterations = 0;
};

class PartialSlip {
 public:
  /// contact: kept by the caller; limit: largest shear traction of each cell, 0 where nothing touches [Pa].
  /// Throws InputError where sizes do not fit or a limit is negative.
  PartialSlip(const StuckContact& contact, Field limit);

  /// Nothing has moved.
  SlipState at_rest() const;
  /// After a shift to (x, y) from where `before` is [m]. Throws WorkError where the iteration does not end.
  SlipState shifted(const SlipState& before, double x, double y) const;

  /// Sum of the limits: the force where all slips [N].
  double full_slip() const { return full_slip_; }

 private:
  void project(Shears& traction) const;
  void measure(SlipState& state, const SlipState& before, double x, double y) const;

  const StuckContact& contact_;
  Field limit_;
  double full_slip_ = 0, step_ = 0;  ///< of the gradients: over the largest eigenvalue of K
};

}  // namespace asperity::half_space

// Luding's law (2008) of a record in the terms that engines share: k1, k_p, k_c, and the dimensionless
// plasticity depth phi_f of delta_p = k_p/(k_p - k1) phi_f 2 R_e. SI units.
#pragma once

#include <string>

#include "engines/input_notes.h"

namespace asperity {

struct LudingNumbers {
  double k1 = 0, kp = 0, kc = 0;  ///< [N/m]
  double phi = 0;                 ///< phi_f [-]
  double lateral = 0;             ///< k_l [N/m], constant
  double sliding = 0;             ///< mu of |f_l| <= mu F
};

/// With their lines in the header; throws InputError for a record without them. `names`: of k1, k_p, k_c,
/// phi_f in the engine.
LudingNumbers luding_numbers(InputNotes& notes, const std::string (&names)[4]);

/// The record's member, in SI. Throws InputError that says which case tells it where there is none.
double elastoplastic_number(const InputNotes& notes,
                            std::optional<EffectiveQuantity> ContactParameters::*member);

}  // namespace asperity

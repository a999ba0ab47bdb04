// A contact that attracts, as finite elements say: the reduced law plus the difference of the forces at a
// displacement,
//   f(d; p) = f_reduced(d; p) + [f_FE(d; p_k) - f_reduced(d; p_k)],
// because a displacement at a force is not unique where the contact is pulled. It opens where the solution
// does. SI units.
#pragma once

#include <memory>

#include "diagnosis/forward/forward_model.h"
#include "diagnosis/mechanics/mechanics.h"

namespace asperity {

/// The difference of a solution driven by displacement to a reduced law without instruments: on loading and
/// on unloading, or where the contact comes back as it went, of both together. Throws WorkError where the
/// solution never presses.
std::shared_ptr<const BranchCorrection> attraction_of(const SolvedResponse& solved, const Mechanics& reduced,
                                                      double displacement_error,
                                                      bool returns_on_another_curve);

}  // namespace asperity

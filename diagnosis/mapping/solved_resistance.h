// Sliding, rolling and torsion by finite elements beside the reduced law: at a few of the recorded loads the
// case is pressed and slid or spun from rest until all of it slips, or rolled until its resistance is steady,
// and the law is corrected by
//   T(f; p) = T_reduced(f; p) [1 + D(f)/T_reduced(f; p_k)],  D = T_FE(f; p_k) - T_reduced(f; p_k),
//   k_l(f) = k_reduced(f) [k_FE/k_reduced](f),
// or, where what was solved may all be the mesh's, by D itself, added; D as a share of load, contact area (of
// rolling: contact radius, of torsion: radius times load) and a force between these loads, the ratio straight
// in ln f (output space mapping, Echeverría & Hemker 2005). Where the recording varies the roughness of the
// substrate, each surface is solved. A recorded sphere that rolls under a plate has two contacts, and the
// force is the mean of both (lateral_limit.h): the case stands for either. SI units.
#pragma once

#include <memory>
#include <vector>

#include "diagnosis/fit/model_fit.h"
#include "diagnosis/forward/forward_model.h"

namespace asperity {

/// Largest part by which a motion's resistance is off, as stated [-].
double resistance_error(const std::vector<SolvedMotion>& motions);

/// Share of the load that a rolling law begins with, so that with what the case attracts by it comes near the
/// solutions [-].
double rolling_coefficient(const std::vector<SolvedMotion>& motions, const Mechanics& attraction);

/// The difference to the motions, for the reduced law `reduced`: a contact without instruments.
std::shared_ptr<const BranchCorrection> resistance_difference_to(const std::vector<SolvedMotion>& motions,
                                                                 const Mechanics& reduced);

}  // namespace asperity

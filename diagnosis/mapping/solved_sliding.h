// Sliding by finite elements beside the reduced law: at a few of the recorded loads the case is pressed and
// slid from rest until all of it slips, and the law is corrected by
//   T(f; p) = T_reduced(f; p) [1 + D(f)/T_reduced(f; p_k)],  D = T_FE(f; p_k) - T_reduced(f; p_k),
//   k_l(f) = k_reduced(f) [k_FE/k_reduced](f),
// D as a share of load, contact area and a force between these loads, the ratio straight in ln f (output
// space mapping, Echeverría & Hemker 2005). Where the recording varies the roughness of the substrate, each
// surface is solved. SI units.
#pragma once

#include <memory>
#include <vector>

#include "diagnosis/fit/model_fit.h"
#include "diagnosis/forward/forward_model.h"

namespace asperity {

/// Three of the recorded loads of each surface at most, the largest first, each with a path on which a
/// contact of this local friction slips as a whole. Throws InputError where nothing is pressed.
std::vector<SlidingProtocol> sliding_protocols_of(const FitProblem& problem, bool is_smooth);

/// Largest part by which a slide's friction is off, as stated [-].
double friction_error(const std::vector<SolvedSlide>& slides);

/// The difference to the slides, for the reduced law `reduced`: a contact without instruments.
std::shared_ptr<const BranchCorrection> friction_difference_to(const std::vector<SolvedSlide>& slides,
                                                               const Mechanics& reduced);

}  // namespace asperity

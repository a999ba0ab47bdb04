// Space mapping (Bandler et al. 1994), on the side of the output (Echeverría & Hemker 2005): the reduced law,
// quick and nearly right, plus the difference to a solution by finite elements where that was solved,
//   d(f; p) = d_reduced(f; p) + [d_FE(f; p_k) - d_reduced(f; p_k)]
// on the branch, loading or unloading, that the sample is on. At p = p_k it is the finite elements' own
// answer, with instruments around it as around any contact. SI units.
#pragma once

#include <memory>
#include <vector>

#include "diagnosis/fit/model_fit.h"
#include "diagnosis/forward/forward_model.h"

namespace asperity {

/// What a case is to be driven through: a solution for each group of runs whose largest forces are within
/// 5 %.
struct RecordedProtocols {
  std::vector<LoadingProtocol> list;  ///< the largest force first
  std::vector<std::size_t> of_run;    ///< index into `list`
  std::vector<std::size_t> peak;      ///< of each run: the sample with its largest load
};

/// Of a normal recording. Throws InputError where it is no trace.
RecordedProtocols protocols_of(const Samples& samples);

/// The difference to solutions, one for each protocol, for the reduced law `reduced`: a contact without
/// instruments.
std::shared_ptr<const BranchCorrection> difference_to(const std::vector<SolvedResponse>& solved,
                                                      const RecordedProtocols& protocols,
                                                      const Mechanics& reduced, const Samples& samples);

}  // namespace asperity

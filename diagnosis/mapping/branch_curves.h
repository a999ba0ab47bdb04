// Space mapping (Bandler et al. 1994), on the side of the output (Echeverría & Hemker 2005): the reduced law,
// quick and nearly right, plus the difference to a solution by finite elements where that was solved,
//   d(f; p) = d_reduced(f; p) + [d_FE(f; p_k) - d_reduced(f; p_k)]
// on the branch, loading or unloading, that the sample is on. At p = p_k it is the finite elements' own
// answer, with instruments around it as around any contact. SI units.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "diagnosis/fit/model_fit.h"
#include "diagnosis/forward/forward_model.h"

namespace asperity {

/// Where a sample lies: which solution's branch.
struct BranchPlace {
  std::size_t protocol = 0;  ///< index into RecordedProtocols::list
  bool unloading = false;    ///< below the largest load so far
};

/// What a case is to be driven through: a solution for each group of turning points whose forces are within
/// 5 %. A load above all former ones of its run is on the loading branch; what is below, on the unloading
/// branch of the largest so far, also where it is loaded again.
struct RecordedProtocols {
  std::vector<LoadingProtocol> list;   ///< the largest force first
  std::vector<BranchPlace> of_sample;  ///< by place in Samples::list
};

/// Of a normal recording. Throws InputError where it is no trace.
RecordedProtocols protocols_of(const Samples& samples);

/// Largest force up to which a protocol was solved, and how far it was unloaded again.
struct SolvedReach {
  double force = 0;       ///< [N]
  bool unloaded = false;  ///< to the end
};
SolvedReach reach_of(const SolvedResponse& solved);

/// The samples of which the solutions, one for each protocol, say something count; the others no longer do.
Samples solved_part(const Samples& samples, const RecordedProtocols& protocols,
                    const std::vector<SolvedResponse>& solved);

/// Errors of the displacement, each times a factor of unit variance, as mechanics.h has them: principal
/// components of the changes (all at the same forces), smooth in f^(2/3) between these, and last what the
/// zero may be off by.
struct SurfaceErrors {
  std::vector<std::function<double(double force)>> each;
  /// Their sum with factors [-], as one curve; asked for only where there are any.
  std::function<std::function<double(double force)>(const std::vector<double>& factors)> together;
};
SurfaceErrors surface_errors_of(const OtherSurfaces& surfaces);

/// The difference to solutions, one for each protocol, for the reduced law `reduced`: a contact without
/// instruments. `displacement_error`: of solutions that ended before they could state it [m];
/// `surface_errors`: as above.
std::shared_ptr<const BranchCorrection> difference_to(const std::vector<SolvedResponse>& solved,
                                                      const RecordedProtocols& protocols,
                                                      const Mechanics& reduced, double displacement_error,
                                                      SurfaceErrors surface_errors = {});

}  // namespace asperity

// Prediction of data that a fit has not seen: whole runs, cycles or blocks of load are left out in turn.
#pragma once

#include "diagnosis/fit/model_fit.h"

namespace asperity {

struct HeldOut {
  double chi2_reduced = 0;  ///< of all samples, each predicted by a fit without its block [-]
  double cost = 0;          ///< the same with Huber's costs, over the number of samples [-]
  bool consistent = true;   ///< the effects' parameters are the same whichever block is left out
  int blocks = 0;
  std::string block_name;  ///< "runs", "cycles", "rows", "blocks"
};

/// Blocks of the samples: index of each, and what they are.
struct Blocks {
  std::vector<int> of_sample;
  int count = 0;
  std::string name;
};
Blocks blocks_of(const Samples& samples);

/// Fits without each block and predicts it. Samples at a snap count as in fits (FitProblem::residual()).
/// off_by: what the law is off by, over the noise; parameters may differ between blocks by as much [-].
HeldOut predict_held_out(const FitProblem& problem, const ModelFit& fit, const Blocks& blocks,
                         double off_by = 1);

}  // namespace asperity

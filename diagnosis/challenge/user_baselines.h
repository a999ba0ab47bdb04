// Two things a user would try first on the residual of the calibrated simulation, each judged by predicting
// blocks of the data that it has not seen: a sparse regression on generic terms (products of the recorded
// channels up to the third degree, chosen one by one; in the spirit of Brunton, Proctor & Kutz 2016, with
// orthogonal matching pursuit and Schwarz' criterion), and a Gaussian process (Kennedy & O'Hagan 2001;
// Rasmussen & Williams 2006, ch. 2 and 5).
#pragma once

#include <string>
#include <vector>

#include "diagnosis/recording/recording.h"

namespace asperity {

/// Held-out reduced chi^2 of each [-].
struct UserBaselines {
  double simulation = 0;         ///< held-out reduced chi^2 of the calibrated simulation alone
  double sparse_regression = 0;  ///< with the regression's prediction of the residual
  double gaussian_process = 0;
  std::vector<std::string> terms;  ///< of the regression on all data
};

UserBaselines user_baselines(const Recording& recording);

}  // namespace asperity

// What mesh and load steps of finite elements may be off by, as a part of the response.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "diagnosis/fit/model_fit.h"

namespace asperity {

/// Standard deviation of one effect's law, of each sample; signed where all samples are off together.
using LawError = std::vector<double>;

/// What mesh and load steps of finite elements may be off by, as a part of the response, signed: one standard
/// deviation of each that they state (off_by_mesh_errors). Approach is off in proportion to the square of
/// spacing over contact radius, whose square is in proportion to the approach: by the same length at any
/// load.
std::vector<LawError> mesh_errors(const ModelFit& fit, const Samples& samples);

/// What is likely of the columns of B in a whitened residual, with coefficients of unit variance, by
/// reweighting (Huber).
struct LikelyPart {
  Eigen::VectorXd coefficients, left;
  double log_determinant = 0;  ///< of 1 + B^T B, weighted [-]
};
LikelyPart likely_part(const Eigen::MatrixXd& B, const Eigen::VectorXd& residual);

/// Coefficients of unit variance, together no longer than 999 of 1000 are by chance (chi-square).
Eigen::VectorXd of_likely_length(const Eigen::VectorXd& coefficients);

}  // namespace asperity

#include "diagnosis/fit/stated_errors.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

namespace asperity {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The response before a sensor reads it: one that saturates would mute errors, and gain by that.
std::vector<double> before_reading(const Explanation& explanation, const ModelFit& fit,
                                   const Samples& samples) {
  Mechanics m = explanation.mechanics(fit.values);
  m.normal.readings.clear();
  return simulate(m, samples);
}

}  // namespace

std::vector<LawError> mesh_errors(const ModelFit& fit, const Samples& samples) {
  const auto exact = before_reading(*fit.explanation, fit, samples);
  std::vector<LawError> errors;
  for (const auto& explanation : off_by_mesh_errors(fit)) {
    const auto off = before_reading(*explanation, fit, samples);
    LawError error(exact.size());
    for (std::size_t i = 0; i < error.size(); ++i)
      error[i] = samples.list[i].counts ? off[i] - exact[i] : 0.0;
    errors.push_back(std::move(error));
  }
  return errors;
}

LikelyPart likely_part(const MatrixXd& B, const VectorXd& residual) {
  LikelyPart part{VectorXd::Zero(B.cols()), residual};
  MatrixXd H;
  VectorXd weight;
  constexpr int rounds = 6;
  for (int round = 0; round < rounds; ++round) {
    VectorXd anew = VectorXd::Ones(B.rows());
    for (Eigen::Index row = 0; row < B.rows(); ++row)
      if (std::abs(part.left[row]) > huber_bend) anew[row] = huber_bend / std::abs(part.left[row]);
    if (round > 0 && anew == weight) break;
    weight = std::move(anew);
    const MatrixXd W = weight.asDiagonal() * B;
    H = MatrixXd::Identity(B.cols(), B.cols());
    H.noalias() += B.transpose() * W;
    part.coefficients = H.llt().solve(W.transpose() * residual);
    part.left = residual - B * part.coefficients;
  }
  const MatrixXd L = H.llt().matrixL();
  part.log_determinant = 2 * L.diagonal().array().log().sum();
  return part;
}

VectorXd of_likely_length(const VectorXd& coefficients) {
  if (coefficients.size() == 0) return coefficients;
  constexpr double nearly_all = 0.999;
  const double longest = std::sqrt(boost::math::quantile(
                   boost::math::chi_squared(static_cast<double>(coefficients.size())), nearly_all)),
               length = coefficients.norm();
  return length > longest ? (coefficients * (longest / length)).eval() : coefficients;
}

}  // namespace asperity

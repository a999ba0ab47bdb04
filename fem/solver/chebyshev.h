// Chebyshev polynomial smoother with point-Jacobi scaling (Adams, Brezina, Hu & Tuminaro 2003).
#pragma once

#include "fem/solver/hex_operator.h"

namespace asperity::fem {

class Chebyshev {
 public:
  static constexpr int degree = 4;
  /// The smoother damps eigenvalues in [largest / range, largest] of the scaled operator.
  static constexpr double range = 20.0;

  /// The smoother leaves unknowns of other nodes as they are: by local node, whether it is smoothed.
  void set_smoothed(std::vector<char> nodes) { smoothed_ = std::move(nodes); }

  /// Takes the diagonal of `matrix`. The first time, estimates the largest eigenvalue of the scaled operator
  /// by `steps` of Lanczos (conjugate gradients), with 20 % added: opening, closing and yielding change the
  /// scaled spectrum's upper end little, because the diagonal follows.
  void update(const HexOperator<float>& matrix, int steps = 12);

  /// x = p(A) b; x is taken as zero, or as a first guess. What `scratch` holds is lost.
  void smooth(const HexOperator<float>& matrix, Vector<float>& x, const Vector<float>& b, bool zero_guess,
              Vector<float>& scratch) const;

 private:
  Vector<float> inverse_diagonal_;
  std::vector<char> smoothed_;  ///< empty: all
  mutable Vector<float> direction_;
  double largest_ = 0;
};

}  // namespace asperity::fem

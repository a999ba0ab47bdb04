#include "fem/solver/chebyshev.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/threads.h"

namespace asperity::fem {
namespace {

/// Start vector with all frequencies, of the nodes' places alone: the same on any number of ranks.
void fill_rough(const HexOperator<float>& matrix, Vector<float>& v) {
  constexpr double roughness = 1e5;  // radians over the bodies' size: far more than one from node to node
  constexpr double along[3] = {1.0, 0.7, 0.4};
  const float* places = matrix.positions();
  double size = 0;
  for (unsigned i = 0; i < v.locally_owned_size(); ++i)
    size = std::max(size, std::abs(static_cast<double>(places[i])));
  size = dealii::Utilities::MPI::max(size, v.get_mpi_communicator());
  for (unsigned i = 0; i < v.locally_owned_size(); ++i) {
    const float* place = places + i - i % 3;
    double phase = 2.0 * (i % 3);
    for (int c = 0; c < 3; ++c) phase += roughness / size * along[c] * static_cast<double>(place[c]);
    v.local_element(i) = static_cast<float>(std::sin(phase));
  }
}

}  // namespace

void Chebyshev::update(const HexOperator<float>& matrix, int steps) {
  inverse_diagonal_ = matrix.diagonal();
  float* inverse = inverse_diagonal_.begin();
  const char* smoothed = smoothed_.empty() ? nullptr : smoothed_.data();
  for_entries(static_cast<int>(inverse_diagonal_.locally_owned_size()),
              [=](int i) { inverse[i] = !smoothed || smoothed[i / 3] ? 1.0f / inverse[i] : 0.0f; });
  if (largest_ > 0) return;
  matrix.initialize_dof_vector(direction_);

  Vector<float> r, z, p, q;
  for (auto* v : {&r, &z, &p, &q}) matrix.initialize_dof_vector(*v);
  fill_rough(matrix, p);
  matrix.vmult(r, p);  // in the range of the operator: constrained entries are zero
  z = r;
  z.scale(inverse_diagonal_);
  p = z;
  double rz = static_cast<double>(r * z), alpha_before = 1, beta_before = 0;
  Eigen::MatrixXd lanczos = Eigen::MatrixXd::Zero(steps, steps);
  int made = 0;
  for (; made < steps && rz > 0; ++made) {
    matrix.vmult(q, p);
    const double pq = static_cast<double>(p * q);
    if (!(pq > 0)) break;
    const double alpha = rz / pq;
    lanczos(made, made) = 1 / alpha + (made ? beta_before / alpha_before : 0.0);
    r.add(static_cast<float>(-alpha), q);
    z = r;
    z.scale(inverse_diagonal_);
    const double next = static_cast<double>(r * z), beta = next / rz;
    if (made + 1 < steps)
      lanczos(made, made + 1) = lanczos(made + 1, made) = std::sqrt(std::max(beta, 0.0)) / alpha;
    p.sadd(static_cast<float>(beta), z);
    alpha_before = alpha;
    beta_before = beta;
    rz = next;
  }
  const Eigen::MatrixXd used = lanczos.topLeftCorner(made, made);
  largest_ = made ? 1.2 * Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(used).eigenvalues().maxCoeff() : 1.0;
}

void Chebyshev::smooth(const HexOperator<float>& matrix, Vector<float>& x, const Vector<float>& b,
                       bool zero_guess, Vector<float>& scratch) const {
  const double upper = largest_, lower = largest_ / range;
  const double centre = 0.5 * (upper + lower), half = 0.5 * (upper - lower), sigma = centre / half;
  double rho = 1 / sigma;
  const int n = static_cast<int>(x.locally_owned_size());
  const float* diagonal = inverse_diagonal_.begin();
  const float* rhs = b.begin();
  float* direction = direction_.begin();
  float* values = x.begin();
  const float first = static_cast<float>(1 / centre);
  if (zero_guess) {
    for_entries(n, [=](int i) { values[i] = direction[i] = first * diagonal[i] * rhs[i]; });
  } else {
    matrix.vmult(scratch, x);
    const float* product = scratch.begin();
    for_entries(n, [=](int i) {
      direction[i] = first * diagonal[i] * (rhs[i] - product[i]);
      values[i] += direction[i];
    });
  }
  for (int k = 1; k < degree; ++k) {
    const double next = 1 / (2 * sigma - rho);
    const float keep = static_cast<float>(next * rho), step = static_cast<float>(2 * next / half);
    rho = next;
    matrix.vmult(scratch, x);
    const float* product = scratch.begin();
    for_entries(n, [=](int i) {
      direction[i] = keep * direction[i] + step * diagonal[i] * (rhs[i] - product[i]);
      values[i] += direction[i];
    });
  }
}

}  // namespace asperity::fem

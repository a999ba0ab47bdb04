#include "surfaces/levelling.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/error.h"

namespace asperity {
namespace {

/// Pixel position scaled to [-1, 1], which keeps the normal equations well conditioned.
double scaled(int i, int n) { return (2 * i + 1.0) / n - 1; }

/// Solves the symmetric normal equations A x = b by elimination. A pivot that vanishes (too few points for
/// this term) gives its term the coefficient zero.
template <std::size_t N>
std::array<double, N> solve_normal_equations(std::array<std::array<double, N>, N> A,
                                             std::array<double, N> b) {
  constexpr double vanishing = 1e-12;
  std::array<double, N> original_diagonal, x{};
  for (std::size_t k = 0; k < N; ++k) original_diagonal[k] = A[k][k];
  const auto dropped = [&](std::size_t k) { return A[k][k] <= vanishing * original_diagonal[k]; };
  for (std::size_t k = 0; k < N; ++k) {
    if (dropped(k)) continue;
    for (std::size_t i = k + 1; i < N; ++i) {
      const double factor = A[i][k] / A[k][k];
      for (std::size_t j = k; j < N; ++j) A[i][j] -= factor * A[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = N; k-- > 0;) {
    if (dropped(k)) continue;
    x[k] = b[k];
    for (std::size_t j = k + 1; j < N; ++j) x[k] -= A[k][j] * x[j];
    x[k] /= A[k][k];
  }
  return x;
}

/// Fits the functions `terms_at(ix, iy)` to the known pixels of rows [first, last) and subtracts the fit.
template <std::size_t N, typename TermsAt>
void subtract_fit(Topography& map, int first, int last, TermsAt terms_at) {
  const auto known = [&](int ix, int iy) {
    return map.missing.empty() || !map.missing[static_cast<std::size_t>(iy) * map.nx + ix];
  };
  std::array<std::array<double, N>, N> normal{};
  std::array<double, N> right{};
  for (int iy = first; iy < last; ++iy)
    for (int ix = 0; ix < map.nx; ++ix) {
      if (!known(ix, iy)) continue;
      const std::array<double, N> terms = terms_at(ix, iy);
      for (std::size_t i = 0; i < N; ++i) {
        for (std::size_t j = 0; j < N; ++j) normal[i][j] += terms[i] * terms[j];
        right[i] += terms[i] * map.at(ix, iy);
      }
    }
  const std::array<double, N> fit = solve_normal_equations(normal, right);
  for (int iy = first; iy < last; ++iy)
    for (int ix = 0; ix < map.nx; ++ix) {
      if (!known(ix, iy)) continue;
      const std::array<double, N> terms = terms_at(ix, iy);
      for (std::size_t i = 0; i < N; ++i) map.at(ix, iy) -= terms[i] * fit[i];
    }
}

template <std::size_t N>
void level_map(Topography& map) {
  subtract_fit<N>(map, 0, map.ny, [&](int ix, int iy) {
    const double x = scaled(ix, map.nx), y = scaled(iy, map.ny);
    const std::array<double, 6> all{1, x, y, x * x, x * y, y * y};
    std::array<double, N> terms;
    std::copy_n(all.begin(), N, terms.begin());
    return terms;
  });
}

template <std::size_t N>
void level_rows(Topography& map) {
  for (int row = 0; row < map.ny; ++row)
    subtract_fit<N>(map, row, row + 1, [&](int ix, int) {
      std::array<double, N> terms{1};
      for (std::size_t i = 1; i < N; ++i) terms[i] = terms[i - 1] * scaled(ix, map.nx);
      return terms;
    });
}

}  // namespace

Topography levelled(Topography map, Level level) {
  switch (level) {
    case Level::mean:
      level_map<1>(map);
      break;
    case Level::plane:
      level_map<3>(map);
      break;
    case Level::quadratic:
      level_map<6>(map);
      break;
    case Level::rows0:
      level_rows<1>(map);
      break;
    case Level::rows1:
      level_rows<2>(map);
      break;
    case Level::rows2:
      level_rows<3>(map);
      break;
  }
  if (level != Level::mean) map.periodic = false;
  return map;
}

}  // namespace asperity

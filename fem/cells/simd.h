// Eight cells at a time: the compiler's vector extension, wide enough for AVX-512 in double precision and
// lowered by the compiler to whatever the target has.
#pragma once

#include <cmath>

namespace asperity::fem {

constexpr int lanes = 8;

template <typename Number>
struct SimdOf;
/// Vectors of `lanes` numbers of this precision.
template <>
struct SimdOf<double> {
  typedef double type __attribute__((vector_size(8 * lanes)));
};
template <>
struct SimdOf<float> {
  typedef float type __attribute__((vector_size(4 * lanes)));
};
template <typename Number>
using Simd = typename SimdOf<Number>::type;

/// Of each number.
template <typename V>
inline V square_root(const V& x) {
  V y;
  for (int l = 0; l < lanes; ++l) y[l] = std::sqrt(x[l]);
  return y;
}

}  // namespace asperity::fem

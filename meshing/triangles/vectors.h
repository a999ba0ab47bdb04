// Plain three-vector algebra for meshing/triangles (internal).
#pragma once

#include <array>
#include <cmath>

namespace asperity::meshing {

using Vector = std::array<double, 3>;

inline Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double norm(const Vector& a) { return std::sqrt(dot(a, a)); }
/// a . (b x c): six times the volume of the tetrahedron they span.
inline double triple(const Vector& a, const Vector& b, const Vector& c) { return dot(a, cross(b, c)); }

}  // namespace asperity::meshing

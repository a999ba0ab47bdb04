// Plain three-vector algebra for meshing/triangles (internal).
#pragma once

#include <array>
#include <cmath>

namespace asperity::meshing {

using Vector = std::array<double, 3>;

/// a - b; a . b, in the unit of both multiplied; a x b.
inline Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
/// a x b.
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// Length, in the unit of its components.
inline double norm(const Vector& a) { return std::sqrt(dot(a, a)); }
/// a . (b x c): six times the volume of the tetrahedron they span.
/// In the unit of all three multiplied.
inline double triple(const Vector& a, const Vector& b, const Vector& c) { return dot(a, cross(b, c)); }

}  // namespace asperity::meshing

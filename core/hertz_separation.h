// How far apart the surfaces of a sphere and a plane are outside of their contact.
#pragma once

#include <cmath>

namespace asperity {

/// Separation of the surfaces outside a Hertzian contact of radius a on a sphere of radius R, at a distance r
/// > a from its centre [m] (Johnson 1985, eq. 3.42a).
inline double hertz_separation(double r, double a, double R) {
  const double s = r / a;
  return a * a / (M_PI * R) * ((s * s - 2) * std::acos(1 / s) + std::sqrt(s * s - 1));
}

/// Distance from the centre from which on the surfaces are that far apart [m], to 2 %, 1.15 a at least:
/// asperities that are together as high still touch there.
inline double hertz_reach(double a, double R, double separation) {
  double r = 1.15 * a;
  while (hertz_separation(r, a, R) < separation) r *= 1.02;
  return r;
}

}  // namespace asperity

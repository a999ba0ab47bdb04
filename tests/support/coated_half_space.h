// An elastic half-space with an elastic film that is bonded to it, under the contact of a sphere: the reduced
// modulus that a contact of radius a feels goes from the film's to that of the body below as it grows
// (Perriot & Barthel 2004, J. Mater. Res. 19, 600, eqs. 16 and 17, a fit to their solution),
//   E_eq = E_f + (E_s - E_f)/[1 + (t x_0/a)^1.27],
//   log10 x_0 = -0.093 + 0.792 log10(E_s/E_f) + 0.05 log10(E_s/E_f)^2,
// for 0.01 < E_f/E_s < 100; the approach is that of a homogeneous body of this modulus. SI units.
#pragma once

#include <cmath>

namespace asperity {

struct CoatedHalfSpace {
  double film = 0, body = 0;  ///< reduced moduli E/(1 - nu^2) of the film and of what lies below [Pa]
  double thickness = 0;       ///< t [m]

  /// E_eq of a contact of that radius [m] [Pa].
  double modulus(double contact_radius) const {
    return film + (body - film) / (1 + std::pow(reach() / contact_radius, 1.27));
  }
  /// t x_0: contact radius at which the modulus is half-way [m].
  double reach() const {
    const double contrast = std::log10(body / film);
    return thickness * std::pow(10.0, -0.093 + 0.792 * contrast + 0.05 * contrast * contrast);
  }
};

}  // namespace asperity

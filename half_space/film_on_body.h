// An elastic film that is bonded to an elastic body: what the surface sinks by under pressure.
//
// Wave by wave (Burmister 1945, J. Appl. Phys. 16, 89; Nogi & Kato 1997, J. Tribol. 119, 493), with
// e = exp(-2 q t):
//   u/p = (1 - nu_f)/(G_f q) [1 + 4 q t K e - lambda K e^2]/[1 - (lambda + K + 4 K q^2 t^2) e + lambda K
//   e^2], lambda = 1 - 4 (1 - nu_f)/[1 + (3 - 4 nu) G_f/G],  K = (G_f/G - 1)/(G_f/G + 3 - 4 nu_f).
// Around a force, with E_f of the films alone and E_f q u/2p = 1 + sum of c exp(-b q), fitted,
//   u(r) = F/(pi E_f) [1/r + sum of c/(r^2 + b^2)^(1/2)].
#pragma once

#include <vector>

#include "core/hertz.h"

namespace asperity::half_space {

/// An elastic film on an elastic body.
struct FilmOnBody {
  ElasticBody film, body;
  double thickness = 0;  ///< [m]

  /// Displacement over pressure of a wave of wave number q [1/m], less that of the body alone [m/Pa].
  double compliance(double q) const;
};

/// One term of what films change.
struct FilmTerm {
  double reach, share;  ///< b [m], c [-]
};

/// A pair of bodies with films.
struct FilmedBodies {
  double of_films = 0;          ///< E_f: reduced modulus of the pair with nothing below the films [Pa]
  std::vector<FilmTerm> terms;  ///< empty without films

  /// modulus: E* of the bodies without their films [Pa]. Throws InputError for a modulus or a thickness that
  /// is not above 0. The terms are within 2e-4 of the whole displacement of any wave, of films from a
  /// hundredth to a hundred times as stiff as their body.
  FilmedBodies(double modulus, const std::vector<FilmOnBody>& films);
};

}  // namespace asperity::half_space

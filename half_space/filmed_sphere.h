// A sphere on a plane, elastic and without friction, with films on one of them or on both: exact for a
// contact that is small against the sphere. With the displacement u over the pressure p of a wave of wave
// number k and E_f (half_space/film_on_body.h), and a pressure whose Hankel transform is
// int_0^a g(s) cos(k s) ds, so that it ends at the edge of the contact,
//   g(x) + 1/pi int_-a^a g(s) K(x - s) ds = E_f/pi (d - x^2/R),  K(y) = int_0^inf (E_f k u/2p - 1) cos(k y)
//   dk, F = 2 pi int_0^a g(s) ds,  g(a) = 0,
// for 0 < x < a (Yu, Sanday & Rath 1990, J. Mech. Phys. Solids 38, 745). Each term c exp(-b k) of what films
// change gives K its c b/(b^2 + y^2). SI units.
#pragma once

#include <vector>

#include "half_space/film_on_body.h"

namespace asperity::half_space {

class FilmedSphere {
 public:
  /// modulus: E* of the bodies without their films [Pa]. Throws InputError for a modulus or a thickness that
  /// is not above 0.
  FilmedSphere(double modulus, const std::vector<FilmOnBody>& films)
      : bare_(modulus), bodies_(modulus, films) {}

  /// How a contact is pressed.
  struct Contact {
    double approach = 0;   ///< d [m]
    double force = 0;      ///< F [N]
    double stiffness = 0;  ///< dF/dd [N/m]
  };
  /// Under a contact of this radius [m], of a sphere of that radius [m].
  Contact at(double contact_radius, double sphere_radius) const;

  /// Radius of the contact at a force [N] or an approach [m] of a sphere of that radius [m]; 0 at none [m].
  double radius_at_force(double force, double sphere_radius) const;
  double radius_at_approach(double approach, double sphere_radius) const;

  /// Reduced modulus of the films alone, which a contact much smaller than they are thick feels [Pa].
  double modulus_of_films() const { return bodies_.of_films; }

 private:
  /// K(y)/pi [1/m] and its integral from -x to x [-].
  double kernel(double y) const;
  double kernel_up_to(double x) const;

  double bare_;
  FilmedBodies bodies_;
};

}  // namespace asperity::half_space

// What a blunt tip makes of a surface: the image is the grey-scale dilation of the surface by the reflected
// tip (Villarrubia 1997, J. Res. NIST 102, 425): i(x) = max over u of [h(x + u) - t(u)], with t the height of
// the tip above its apex.
#pragma once

#include "surfaces/topography.h"

namespace asperity {

/// parabolic: t = u^2/(2R); spherical: t = R - (R^2 - u^2)^(1/2) for u <= R, a cylinder of radius R above.
struct Tip {
  enum class Shape { parabolic, spherical } shape = Shape::spherical;
  double radius = 0;  ///< R [m]; 0: an ideally sharp tip
};

/// The image of a periodic or bounded map without missing points, on the same pixels (which must be small
/// against R).
Topography dilated(const Topography& surface, const Tip& tip);

}  // namespace asperity

// What a normal law says of a contact at one instant; the other laws of the contact take it from here. SI
// units.
#pragma once

namespace asperity {

struct NormalState {
  double approach = 0;        ///< delta [m], of points far from the contact; negative: a gap
  double force = 0;           ///< f_n [N], pressing is positive
  double contact_radius = 0;  ///< a [m]
  double stiffness = 0;       ///< d f_n / d delta [N/m]
  bool touching = false;      ///< history: an adhesive contact made at delta = 0 lasts to a negative approach
  double largest_approach = 0;  ///< history: up to where it has yielded [m]; zero for elastic laws
  /// History of adhesion with hysteresis: radii out to which the surfaces have been in contact, and out to
  /// which they attract each other [m].
  double joined_radius = 0, attraction_radius = 0;
};

}  // namespace asperity

// Force and torque balance of a sphere in a V-rail of inclination theta under a plate, both slopes alike and
// r_i = r_s (Fuchs, Weinhart et al. 2014, eq:forces4, eq:forces6, eq:murail, h_rail, eq:muto2). Friction
// factors mu lambda [m] with offsets h [N]; forces f, f_l at one slope. All limits are reached: no sliding,
// quasi-static.
#pragma once

namespace asperity {

/// Friction factors of the contacts, each over the particle's radius: mu lambda/r.
/// Both coefficients [-].
struct RailFriction {
  double rolling = 0;         ///< mu_ro lambda/r, mean over both kinds of contact
  double torsion = 0;         ///< mu_to lambda/r at the slopes
  double rolling_offset = 0;  ///< h_ro [N], taken alike at plate and slopes
  double torsion_offset = 0;  ///< h_to [N]
};

/// eq:murail: mu_rail = (2 cos(theta) mu_ro + sin(theta) mu_to)/(1 + cos(theta)).
/// angle [rad]; the result [-].
double rail_friction(double angle, const RailFriction& friction);
/// h_rail of f_l = mu_rail (f + h_rail) [N].
double rail_offset(double angle, const RailFriction& friction);
/// eq:murail solved for mu_to.
/// angle [rad]; the rest [-].
double torsion_from_rail(double angle, double rail_friction, double rolling);
/// h_rail solved for h_to [N], from a measured mu_rail and h_rail.
double torsion_offset_from_rail(double angle, double rail_friction, double rail_offset,
                                const RailFriction& friction);
/// eq:muto2: what torsion adds to the lateral force [N].
double torsion_force(double angle, double lateral_force, double normal_force, double rolling,
                     double rolling_offset);

}  // namespace asperity

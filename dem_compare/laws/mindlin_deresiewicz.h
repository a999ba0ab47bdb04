// Partial slip of a Hertzian contact with its full history, load and shear varying as they like
// (Cattaneo 1938; Mindlin & Deresiewicz 1953; Jaeger 1993; Ciavarella 1998).
// By Jaeger's and Ciavarella's theorem every tangential state is a superposition of normal contacts that
// passed through smaller approaches s; so it is a function u(s), 0 <= s <= delta, the elastic shift of the
// strip x = (R s)^(1/2) (the same strips as in Popov's method of dimensionality reduction):
//   u <- u + d xi,  cut to |u| <= kappa (delta - s),  kappa = 3 mu (f_n + h) R/(16 G* a^3)  (= mu E*/(4 G*)
//   for Hertz, h = 0) f_l = 8 G* int_0^a u dx.
// u(s) stays piecewise linear on straight paths of (delta, xi), so any step along one line is exact: virgin
// curve, Masing's rule, memory and its wiping out, oblique loading at every ratio, unloading. Gross slip is
// f_l = mu (f_n + h). Shear that turns is cut along the direction it ends in: exact for vanishing steps, of
// first order for finite ones; and the profile is followed along chords on at most 200 nodes: within 6e-5 of
// the limit in size, 4e-3 rad in direction. With h > 0 and changing load kappa changes too, and long steps
// are no longer exact. Limits: elastically similar bodies; slip along the force (the transverse slip that is
// left out changes the shift by less than 0.2 %); without area (a = 0) there is no lateral force, whatever h.
// SI units.
#pragma once

#include "dem_compare/laws/coulomb.h"
#include "dem_compare/laws/normal_state.h"
#include "dem_compare/laws/sliding_history.h"

namespace asperity {

struct MindlinDeresiewicz {
  double sliding_modulus = 0;  ///< G* [Pa]
  double radius = 0;           ///< R [m]
  CoulombLimit friction;

  SlidingHistory advance(const SlidingHistory& before, const NormalState& normal,
                         const Eigen::Vector3d& increment) const;

  /// 3 mu f_n/(16 G* a): shift at which the whole contact slips [m]
  double gross_slip_shift(const NormalState& normal) const {
    return 3 * friction.limit(normal.force) / (16 * sliding_modulus * normal.contact_radius);
  }
};

inline const LawEntry<MindlinDeresiewicz, SlidingMode> mindlin_deresiewicz_entry{
    {"mindlin_deresiewicz",
     "u(s) <- u + d xi cut to |u| <= kappa (delta - s), kappa = 3 mu (f_n + h) R/(16 G* a^3), f_l = 8 G* "
     "int_0^a u dx; at constant load xi = 3 mu f_n/(16 G* a) [1 - (1 - f_l/(mu f_n))^(2/3)]",
     "Cattaneo 1938; Mindlin & Deresiewicz 1953; Jaeger 1993; Ciavarella 1998",
     "elastically similar bodies, Hertzian area; shear that turns: small steps"},
    {{{"sliding_modulus", "Pa", "G*"}, &MindlinDeresiewicz::sliding_modulus},
     {{"radius", "m", "R"}, &MindlinDeresiewicz::radius}},
    friction_fields<MindlinDeresiewicz>()};

}  // namespace asperity

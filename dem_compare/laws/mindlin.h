// Tangential stiffness of a contact without slip, added up in increments, with Coulomb's limit (Mindlin
// 1949):
//   d f_l = 8 G* a d xi,   |f_l| <= mu (f_n + h),   1/G* = (2 - nu1)/G1 + (2 - nu2)/G2.
// While the load changes: see ChangingLoad in spring_slider.h; rescaling on unloading creates no energy.
// Not valid near sliding: slip starts at the edge of the contact at any lateral force, which softens the
// spring (its tangent by a third at 0.7 mu f_n, its secant by a third at gross slip) and dissipates:
// mindlin_deresiewicz.h. SI units.
#pragma once

#include "dem_compare/laws/coulomb.h"
#include "dem_compare/laws/normal_state.h"
#include "dem_compare/laws/sliding_history.h"

namespace asperity {

struct Mindlin {
  double sliding_modulus = 0;  ///< G* [Pa]
  CoulombLimit friction;
  ChangingLoad changing_load = ChangingLoad::rescale_on_unloading;

  /// 8 G* a [N/m] at a contact radius a [m].
  double stiffness(double contact_radius) const { return 8 * sliding_modulus * contact_radius; }

  SlidingHistory advance(const SlidingHistory& before, const NormalState& normal,
                         const Eigen::Vector3d& increment) const {
    if (!normal.touching) return {};
    return {SpringSlider<Eigen::Vector3d>::advance(before.spring, stiffness(normal.contact_radius), increment,
                                                   friction.limit(normal.force), changing_load),
            {}};
  }
};

inline const LawEntry<Mindlin, SlidingMode> mindlin_entry{
    {"mindlin", "d f_l = 8 G* a d xi, |f_l| <= mu (f_n + h); f_l rescaled by a/a_before on unloading",
     "Mindlin 1949; on changing load: Elata & Berryman 1996, Walton & Braun 1986",
     "lateral force well below mu f_n; elastically similar bodies"},
    {{{"sliding_modulus", "Pa", "G*"}, &Mindlin::sliding_modulus},
     {{"changing_load", "", "where a changes", 0, 1, 0, {"rescale_on_unloading", "plain"}},
      &Mindlin::changing_load}},
    friction_fields<Mindlin>()};

}  // namespace asperity

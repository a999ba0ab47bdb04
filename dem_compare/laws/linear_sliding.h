// Linear tangential spring with Coulomb's slider (Cundall & Strack 1979): f_l = k xi, |f_l| <= mu (f_n + h).
// SI units. An engine's convenience: the stiffness of a real contact follows its radius (mindlin.h).
#pragma once

#include "dem_compare/laws/coulomb.h"
#include "dem_compare/laws/normal_state.h"
#include "dem_compare/laws/sliding_history.h"

namespace asperity {

struct LinearSliding {
  double spring_stiffness = 0;  ///< k [N/m]
  CoulombLimit friction;

  SlidingHistory advance(const SlidingHistory& before, const NormalState& normal,
                         const Eigen::Vector3d& increment) const {
    if (!normal.touching) return {};
    return {SpringSlider<Eigen::Vector3d>::advance(before.spring, spring_stiffness, increment,
                                                   friction.limit(normal.force), ChangingLoad::plain),
            {}};
  }
};

inline const LawEntry<LinearSliding, SlidingMode> linear_sliding_entry{
    {"linear_sliding", "f_l = k xi, |f_l| <= mu (f_n + h)", "Cundall & Strack 1979",
     "near the one load where k was taken from"},
    {{{"spring_stiffness", "N/m", "k"}, &LinearSliding::spring_stiffness}},
    friction_fields<LinearSliding>()};

}  // namespace asperity

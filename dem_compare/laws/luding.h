// Piecewise linear, elasto-plastic and adhesive (Luding 2008, Granul. Matter 10, 235): loading k1 delta;
// unloading and reloading k2 (delta - delta_0), delta_0 = (1 - k1/k2) delta_max; never below -k_c delta. k2
// grows with the largest approach, k1 + (k_p - k1) delta_max/delta_p, up to k_p at delta_p (0: k_p at once).
// On the branch -k_c delta the history goes back: reloading from there meets it again. a = (R delta)^(1/2).
// SI units.
#pragma once

#include <algorithm>
#include <cmath>

#include "dem_compare/laws/law_registry.h"
#include "dem_compare/laws/normal_state.h"

namespace asperity {

struct Luding {
  double loading_stiffness = 0;    ///< k1 [N/m]
  double unloading_stiffness = 0;  ///< k_p, at least k1 [N/m]
  double adhesion_stiffness = 0;   ///< k_c [N/m]
  double full_approach = 0;        ///< delta_p, from which unloading has k_p [m]
  double radius = 0;               ///< R [m]

  /// k2 [N/m]
  double unloading_stiffness_at(double largest_approach) const {
    const double most = std::max(loading_stiffness, unloading_stiffness);
    if (largest_approach >= full_approach) return most;
    return loading_stiffness + (most - loading_stiffness) * largest_approach / full_approach;
  }

  NormalState advance(const NormalState& before, double approach) const {
    double largest = std::max(before.largest_approach, approach);
    if (approach <= 0) return {approach, 0, 0, 0, false, before.largest_approach};
    const double a = std::sqrt(radius * approach);
    const double k2 = unloading_stiffness_at(largest),
                 elastic = k2 * approach - (k2 - loading_stiffness) * largest;
    if (approach >= largest)
      return {approach, loading_stiffness * approach, a, loading_stiffness, true, largest};
    if (elastic > -adhesion_stiffness * approach) return {approach, elastic, a, k2, true, largest};
    largest = std::min(largest, largest_on_limit(approach));
    return {approach, -adhesion_stiffness * approach, a, -adhesion_stiffness, true, largest};
  }
  /// On first loading.
  double approach(double force) const { return force / loading_stiffness; }

 private:
  /// delta_max whose unloading line crosses -k_c delta here.
  double largest_on_limit(double approach) const {
    const double most = std::max(loading_stiffness, unloading_stiffness);
    const double constant = (most + adhesion_stiffness) * approach / (most - loading_stiffness);
    if (constant >= full_approach) return constant;
    const double slope = (most - loading_stiffness) / full_approach;  // k2 = k1 + slope delta_max
    const double linear = slope * approach;
    return (linear +
            std::sqrt(linear * linear + 4 * slope * (loading_stiffness + adhesion_stiffness) * approach)) /
           (2 * slope);
  }
};

inline const LawEntry<Luding, NormalMode> luding_entry{
    {"luding",
     "f_n = k1 delta in loading, k2 (delta - delta_0) in unloading, at least -k_c delta; delta_0 = (1 - "
     "k1/k2) delta_max",
     "Luding 2008, Granul. Matter 10, 235",
     "an engine's convenience: right near the load where its stiffnesses were taken from"},
    {{{"loading_stiffness", "N/m", "k1", 1e-9}, &Luding::loading_stiffness},
     {{"unloading_stiffness", "N/m", "k_p, the largest k2; below k1 it counts as k1"},
      &Luding::unloading_stiffness},
     {zero_otherwise({"adhesion_stiffness", "N/m", "k_c"}), &Luding::adhesion_stiffness},
     {zero_otherwise({"full_approach", "m", "delta_p, largest approach from which k2 = k_p"}),
      &Luding::full_approach},
     {{"radius", "m", "R, for the contact radius"}, &Luding::radius}}};

}  // namespace asperity

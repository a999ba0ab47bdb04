#include "fem/output/discretisation_error.h"

#include <algorithm>
#include <cmath>

namespace asperity::fem {

DiscretisationError::DiscretisationError(const HistoryRow& peak, const InterfaceScales& scales)
    : scales_(scales),
      resolution_(peak.contact_area > 0 ? peak.contact_perimeter * scales.spacing / peak.contact_area : 0),
      whole_(peak.pressure_radius > 0 ? scales.spacing / peak.pressure_radius : 0),
      wave_(scales.spacing / scales.shortest_wave),
      dent_(scales.reduced_modulus > 0 ? scales.spacing * peak.mean_pressure / scales.reduced_modulus : 0) {}

DiscretisationError DiscretisationError::at(const HistoryRow& row) const { return {row, scales_}; }

// Smooth spheres of 2 and 8.5 um, Dugdale's attraction, lambda 0.9 to 2.8, against half-spaces: with cells of
// 0.37, 0.5, 0.75, 1, 1.5 and 2 zones the pull-off force is 6, 16, 37, 67, 120 and 190 % too large.
double DiscretisationError::held_edge() const {
  return 1 / (1 + std::pow(scales_.attraction.zone / scales_.spacing, 3));
}

// Hertz at a/h 6 to 18, 41 rough elastic contacts with 8, 4 and 2 spacings in the shortest wave, against
// boundary elements: what the correction of the edge (contact_area.h) leaves.
// On spheres that attract each other, lambda 1.7, under twice their pull-off force, the area is 10 % too
// small with cells of one zone, 20 % with two.
double DiscretisationError::area() const {
  return std::hypot(resolution_ * std::hypot(0.05, 0.05 * resolution_), 0.2 * held_edge());
}

// The same contacts: -10 to -25 % at kappa 0.5 to 1.5 and four spacings, -25 to -60 % with two, -2 % with
// eight. Where spots have grown together the edge says little of the waves within.
double DiscretisationError::largest_pressure() const {
  return std::hypot(0.13 * std::pow(resolution_, 1.5), wave_ * wave_);
}

// The same contacts: 0.1 of the dent at kappa 0.5, up to all of it at kappa 2.
double DiscretisationError::approach() const {
  const double attracted = scales_.attraction.length * held_edge();
  return std::hypot(dent_ * std::hypot(0.1, 0.15 * resolution_ * resolution_), attracted);
}

// One surface on spacings of 5 to 41 nm: -3.35, -3.23, -3.11, -2.57 nm for -3.36. Of smooth bodies only the
// sphere's own sag between two nodes, h^2/(8 R).
double DiscretisationError::first_touch() const {
  if (wave_ == 0) return 0.15 * resolution_ * dent_;
  return dent_ * std::hypot(0.25, 0.15 * resolution_ * resolution_);
}
double DiscretisationError::unloading() const { return 0.1 * dent_; }
double DiscretisationError::load_centre() const { return 0.1 * scales_.spacing; }

// Hertz at a/h 6, 12, 24: 1.4, 0.7, 0.2 %; rough contacts on 12 and 24 nm: at most 0.6 %.
double DiscretisationError::stiffness() const { return std::hypot(0.07 * whole_, 0.01 * resolution_); }

// Against 8 G* a at a/h 6, 8, 12, 18: +0.1, +2.2, +1.7, +0.2 %.
double DiscretisationError::lateral_stiffness() const {
  return std::hypot(0.15 * whole_, 0.01 * resolution_);
}

// Against 16 G a^3 / 3 with four layers of cells: +1.1, +0.5, -1.6 %, which does not fall with the spacing.
double DiscretisationError::torsion_stiffness() const { return std::hypot(0.015, 0.01 * resolution_); }

// Below Hertz' contact at a/h 8 with four layers of cells: +6.3 %; at a/h 16 with ten -0.2 and -1.3 %. In
// asperities as their pressure.
double DiscretisationError::largest_stress() const { return std::hypot(0.5 * whole_, largest_pressure()); }
double DiscretisationError::largest_plastic_strain() const {
  return std::hypot(0.5 * whole_, 2 * largest_pressure());
}
double DiscretisationError::plasticity() const { return std::hypot(0.25 * whole_, largest_pressure()); }

// Friction by an area: tractions sum over whole nodes, without the area's correction of the edge; +1 to +2.3
// % for smooth spheres with a/h 12 and 13, up to 2.7 times what is left of the area. By a load: what is left
// is that of full slip, below 0.5 %.
double DiscretisationError::resistance(double share_by_area) const {
  constexpr double without_correction = 2.5;
  return std::hypot(0.005, share_by_area * without_correction * area());
}

// As friction's lever arm goes with the contact radius.
double DiscretisationError::torsion() const { return std::hypot(0.01, 1.5 * area()); }

// Smooth contacts at a/h 6 and 8 against Kendall, Krijt, Dominik & Tielens: within 2.4 %. Bonds break by
// whole rows of nodes along the path: 14 smooth contacts with a/h 6 to 15 lost the work of 0 to 2.4 rows more
// than of a width of 2 a, root mean square 1.2: 0.3 of the edge's
// share of the area. Slip of smooth bodies of two materials (glass on silicon, friction 0.1) at a/h 6, 9.4,
// 13 and 19: +40, +13, +9 and +3 % more than what it tends to. Ten pairs of meshes of nine rough
// contacts that yield and slip, 30 and 95 uN, most of 17 nm against half of it: off by 0.04 to 1.6 of the
// area's error, root mean square 0.7.
double DiscretisationError::rolling(double share_by_bonds) const {
  const double by_slip = (1 - share_by_bonds) * std::hypot(1.2 * whole_, std::pow(whole_ / 0.23, 4));
  return std::hypot(std::hypot(0.2 * whole_, area(), 0.3 * share_by_bonds * resolution_), by_slip);
}

// Smooth contacts with 8 to 16 spacings in the unit of radius against Maugis: up to 0.65 %; where the ring of
// attraction is two or three cells wide up to 5 %.
double DiscretisationError::pull_off() const { return std::hypot(0.02, area(), 0.9 * held_edge()); }
double DiscretisationError::spots() const { return 0.5 * std::min(1.0, resolution_); }

}  // namespace asperity::fem

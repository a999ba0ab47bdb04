// Discretisation error of the numbers of a single case, as standard deviations.
//
// Measure of how well a contact is resolved: kappa = perimeter * spacing / area, 2 h / a for a
// circle of radius a, four spacings over the width of a square spot for kappa 1. It needs no knowledge of
// spectra and sees what has yielded. Errors of the area are those of the edge, so of first order in kappa.
// Attraction acts in a zone at the edge of a contact (half_space::attraction_zone): cells that do not resolve
// it hold the edge as friction does, on separation under too large a tension, on approach too far out.
// The constants are root mean square errors, each from the cases that its comment names; where they come from
// boundary elements, tests/fem/stated_errors_test.cc asserts that two standard deviations hold nine of ten.
#pragma once

#include <limits>

#include "fem/interface/surface_attraction.h"
#include "results/history.h"

namespace asperity::fem {

/// What a mesh has to resolve, and its spacing.
struct InterfaceScales {
  double spacing = 0;                                              ///< of the interface's nodes [m]
  double reduced_modulus = 0;                                      ///< E* [Pa]
  double shortest_wave = std::numeric_limits<double>::infinity();  ///< of both surfaces [m]
  AttractionScales attraction;
};

class DiscretisationError {
 public:
  /// peak: the step at the largest load.
  DiscretisationError(const HistoryRow& peak, const InterfaceScales& scales);

  /// That of the same mesh at another step, such as that of the largest tension.
  DiscretisationError at(const HistoryRow& row) const;

  double resolution() const { return resolution_; }  ///< kappa [-]

  /// Relative to the number itself, from here to spots().
  double area() const;  ///< also of the mean pressure; twice that of the radius
  double largest_pressure() const;
  double stiffness() const;
  double lateral_stiffness() const;
  double torsion_stiffness() const;
  double largest_stress() const;  ///< below the surface
  double largest_plastic_strain() const;
  double plasticity() const;  ///< yielded volume, dissipation, imprint
  double resistance(double share_by_area)
      const;               ///< of sliding, of which this share goes with the area and not with the load
  double torsion() const;  ///< moment
  /// Moment, dissipation, of which bonds that break take this share.
  double rolling(double share_by_bonds) const;
  double pull_off() const;
  double spots() const;

  /// Lengths [m].
  double approach() const;     ///< of the mean planes
  double first_touch() const;  ///< where the surfaces touch first
  double unloading() const;    ///< difference of two approaches at small loads
  double load_centre() const;

 private:
  /// From 0, where cells resolve the zone of attraction, to 1, where they do not see it.
  double held_edge() const;

  InterfaceScales scales_;
  double resolution_;
  double whole_;  ///< spacing over the radius of the contact as a whole
  double wave_;   ///< spacing over the shortest wave
  double dent_;   ///< what the mean pressure presses in over a spacing, h p / E* [m]
};

}  // namespace asperity::fem

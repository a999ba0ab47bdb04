// From a case to the system that is solved: materials, roughness, and mesh defaults derived from load and roughness.
#pragma once

#include "core/case.h"
#include "fem/contact/contact_system.h"
#include "fem/experiments/program.h"

namespace asperity::fem {

struct CaseSetup {
  ContactSystemOptions system;
  double hertz_radius = 0;      ///< a of the smooth elastic contact at the largest load [m]
  double hertz_approach = 0;    ///< its approach [m]
  double reduced_modulus = 0;   ///< E* [Pa]
  double largest_load = 0;      ///< given, or Hertz' at the largest approach [N]
  MotionScales motion;          ///< of the steps of sliding and torsion
  double rms_particle = 0, rms_substrate = 0;  ///< of the heights within the contact region [m]
};

/// The case with Distance and Angle of its motion derived where they are 0: five radii of Hertz' contact, so that two diameters
/// of it are steady; six times the spin at which a smooth contact slips as a whole, for the spots of a rough one let go later.
CaseInput with_derived_way(const CaseInput& input);

/// Throws InputError if the mesh parameters do not fit the bodies.
CaseSetup set_up(const CaseInput& input);

/// Throws what set_up throws, without making the surfaces.
void check_extent(const CaseInput& input);

J2Material material_of(const BodyInput& body);

/// Separation of the surfaces outside a Hertzian contact, at distance r > a from its centre (Johnson 1985, eq. 3.42a).
double hertz_separation(double r, double contact_radius, double sphere_radius);

}  // namespace asperity::fem

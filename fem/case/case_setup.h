// From a case to the system that is solved: materials, roughness, and mesh defaults derived from load and
// roughness.
#pragma once

#include "core/case.h"
#include "fem/case/mesh_quality.h"
#include "fem/contact/contact_system.h"
#include "fem/interface/surface_attraction.h"
#include "fem/programs/program.h"
#include "surfaces/surface_of_entry.h"

namespace asperity::fem {

/// One body's roughness on the mesh.
struct MeshedRoughness {
  TopographyScales scales;
  double spacing = 0;          ///< of the interface's nodes [m]
  double region = 0;           ///< longer side of the finely meshed rectangle [m]
  RoughnessFidelity fidelity;  ///< known once the mesh is made

  bool rough() const { return scales.rms > 0; }
  /// Shortest wave over the spacing [-].
  double cells_per_wave() const { return scales.shortest_wave / spacing; }
};

struct CaseSetup {
  ContactSystemOptions system;
  double hertz_radius = 0;                     ///< a of the smooth elastic contact at the largest load [m]
  double hertz_approach = 0;                   ///< its approach [m]
  double filmed_radius = 0;                    ///< the same with their films; Hertz' without any [m]
  double least_radius = 0;                     ///< of any contact, which is meshed (contact_radii.h) [m]
  double largest_radius = 0;                   ///< of a smooth contact that may yield, at most [m]
  double reduced_modulus = 0;                  ///< E* [Pa]
  double largest_load = 0;                     ///< given, or Hertz' at the largest approach [N]
  double attraction_force = 0;                 ///< beyond the contact, which carries it beside the load [N]
  MotionScales motion;                         ///< of the steps of sliding and torsion
  double rms_particle = 0, rms_substrate = 0;  ///< of the heights within the contact region [m]
  std::array<MeshedRoughness, 2> roughness;    ///< particle, substrate
  AttractionScales attraction;

  double largest_contact_force() const { return largest_load + attraction_force; }  ///< [N]
};

/// The case with Distance and Angle of its motion derived where they are 0: five radii of Hertz' contact, six
/// where it rolls and the sphere's cap holds that, so that two diameters of it are steady, and one less at
/// least of one that a film or attraction widens; six times the spin at which a smooth contact slips as a
/// whole, for the junctions of a rough one slip later, and four times at least that of a contact drawn
/// together by attraction.
CaseInput with_derived_path_length(const CaseInput& input);

/// Throws InputError if the mesh parameters do not fit the bodies.
CaseSetup set_up(const CaseInput& input);

/// All of it but the surfaces' heights and what follows from them.
/// Throws InputError as set_up does.
CaseSetup set_up_sizes(const CaseInput& input);

/// Throws what set_up throws, without making the surfaces.
void check_extent(const CaseInput& input);

/// Elasticity and plasticity of a body of a case, and of its film.
J2Material material_of(const BodyInput& body);
Film film_of(const BodyInput& body);

}  // namespace asperity::fem

// The normal contact of a case by half-spaces: both surfaces as its meshes have them, on the axis of the
// sphere.
//
// gap(x, y) = R - sqrt(R^2 - r^2) - h_particle(x, y) - h_substrate(x, y): both heights grow out of their
// material, at the same place (x, y), as in meshing/contact_mesh.h; counted from the mean surfaces, so that
// the approach is theirs. One E* stands for both elastic bodies. Without friction; yielding only by a
// hardness, whose imprint is left when the surfaces are separated.
#pragma once

#include <limits>
#include <optional>

#include "core/case.h"
#include "half_space/adhesive_contact.h"
#include "half_space/contact_shape.h"
#include "half_space/normal_contact.h"
#include "half_space/stuck_contact.h"

namespace asperity::half_space {

/// How finely it is solved, and with which hardness.
struct CaseContactOptions {
  double half_width = 0;  ///< of the square that is solved on [m]; 0: derived from load and roughness
  double spacing = 0;     ///< of its cells [m], or a little less; 0: derived, see derived_spacing
  int most_cells = 1024;  ///< along a side; the spacing grows where that is too few
  /// Largest pressure, less the attraction [Pa].
  double hardness = std::numeric_limits<double>::infinity();
  bool with_stiffness = true;
  /// Of surfaces that attract each other: stiffness is that of the contact as it stands, as finite elements
  /// measure it, in place of the slope of separation, along which the edge moves.
  bool edge_is_held = false;
  bool with_shear_stiffness = false;
  std::optional<Attraction> attraction;  ///< of the surfaces; none: no adhesion
  bool with_pull_off = true;             ///< of surfaces that attract each other
  OnSeparation on_separation{};          ///< hears of it, for it takes minutes with a short range
};

struct CaseContact {
  Grid grid;
  NormalContactSolution solution;
  ContactShape shape;
  double first_touch =
      0;  ///< approach at which the undeformed surfaces touch [m], below 0 where asperities meet first
  double stiffness = 0;          ///< [N/m] at the beginning of unloading; 0: not asked for
  double lateral_stiffness = 0;  ///< before anything slips [N/m]; 0: not asked for, or bodies with films
  double torsion_stiffness = 0;  ///< likewise, about the axis of the sphere [N m]
  int enlarged = 0;              ///< times that the contact reached the edge, and the square was made larger
  double attracting = 0;         ///< sum of the attraction, which the contact carries beside the load [N]
  double beyond_contact = 0;     ///< the part of it that is told as a force and presses like more load [N]
  double attraction_in_touch = 0;   ///< of surfaces where they touch, by the law of separation [Pa]
  std::optional<PullOff> pull_off;  ///< of surfaces that attract each other

  double approach() const { return solution.approach; }         ///< of the mean surfaces [m]
  double force() const { return solution.force - attracting; }  ///< normal force from outside [N]

  // As finite elements have them, with attraction taken off, which `shape` counts as pressure that bears it:
  double mean_pressure() const {  ///< [Pa]
    return shape.area > 0 ? (force() + beyond_contact) / shape.area : 0;
  }
  double largest_pressure() const { return shape.largest_pressure - attraction_in_touch; }  ///< [Pa]
};

/// Gap of the undeformed surfaces in the middle of each cell [m]; `input` as below. Throws ScanError where a
/// scan is smaller than the grid.
Field gap_of_case(const CaseInput& input, const Grid& grid);

/// Of both bodies together.
ShearCompliance shear_compliance(const CaseInput& input);

/// Of both surfaces [m]; infinite where both are smooth.
double shortest_wave(const CaseInput& input);

/// Width of the zone at the edge of a contact in which the attraction acts (core/attraction_zone.h) [m].
/// Grids of cells wider than half of it do not tell adhesion: the edge sticks to them.
double attraction_zone(const CaseInput& input, const Attraction& attraction);

/// Cells that a contact needs: 24 over Hertz' radius, 16 over the shortest wave of either surface, with which
/// the largest pressure reads some 2 % too small, 8 over a film; of surfaces that attract each other Hertz'
/// radius under what smooth ones attract as well, and 4 over the attraction's zone [m].
double derived_spacing(const CaseInput& input, const std::optional<Attraction>& attraction = std::nullopt);

/// Half width of a square that holds the contact [m]: where smooth surfaces under Hertz' pressure would be
/// three RMS heights apart, and the range of an attraction more.
double derived_half_width(const CaseInput& input, const std::optional<Attraction>& attraction = std::nullopt);

/// The case at its largest load, or at its approach from first touch under control by displacement. Where
/// contact reaches the edge of the square, it is enlarged. Throws InputError where it still does after four
/// times, or where it goes beyond half the radius; ScanError where a scan is smaller than the square.
CaseContact contact_of_case(const CaseInput& input, const CaseContactOptions& options = {});

/// The case under each of these normal forces [N], on the surfaces and cells of the largest, which are made
/// once. Throws as contact_of_case does.
std::vector<CaseContact> contacts_under(CaseInput input, const std::vector<double>& forces,
                                        const CaseContactOptions& options = {});

/// A case at two spacings, one twice the other, whose difference tells the error of the finer (errors of
/// first order, so that it is rather too large).
struct CasePreview {
  CaseContact fine, coarse;
  std::optional<CaseContact> capped;  ///< at the finer spacing, with a hardness below the largest pressure

  double resolution = 0;  ///< finer spacing over the shortest wave [-]; 0: smooth

  double error_of_area() const;  ///< relative
  /// Relative; at least what was measured for the `resolution` (2 % with sixteen cells over the shortest
  /// wave, 5 % with eight), for the highest peak may fall between the cells of both spacings.
  double error_of_largest_pressure() const;
  double error_of_stiffness() const;  ///< relative
  double error_of_approach() const;   ///< [m]
  double error_of_pull_off() const;   ///< relative; of surfaces that attract each other
};

/// hardness: of the softer body [Pa], infinite without one; attraction: of the surfaces, if any. Where its
/// zone is too small for the finest grid it is left out, and there is no pull-off.
CasePreview preview_of_case(const CaseInput& input, double hardness,
                            const std::optional<Attraction>& attraction = std::nullopt,
                            const OnSeparation& on_separation = nullptr);

}  // namespace asperity::half_space

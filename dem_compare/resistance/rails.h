// A sphere that rolls along a rail: on the rail's flank it rolls and spins at once, by tan(inclination) for
// each angle it rolls. Fuchs, Weinhart et al. (2014) take the moment for M_ro cos + M_to sin of rolling and
// torsion on their own (their eq. for the rail). A contact that rolls meets surface that has not yet slipped,
// so that it need not resist its spin fully (Kalker 1990). SI units.
#pragma once

#include <optional>
#include <vector>

#include "dem_compare/cases/moving_case.h"

namespace asperity {

struct MovingContact;

/// One inclination of a contact under one load, over the realisations of its surfaces. Angles count about the
/// rail's transverse axis, the sphere's own: those of rolling over cos(inclination).
struct RailState {
  double inclination = 0;               ///< between the flank and the plane [rad]
  double load = 0;                      ///< across the flank [N]
  std::vector<MovingCase> cases;        ///< on the finest spacing
  std::vector<Uncertain> spin_moments;  ///< of the cases: mean moment against the spin [N m]
  ResistanceParts parts;                ///< means over realisations [N m]
  Uncertain resistance;                 ///< dissipated per angle [N m]
  Uncertain spin_moment;                ///< mean [N m]
  Uncertain sum{nan(""),
                nan("")};  ///< M_ro cos + M_to sin of the contact's separate motions [N m]; NaN without both
  Uncertain spin_over_torsion{nan(""), nan("")};  ///< spin moment over what torsion alone resists with
  /// The rail's moment over `sum`.
  Uncertain over_sum() const;
};

/// Of a case whose program is one part that rolls freely and spins; none otherwise.
std::optional<double> rail_inclination(const SolvedCase& solved);

/// Adds the case to the contact's rails; false if its path ends before the motion is steady.
bool add_rail(MovingContact& contact, const SolvedCase& solved, double inclination);

/// Means over realisations, and the separate motions beside them.
void finish_rails(MovingContact& contact);

}  // namespace asperity

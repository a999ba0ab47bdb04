// Where a motion of a contact is steady, and its resistance there: the one definition that result.json,
// derive, compare and the study of resistances go by. SI units.
//
// A motion is cut into legs at its reversals. A leg is steady from its onset on, for three rows at least:
// - sliding: from the first row with at most 2 % of the active contact nodes sticking (nodes that have just
//   come into contact may stick while the contact slips as a whole); where none stick from the first row on,
//   as under little friction, from where the resistance has risen to 99 % of its mean behind, or falls. Where
//   a history does not say, from where the resistance has stopped to grow: two slopes in a row below a
//   fiftieth of the steepest of the first three steps.
// - spinning: likewise, or from 5 % on where the resistance has risen so: what lies at the axis sticks last,
//   and of a coarse mesh, or a contact of few spots, one node is more than 2 %. A twentieth of the area about
//   the axis has a hundredth of the moment under an even pressure (0.05^(3/2)), a fiftieth under Hertz'.
// - rolling: after a path length of two contact radii, when the contact that was pressed has been left, with
//   its slip and tractions. Smooth glass on silicon then dissipates 1.4 times what it does for good under a
//   friction of 0.5, and as much as for good under 0.1; after one radius 9 and 1.4 times.
// The resistance is the energy dissipated per path length or angle on the first pass, over surfaces not yet
// passed. The force has a conservative topographic part as well, which averages out over a long path only and
// dominates the mean force of a short one. Where a history has no energies, the mean force of all steady legs
// is taken: the conservative part changes its sign with the direction.
#pragma once

#include <cstddef>
#include <vector>

namespace asperity {

/// Rows between two reversals; the first is the turning point.
struct MotionLeg {
  std::size_t first = 0, last = 0;
  int direction = 1;
};
/// Rows that do not move belong to no leg or stay inside of one.
std::vector<MotionLeg> motion_legs(const std::vector<double>& position);

/// Columns that decide where a motion is steady.
struct MotionRows {
  std::vector<double> position;        ///< [m] or [rad]
  std::vector<double> resistance;      ///< [N] or [N m]
  std::vector<double> contact_radius;  ///< [m]; asked of a rolling motion alone
  std::vector<double> sticking;        ///< share of the active contact nodes; empty where it is not known
  double rolling_radius = 0;           ///< path length of the contact per angle [m]; 0: it does not roll
  bool spins = false;                  ///< about its normal: the position is an angle of torsion
};

inline constexpr std::size_t fewest_steady_rows = 3;
inline constexpr double radii_rolled_until_steady = 2;

/// First steady row of a leg; one past its last if fewer than three are.
std::size_t steady_onset(const MotionRows& rows, const MotionLeg& leg);

/// Rows of the first leg that are steady; none: last < first.
struct SteadyRows {
  std::size_t first = 1, last = 0;
  bool reached() const { return last > first; }
};
SteadyRows steady_rows_of_first_leg(const MotionRows& rows);

/// Growth of a sum (a work, an energy) between two rows over their distance.
double per_path_length(const std::vector<double>& position, const std::vector<double>& sum, std::size_t first,
                       std::size_t last);
/// Running integral of the resistance over the position.
std::vector<double> work_against_motion(const std::vector<double>& position,
                                        const std::vector<double>& resistance);

}  // namespace asperity

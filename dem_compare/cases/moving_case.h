// The steady resistance of one solved case that slid, rolled or spun: its mean force or moment, and what it
// dissipated per path length by mechanism. The second is far better known: the force of a short path is
// mostly its conservative topographic part, which rough surfaces give back, while dissipated energy only ever
// grows. Over a long path both agree. SI units.
//
// Where a path is steady, and that the first one counts, core/steady_motion.h defines; derive, compare and
// the study of resistances all take what is said here. It is cut into blocks of about a contact radius, four
// at least; how they differ gives the uncertainty (block_averages.h). The return path, a second pass, is
// told apart: what has yielded there need not yield again.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "dem_compare/cases/energy_history.h"
#include "dem_compare/cases/reversal_stiffness.h"
#include "dem_compare/numbers/uncertain.h"

namespace asperity {

/// Dissipated per path length [N], or per angle [N m]; the sum is as uncertain as it fluctuates itself.
struct ResistanceParts {
  /// By mechanism and in total.
  Uncertain friction{nan(""), nan("")}, plastic{nan(""), nan("")}, adhesion{nan(""), nan("")},
      total{nan(""), nan("")};
};

/// What resists, or the part of it that a mechanism dissipates; `force` is the mean force or moment.
enum class DissipationPart { total, friction, plastic, adhesion, force };

/// What was summed up along a steady path [J], row by row, so that paths over the same surfaces can be
/// compared block by block.
struct PathSums {
  std::vector<double> position;               ///< [m] or [rad]
  std::array<std::vector<double>, 5> energy;  ///< by DissipationPart
  double block = 0;                           ///< length of a block [m] or [rad]
};

/// The steady part of a path: its sums and what it dissipated.
struct SteadyPath {
  PathSums sums;
  ResistanceParts dissipated;
  Uncertain force{nan(""), nan("")};  ///< mean of force or moment against the motion
  double fluctuation =
      nan("");  ///< standard deviation of force or moment along the path: topography and junctions that slip
  double unbalanced = nan("");  ///< energy per path length that the balance of the computation leaves open
  double path = 0;              ///< [m] or [rad]
  int blocks = 0;
  double independent = 0;  ///< blocks that count as independent: of the dissipation, else of the force
  double drift = nan("");  ///< resistance of the second half less that of the first, over the mean
  double drift_error = nan("");

  bool reached() const { return blocks > 0; }
  /// Energy dissipated per path length where the history has it, else the mean force; the open balance counts
  /// as a standard deviation.
  Uncertain resistance() const;
  /// Of `total` the resistance.
  Uncertain of(DissipationPart part) const;
  /// By three standard errors and more than 2 %.
  bool still_changes() const;
};

struct MovingCase {
  std::string folder, seeds;                    ///< seeds of both surfaces
  double load = 0;                              ///< [N]
  double spacing = 0;                           ///< of the interface's mesh [m]
  double contact_radius = 0, contact_area = 0;  ///< as solved, mean over the steady path [m], [m^2]
  double largest_contact_radius = nan("");      ///< of the whole history [m]
  double path_in_radii = 0;                     ///< steady first path; of torsion that of the rim
  SteadyPath first, back;
  /// After a reversal [N/m] or [N m/rad]; of rolling, where energies are told, as a second pass, the mesh's
  /// part in its error.
  ReversalStiffness reversal;

  bool reached() const { return first.reached(); }
  bool has_energies() const { return std::isfinite(first.dissipated.total.value); }
  /// The steady resistance: what is dissipated on the first path; without energies the mean force of both
  /// paths.
  Uncertain resistance() const;
  /// [m] or [rad] on which the resistance is known.
  double steady_length() const { return first.path + (has_energies() || !back.reached() ? 0 : back.path); }
};

/// What the position in a history means.
struct PathOfMotion {
  Motion kind = Motion::sliding;  ///< or rolling, torsion
  double arm = 1;  ///< path of the contact over the surfaces per position: 1, or of rolling [m/rad]

  bool rolls() const { return kind == Motion::rolling; }
  /// Length of a block: the contact radius, for rolling as an angle; torsion: an angle of 1.
  double block_length(double contact_radius) const;
};
PathOfMotion path_of(const MotionMode& mode, double particle_radius);

/// Steady path between two rows of the history; the rows are those after the onset.
SteadyPath steady_path(const EnergyHistory& history, std::size_t first, std::size_t last, double block);

/// Throws InputError where the history lacks a column.
MovingCase moving_case(const SolvedCase& solved, const MotionMode& mode);
/// Of a motion that is told by a history of its own.
MovingCase moving_case(const SolvedCase& solved, const EnergyHistory& history, const PathOfMotion& motion);

/// The mode of motion of a case; nullptr for one that is only pressed.
const MotionMode* mode_of(const SolvedCase& solved);

}  // namespace asperity

// The simulation that a recording is set against, where it is more than reduced laws: a case that can be
// changed and solved again. app/ hands one in; the diagnosis knows nothing of how it solves. SI units.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/hertz.h"
#include "core/motion.h"
#include "core/relaxing_modulus.h"

namespace asperity {

/// An entry of the case, "Substrate/Yield stress", with another value [SI].
struct CaseChange {
  std::string entry;
  double value = 0;
  std::string unit;
};

/// How the contact is driven: from nothing to the largest force and, where it unloads, back.
struct LoadingProtocol {
  double largest_force = 0;  ///< [N]
  bool unloads = false;
  /// Above 0: driven by displacement up to this approach [m], to follow attraction, and not by the force.
  double approach = 0;
  double retract = 0;  ///< how far beyond first touch it is pulled, under control by displacement [m]
};

/// What one solved case says: approach and force of each accepted step, loading first.
struct SolvedResponse {
  std::vector<double> displacement;  ///< of far points, counted from first touch [m]
  std::vector<double> force;         ///< [N]
  std::size_t peak = 0;              ///< last step of loading
  double displacement_error = 0;     ///< standard deviation of the approach at the largest load, as stated:
                                     ///< of mesh and load steps [m]; NaN of a solution without its end
  double pull_off_error = 0;         ///< standard deviation of the pull-off force, as stated [N]; 0: of none
  std::string source;                ///< where it can be looked up
  std::string ended_early;           ///< why it ends before its protocol does; empty: it does not
  bool is_out_of_time = false;       ///< it ended early because it took too long
};

/// How a contact that was pressed is slid, rolled or spun: at a constant normal force, from rest.
struct MotionProtocol {
  Motion motion = Motion::sliding;  ///< or rolling, torsion
  double normal_force = 0;          ///< [N]
  double path = 0;                  ///< path length [m]; 0 of torsion: as the case gives its angle
  /// RMS roughness that the substrate's generated surface is scaled to [m]; none: as the case has it.
  std::optional<double> substrate_rms;
  /// Folder in which the case as it is was moved so already; empty: nowhere.
  std::string solved_in{};
};

/// What one case that was slid, rolled or spun says of its steady motion.
struct SolvedMotion {
  double normal_force = 0;              ///< [N]
  std::optional<double> substrate_rms;  ///< as asked for [m]
  /// Steady lateral force; of rolling that at the particle's centre: the energy lost per angle over its
  /// radius; of torsion the moment over it [N].
  double resistance = 0;
  double resistance_error = 0;  ///< its standard deviation, as stated: along the path, of mesh and steps [N]
  /// What may all be the mesh's, where no more than it makes of smooth elastic bodies was solved; half of it
  /// is in the resistance [N].
  double of_mesh = 0;
  double lateral_stiffness = 0;        ///< before anything slips [N/m]; 0: it is not stated
  double lateral_stiffness_error = 0;  ///< its standard deviation, as stated [N/m]
  std::string source;                  ///< where it can be looked up
};

/// By how much the approach under a force, from the smallest of these forces on, is another on another
/// realisation of the case's generated surfaces than on its own.
struct SurfaceChange {
  std::vector<double> force;         ///< rising, the first where an instrument sees the contact [N]
  std::vector<double> displacement;  ///< 0 at the first of them [m]
};

/// The case on other realisations of its surfaces.
struct OtherSurfaces {
  std::vector<SurfaceChange> changes;  ///< of one seed each; none: no surface is generated
  /// What the zero of the displacement may be off by: the case's own approach from first touch to where an
  /// instrument sees it, for single asperities bear next to nothing, or what the others' differs from it,
  /// root mean square, where that is more [m].
  double unseen = 0;
};

/// Why a solution that has come so far may end, as the end of a sentence; empty: it goes on.
using EnoughOfIt = std::function<std::string(const SolvedResponse& so_far)>;

/// The bodies of the case.
struct SimulatedBodies {
  ElasticBody particle, substrate;
  double radius = 0;  ///< [m]
  /// Yield stresses [Pa]; infinite: the body stays elastic.
  double particle_yield = std::numeric_limits<double>::infinity();
  double substrate_yield = std::numeric_limits<double>::infinity();
  bool is_smooth = true;  ///< neither has a topography
  double spacing = 0;     ///< of nodes where they can touch, as the case gives it [m]; 0: it derives it
  double friction_coefficient = 0;  ///< local mu of the interface [-]; 0: its law has none
  double adhesion_range = 0;        ///< [m]; 0: the case gives none
  double work_of_adhesion = 0;      ///< on approach [J/m^2]
  double work_of_separation = 0;    ///< of adhesion, on separation [J/m^2]
  double attraction_force = 0;      ///< beyond the contact [N]
  RelaxingPart particle_relaxation{}, substrate_relaxation{};  ///< of their shear moduli
  double substrate_rms = 0;  ///< of a generated substrate [m]; 0: it is smooth or a scan
  int unload_steps = 0;      ///< in which it is drawn back; 0: not known
};

/// A solution was stopped, for it took too long, before it said anything.
class OutOfTime : public WorkError {
 public:
  using WorkError::WorkError;
};

/// A simulation that is solved anew for each set of changes.
class ForwardModel {
 public:
  virtual ~ForwardModel() = default;
  /// Of the case as it is.
  virtual SimulatedBodies bodies() const = 0;
  /// Throws InputError where the case is none for recordings of normal contact.
  virtual void refuse_unless_normal() const {}
  /// Solves the case with these changes under each of the protocols; what was solved before is reused. A
  /// solution ends early where `enough` (asked after its steps; none: never) says so, or where it would take
  /// too long. Throws WorkError where a case cannot be solved at all, and OutOfTime.
  virtual std::vector<SolvedResponse> solve(const std::vector<CaseChange>& changes,
                                            const std::vector<LoadingProtocol>& protocols,
                                            const EnoughOfIt& enough) = 0;
  /// The case as it is on other realisations of its surfaces, up to a force [N]: an experiment has one of its
  /// own. None where no surface is generated.
  virtual OtherSurfaces on_other_surfaces(double) { return {}; }
  /// How the case as it is was moved in solutions that are at hand.
  virtual std::vector<MotionProtocol> solved_motions(Motion) { return {}; }
  /// Slides, rolls or spins the case with these changes under each of the protocols, likewise; `must_end`:
  /// whatever it takes.
  virtual std::vector<SolvedMotion> move(const std::vector<CaseChange>& changes,
                                         const std::vector<MotionProtocol>& protocols, bool must_end) = 0;
};

}  // namespace asperity

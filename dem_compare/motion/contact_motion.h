// Relative motion over a finite step, from the places of the bodies before and after it. The counterpart of
// relative_velocity.h that stays objective for steps and observers' rotations of any size: every quantity is
// formed in a frame that turns with the contact, so no error of small angles is left for an observer to see.
// The frame turns with the bodies, then the shortest way onto the new normal. Projecting histories onto the
// new plane alone would let them stand still while an observer, or the whole pair, spins about the normal. SI
// units.
#pragma once

#include <Eigen/Geometry>

namespace asperity {

/// Where a body is.
struct Placement {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
};

/// Arm from the particle's centre to the point where the contact force acts.
enum class LeverArm {
  distance_to_contact,  ///< r = R - delta on a plane, R - delta/2 between spheres (Luding 2008)
  particle_radius,      ///< R: what some engines do (LAMMPS' walls)
};

/// Whose spin about the normal a history of sliding and rolling follows. Both are objective; they differ by
/// half the torsion.
enum class HistorySpin {
  mean_of_bodies,  ///< Kuhn & Bagi 2004; the same seen from either body
  other_body,      ///< on a plane that does not turn: none, as in the paper and in most engines' walls
};

struct ContactMotion {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< after the step, from the contact to the particle
  double approach = 0;                                ///< delta after the step [m]; negative: a gap
  double lever = 0;                                   ///< of the particle [m]
  Eigen::Quaterniond frame_rotation =
      Eigen::Quaterniond::Identity();  ///< of the contact; histories turn with it
  Eigen::Vector3d sliding =
      Eigen::Vector3d::Zero();  ///< shift of the particle's surface against the other [m]
  Eigen::Vector3d rolling =
      Eigen::Vector3d::Zero();  ///< relative rotation about axes in the contact plane [rad]
  double torsion = 0;           ///< relative rotation about the normal [rad]
};

/// A plane through `position`; its normal points towards the particle and turns with `orientation` from
/// `normal`.
struct PlanePlacement : Placement {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
};

/// The step's relative motion, by mode. radius [m].
ContactMotion sphere_on_plane(const Placement& sphere_before, const Placement& sphere, double radius,
                              const PlanePlacement& plane_before, const PlanePlacement& plane, LeverArm lever,
                              HistorySpin spin = HistorySpin::mean_of_bodies);

/// `particle` is the sphere the contact's force and moment are told of.
ContactMotion sphere_on_sphere(const Placement& particle_before, const Placement& particle, double radius,
                               const Placement& other_before, const Placement& other, double other_radius,
                               LeverArm lever, HistorySpin spin = HistorySpin::mean_of_bodies);

/// Rotation as axis times angle, angle in [0, pi].
Eigen::Vector3d rotation_vector(const Eigen::Quaterniond& rotation);
/// Rotation about the direction of `vector` by its length [rad].
Eigen::Quaterniond rotation_by(const Eigen::Vector3d& vector);

}  // namespace asperity

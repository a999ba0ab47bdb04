// Relative motion of two bodies at their contact, split into four parts (Luding 2008, Granular Matter 10:235;
// Kuhn & Bagi 2004). n points from the contact to the particle, r and r' are the lever arms from the centres
// to the contact:
//   v = v_p - v_o + r n x w_p + r' n x w_o     velocity of the particle's surface against the other one
//   approach  d(delta)/dt = -v.n               (positive while the bodies close; the sign of n makes it so)
//   sliding   v - (v.n) n
//   rolling   w - (w.n) n,   w = w_p - w_o;    as a velocity r (w x n)
//   torsion   w.n
// All four are objective: observers who translate and turn in any way see the same motion, in their own axes.
// SI units.
#pragma once

#include <Eigen/Core>

namespace asperity {

/// Place and velocities of one body.
struct BodyVelocity {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();          ///< of the centre [m]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          ///< of the centre [m/s]
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< [rad/s]
};

struct RelativeVelocity {
  double approach = 0;                                ///< d(delta)/dt [m/s]
  Eigen::Vector3d sliding = Eigen::Vector3d::Zero();  ///< in the contact plane [m/s]
  Eigen::Vector3d rolling =
      Eigen::Vector3d::Zero();  ///< relative rotation about axes in the contact plane [rad/s]
  double torsion = 0;           ///< relative rotation about n [rad/s]
};

/// `contact`: the point where both surfaces meet; `normal`: from it to the particle's centre, of unit length.
inline RelativeVelocity relative_velocity(const BodyVelocity& particle, const BodyVelocity& other,
                                          const Eigen::Vector3d& contact, const Eigen::Vector3d& normal) {
  const auto surface_velocity = [&](const BodyVelocity& body) -> Eigen::Vector3d {
    return body.velocity + body.angular_velocity.cross(contact - body.position);
  };
  const Eigen::Vector3d v = surface_velocity(particle) - surface_velocity(other),
                        w = particle.angular_velocity - other.angular_velocity;
  return {-v.dot(normal), v - v.dot(normal) * normal, w - w.dot(normal) * normal, w.dot(normal)};
}

}  // namespace asperity

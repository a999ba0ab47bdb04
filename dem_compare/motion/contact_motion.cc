#include "dem_compare/motion/contact_motion.h"

#include <cmath>

namespace asperity {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

Quaterniond turn_between(const Placement& before, const Placement& after) {
  return after.orientation * before.orientation.conjugate();
}

/// Mean of two rotations: an observer's rotations before and after the step multiply it from both sides.
Quaterniond mean_rotation(const Quaterniond& one, const Quaterniond& other) {
  const double sign = one.dot(other) < 0 ? -1 : 1;
  return Quaterniond(one.coeffs() + sign * other.coeffs()).normalized();
}

Quaterniond frame_rotation(const Quaterniond& particle, const Quaterniond& other,
                           const Vector3d& normal_before, const Vector3d& normal, HistorySpin spin) {
  const Quaterniond carried = spin == HistorySpin::other_body ? other : mean_rotation(particle, other);
  return Quaterniond::FromTwoVectors(carried * normal_before, normal) * carried;
}

Vector3d tangential(const Vector3d& v, const Vector3d& normal) { return v - v.dot(normal) * normal; }

}  // namespace

Vector3d rotation_vector(const Quaterniond& rotation) {
  const double sign = rotation.w() < 0 ? -1 : 1, size = rotation.vec().norm();
  if (size == 0) return Vector3d::Zero();
  return sign * 2 * std::atan2(size, sign * rotation.w()) / size * rotation.vec();
}

Quaterniond rotation_by(const Vector3d& vector) {
  const double angle = vector.norm();
  if (angle == 0) return Quaterniond::Identity();
  const Vector3d axis = std::sin(angle / 2) / angle * vector;
  return {std::cos(angle / 2), axis.x(), axis.y(), axis.z()};
}

ContactMotion sphere_on_plane(const Placement& sphere_before, const Placement& sphere, double radius,
                              const PlanePlacement& plane_before, const PlanePlacement& plane, LeverArm lever,
                              HistorySpin spin) {
  const Quaterniond sphere_turn = turn_between(sphere_before, sphere),
                    plane_turn = turn_between(plane_before, plane);
  const Vector3d from_plane = sphere.position - plane.position,
                 carried = plane_turn * (sphere_before.position - plane_before.position);
  ContactMotion motion;
  motion.normal = plane.orientation * plane.normal;
  motion.approach = radius - from_plane.dot(motion.normal);
  motion.lever = lever == LeverArm::particle_radius ? radius : radius - motion.approach;
  motion.frame_rotation = frame_rotation(sphere_turn, plane_turn,
                                         plane_before.orientation * plane_before.normal, motion.normal, spin);
  const Vector3d rotation = rotation_vector(sphere_turn * plane_turn.conjugate());
  motion.sliding =
      tangential(from_plane - carried, motion.normal) - motion.lever * rotation.cross(motion.normal);
  motion.rolling = tangential(rotation, motion.normal);
  motion.torsion = rotation.dot(motion.normal);
  return motion;
}

ContactMotion sphere_on_sphere(const Placement& particle_before, const Placement& particle, double radius,
                               const Placement& other_before, const Placement& other, double other_radius,
                               LeverArm lever, HistorySpin spin) {
  const Quaterniond turn = turn_between(particle_before, particle),
                    other_turn = turn_between(other_before, other);
  const Vector3d between_centres = particle.position - other.position;
  ContactMotion motion;
  motion.normal = between_centres.normalized();
  motion.approach = radius + other_radius - between_centres.norm();
  const double cut = lever == LeverArm::particle_radius ? 0 : motion.approach / 2;
  motion.lever = radius - cut;
  motion.frame_rotation = frame_rotation(
      turn, other_turn, (particle_before.position - other_before.position).normalized(), motion.normal, spin);
  // Rotations of the bodies in the frame of the contact, where the centres do not move sideways.
  const Quaterniond back = motion.frame_rotation.conjugate();
  const Vector3d rotation = rotation_vector(turn * back), other_rotation = rotation_vector(other_turn * back);
  motion.sliding = -(motion.lever * rotation + (other_radius - cut) * other_rotation).cross(motion.normal);
  const Vector3d relative = rotation - other_rotation;
  motion.rolling = tangential(relative, motion.normal);
  motion.torsion = relative.dot(motion.normal);
  return motion;
}

}  // namespace asperity

#include "dem_compare/motion/contact_model.h"

#include <algorithm>

namespace asperity {
namespace {

using Eigen::Vector3d;

struct Resistances {
  double normal = 0;
  Vector3d sliding, rolling;
  double torsion = 0;
};

void exert(ContactModelState& state, const Resistances& q) {
  state.lateral = -q.sliding;
  state.force = q.normal * state.direction + state.lateral;
  state.moment =
      -state.lever * state.direction.cross(state.lateral) - q.rolling - q.torsion * state.direction;
}

/// Cut to a length.
Vector3d cut_to(const Vector3d& value, double limit) {
  const double size = value.norm();
  return size > limit ? Vector3d(value * (limit / size)) : value;
}

}  // namespace

ContactModelState advance(const ContactModel& model, const ContactModelState& before,
                          const ContactMotion& motion) {
  ContactModelState now;
  now.direction = motion.normal;
  now.lever = motion.lever;
  now.normal = model.normal->advance(before.normal, motion.approach);

  SlidingHistory sliding = before.sliding;
  sliding.rotate(motion.frame_rotation);
  now.sliding = model.sliding->advance(sliding, now.normal, motion.sliding);

  RollingHistory rolling = before.rolling;
  rolling.resistance = motion.frame_rotation * rolling.resistance;
  now.rolling = model.rolling->advance(rolling, now.normal, now.lever, motion.rolling);
  now.torsion = model.torsion->advance(before.torsion, now.normal, now.lever, motion.torsion);

  exert(now,
        {now.normal.force, now.sliding.spring.resistance, now.rolling.resistance, now.torsion.resistance});
  return now;
}

ContactModelState advance(const ContactModel& model, const ContactModelState& before,
                          const ContactMotion& motion, const RelativeVelocity& rate, double mass) {
  ContactModelState now = advance(model, before, motion);
  if (!now.normal.touching) return now;
  const double gamma = model.damping->factor(mass, now.normal.stiffness);
  const double rolling_arm = now.lever * model.rolling->length(now.normal, now.lever),
               torsion_arm = now.lever * model.torsion->length(now.normal, now.lever);
  const double torsion_limit = model.torsion->limit(now.normal, now.lever);
  exert(now,
        {now.normal.force + gamma * rate.approach,
         cut_to(now.sliding.spring.resistance + gamma * rate.sliding, model.sliding->limit(now.normal.force)),
         cut_to(now.rolling.resistance + gamma * rolling_arm * rate.rolling,
                model.rolling->limit(now.normal, now.lever)),
         std::clamp(now.torsion.resistance + gamma * torsion_arm * rate.torsion, -torsion_limit,
                    torsion_limit)});
  return now;
}

}  // namespace asperity

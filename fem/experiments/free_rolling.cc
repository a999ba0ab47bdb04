#include "fem/experiments/free_rolling.h"

#include <cmath>

namespace asperity::fem {
namespace {

/// True while a contact that begins to roll freely has not yet left behind the lateral force that an earlier motion put there.
bool is_left_from_before(const std::vector<Station>& program, const std::vector<StepRecord>& records, const RollingContact& contact) {
  std::size_t begin = records.size() - 1;  // the last station that did not roll freely
  while (begin > 0 && program[begin].rolls_freely) --begin;
  constexpr double little = 0.02;
  if (std::abs(records[begin].lateral_force) <= little * records[begin].normal_force) return false;
  return std::abs(records.back().rolling_angle - records[begin].rolling_angle) * contact.radius < contact.hertz_radius;
}

}  // namespace

RollingStep free_rolling(const std::vector<Station>& program, const std::vector<StepRecord>& records, const RollingContact& contact) {
  RollingStep step{contact.radius, 0};
  if (contact.lateral_stiffness <= 0) return step;
  const StepRecord& last = records.back();
  step.back = last.lateral_force / contact.lateral_stiffness;
  if (is_left_from_before(program, records, contact)) {
    step.way_per_angle = contact.radius - last.normal_displacement;
    return step;
  }
  if (records.size() < 2) return step;
  const StepRecord& before = records[records.size() - 2];
  const double rolled = last.rolling_angle - before.rolling_angle;
  if (rolled != 0 && program[records.size() - 1].rolls_freely)
    step.way_per_angle = (last.shift - before.shift + before.lateral_force / contact.lateral_stiffness - 0.25 * step.back) / rolled;
  return step;
}

}  // namespace asperity::fem

#include "fem/programs/free_rolling.h"

#include <cmath>

namespace asperity::fem {
namespace {

/// Of the lateral force, what acts along the rolling direction.
double along(const HistoryRow& r) {
  return std::cos(r.torsion_angle) * r.lateral_force + std::sin(r.torsion_angle) * r.lateral_force_across;
}

double path_between(const HistoryRow& a, const HistoryRow& b) {
  const double heading = 0.5 * (a.torsion_angle + b.torsion_angle);
  return std::cos(heading) * (b.shift - a.shift) + std::sin(heading) * (b.shift_across - a.shift_across);
}

/// True while a contact that begins to roll freely has not yet left behind the lateral force that an earlier
/// motion put there.
bool is_left_from_before(const std::vector<Station>& program, const std::vector<HistoryRow>& records,
                         const RollingContact& contact) {
  std::size_t begin = records.size() - 1;  // the last station that did not roll freely
  while (begin > 0 && program[begin].rolls_freely) --begin;
  constexpr double little = 0.02;
  if (std::abs(along(records[begin])) <= little * records[begin].normal_force) return false;
  return std::abs(records.back().rolling_angle - records[begin].rolling_angle) * contact.radius <
         contact.hertz_radius;
}

}  // namespace

RollingStep free_rolling(const std::vector<Station>& program, const std::vector<HistoryRow>& records,
                         const RollingContact& contact) {
  RollingStep step{contact.radius, 0};
  if (contact.lateral_stiffness <= 0) return step;
  const HistoryRow& last = records.back();
  step.back = along(last) / contact.lateral_stiffness;
  if (is_left_from_before(program, records, contact)) {
    step.path_per_angle = contact.radius - last.normal_displacement;
    return step;
  }
  if (records.size() < 2) return step;
  const HistoryRow& before = records[records.size() - 2];
  const double rolled = last.rolling_angle - before.rolling_angle;
  if (rolled != 0 && program[records.size() - 1].rolls_freely)
    step.path_per_angle =
        (path_between(before, last) + along(before) / contact.lateral_stiffness - 0.25 * step.back) / rolled;
  return step;
}

}  // namespace asperity::fem

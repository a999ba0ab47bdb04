#include "fem/experiments/delayed_far_field.h"

#include <cmath>

namespace asperity::fem {

void DelayedFarField::measure(ContactSolver& solver, const std::array<J2Material, 2>& bodies, double radius,
                              double far_field, double lateral_far_field) {
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Relaxation& law = bodies[b].relaxation;
    if (!law.is_there()) continue;
    std::array<J2Material, 2> slow = bodies;
    slow[b].shear_modulus *= 1 - law.share;
    growth_[b] = solver.far_field_compliance(radius, &slow) - far_field;
    lateral_growth_[b] = solver.lateral_far_field_compliance(radius, &slow) - lateral_far_field;
    retardation_[b] = law.time / (1 - law.share);
  }
}

double DelayedFarField::crept(const Growth& growth, const std::vector<HistoryRow>& rows,
                              const HistoryRow& now, double HistoryRow::*force) const {
  double sum = 0;
  for (std::size_t b = 0; b < growth.size(); ++b) {
    if (growth[b] == 0) continue;
    double part = 0, last_time = 0, last = 0;  // of a force that is borne for ever
    const auto go_on = [&](const HistoryRow& row) {
      const double x = (row.time - last_time) / retardation_[b];
      if (x > 0) {
        const double left = std::exp(-x), mean = -std::expm1(-x) / x;
        part = part * left + last * (mean - left) + row.*force * (1 - mean);
      }
      last_time = row.time, last = row.*force;
    };
    for (const HistoryRow& row : rows) go_on(row);
    go_on(now);
    sum += growth[b] * part;
  }
  return sum;
}

}  // namespace asperity::fem

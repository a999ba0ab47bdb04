// What bodies that relax give way far from the contact, where a mesh of finite bodies differs from
// half-spaces: the compliance that `far_field_compliance` measures is that of fast loading, and creeps.
#pragma once

#include <array>
#include <vector>

#include "fem/contact/contact_solver.h"
#include "results/history.h"

namespace asperity::fem {

class DelayedFarField {
 public:
  /// Measures by how much the compliance of finite bodies grows as each of them relaxes, beside that of fast
  /// loading; under Hertz' pressure of a radius [m]. Collective.
  void measure(ContactSolver& solver, const std::array<J2Material, 2>& bodies, double radius,
               double far_field, double lateral_far_field);

  /// What has crept since the beginning [m], the force of `rows` and then of `now` changing evenly from row
  /// to row: each body's part with tau/(1 - g), the retardation time at constant Poisson ratio.
  double approach(const std::vector<HistoryRow>& rows, const HistoryRow& now) const {
    return crept(growth_, rows, now, &HistoryRow::normal_force);
  }
  /// The same of the shift [m].
  double shift(const std::vector<HistoryRow>& rows, const HistoryRow& now) const {
    return crept(lateral_growth_, rows, now, &HistoryRow::lateral_force);
  }

 private:
  /// Of the compliance, as particle and substrate relax [m/N].
  using Growth = std::array<double, 2>;
  double crept(const Growth& growth, const std::vector<HistoryRow>& rows, const HistoryRow& now,
               double HistoryRow::*force) const;

  Growth growth_{}, lateral_growth_{};
  std::array<double, 2> retardation_{};  ///< [s]
};

}  // namespace asperity::fem

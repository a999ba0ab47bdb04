// A contact of Hertz with partial slip, led along given paths: borosilicate on silicon.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

#include "core/shear_moduli.h"
#include "dem_compare/laws/hertz_offset.h"
#include "dem_compare/laws/mindlin_deresiewicz.h"

namespace asperity::test::partial_slip {

using Eigen::Vector3d;
inline constexpr double radius = 8.5e-6, mu = 0.3, load = 1e-4;
inline const ElasticBody borosilicate{71e9, 0.17}, silicon{179e9, 0.25};
inline const HertzOffset hertz{reduced_modulus(borosilicate, silicon), radius, 0};
inline const double shear = reduced_shear_modulus(borosilicate, silicon);
inline const MindlinDeresiewicz law{shear, radius, {mu, 0}};

/// One contact of Hertz with partial slip, led along straight lines of approach and shift.
struct Contact {
  NormalState normal;
  SlidingHistory history;
  double shift = 0;

  void press(double force) { lead(force, shift); }
  void lead(double force, double to_shift, Vector3d direction = Vector3d::UnitX()) {
    normal = hertz.advance(normal, hertz.approach(force));
    history = law.advance(history, normal, (to_shift - shift) * direction);
    shift = to_shift;
  }
  double force() const { return history.spring.resistance.x(); }
  /// Shift that reaches a lateral force, with the load changing to `normal_force` on the way, in `steps`
  /// parts.
  void lead_to_force(double normal_force, double lateral_force, int steps = 1) {
    const double first_load = normal.force, first_force = force();
    for (int i = 1; i <= steps; ++i) {
      const double p = first_load + (normal_force - first_load) * i / steps,
                   q = first_force + (lateral_force - first_force) * i / steps;
      const double reach =
          4 * law.gross_slip_shift(hertz.advance({}, hertz.approach(std::max(p, first_load))));
      std::uintmax_t iterations = 200;
      const auto missing = [&](double to) {
        Contact trial = *this;
        trial.lead(p, to);
        return trial.force() - q;
      };
      const auto bracket = boost::math::tools::toms748_solve(
          missing, shift - reach, shift + reach, boost::math::tools::eps_tolerance<double>(), iterations);
      lead(p, (bracket.first + bracket.second) / 2);
    }
  }
};

/// 3 mu P/(16 G* a), the shift at gross slip under the first load.
inline double unit_shift() { return law.gross_slip_shift(hertz.advance({}, hertz.approach(load))); }
inline double virgin_shift(double q) { return 1 - std::pow(1 - q, 2.0 / 3); }

}  // namespace asperity::test::partial_slip

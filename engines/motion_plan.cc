// How fast and how far an engine moves the particle.
#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/quantity.h"
#include "engines/experiment.h"

namespace asperity {
namespace {

bool is_free(const EngineExperiment& e) { return e.type == Motion::rolling || e.type == Motion::rail; }

/// Springs on the sphere [N/m] and its angular frequencies [rad/s].
struct Vibrations {
  double lateral = 0;
  double fastest = 0, slowest = 0;
};

Vibrations vibrations(const EngineExperiment& e, const ClosedForm& form) {
  const double mass = e.mass(), R = e.substrate.particle.radius, inertia = 0.4 * mass * R * R;
  const int slopes = e.type == Motion::rail ? 2 : 1;
  double normal = slopes * e.substrate.normal_stiffness_at(e.load),
         lateral = slopes * e.substrate.lateral_stiffness_at(e.load);
  if (!is_free(e)) return {lateral, std::sqrt(normal / mass), std::sqrt(std::min(normal, lateral) / mass)};
  normal += e.indenter.normal_stiffness_at(e.indenter_load());
  lateral += e.indenter.lateral_stiffness_at(e.indenter_load());
  // The sphere turns on its lateral springs, and rolls without sliding against those of rolling and torsion.
  const double turning = std::sqrt((lateral * R * R + form.rolling_stiffness) / inertia),
               lever = R * e.rail_cosine();
  const double rolling = std::sqrt(form.rolling_stiffness / (inertia + mass * lever * lever));
  return {lateral, std::max(std::sqrt(normal / mass), turning),
          std::min(std::sqrt(std::min(normal, lateral) / mass), rolling)};
}

/// Speeds of the drive [m/s or rad/s].
struct Speeds {
  double slow = 0;  ///< where stiffness is measured
  double fast = 0;  ///< between
};

Speeds speeds(const EngineExperiment& e, const ClosedForm& form, const Vibrations& vibration,
              double time_step) {
  constexpr double steps_to_slide = 100;   // prescribed: no inertia
  constexpr double steps_to_twist = 1000;  // cheap, and a limit laid on by a hook lags by one step
  constexpr double travel_haste = 10;
  if (!is_free(e)) {
    const double slow =
        form.first_yield / ((e.type == Motion::torsion ? steps_to_twist : steps_to_slide) * time_step);
    return {e.haste * slow, e.haste * travel_haste * slow};
  }
  constexpr double periods_to_yield = 40;  // inertia is 1/(2 pi 40) of the limit
  // A free sphere that is taken along too fast slides: its momentum must stay far below what friction can
  // give.
  constexpr double share_of_friction = 0.01;
  const double friction =
      std::min(e.substrate.sliding_limit(e.load), e.indenter.sliding_limit(e.indenter_load()));
  const double slow = form.first_yield * vibration.slowest / (2 * M_PI * periods_to_yield);
  return {e.haste * slow,
          e.haste * std::max(slow, share_of_friction * friction / std::sqrt(vibration.lateral * e.mass()))};
}

/// Way from rest to each reversal; throws InputError where it does not reach all limits.
double checked_path(const EngineExperiment& e, const ClosedForm& form, double start) {
  const double way = e.type == Motion::rail ? 2 * e.amplitude : e.amplitude;
  // Before a reversal all limits must have been reached, and after it once more, over twice the travel.
  const double least = 2 * std::max(start, form.full_yield);
  if (way >= least) return way;
  constexpr double rounding_up = 1.01;  // of the message
  throw InputError("an amplitude of " + format_quantity(e.amplitude, Dimension::length) +
                   " does not reach all the limits of this contact; take at least " +
                   format_quantity(rounding_up * least * e.amplitude / way, Dimension::length));
}

}  // namespace

MotionPlan plan_motion(const EngineExperiment& e) {
  constexpr double steps_per_period = 30, settling_periods = 40, half_critical = 0.5;
  constexpr double start_over_yield = 3;  // a slow start or reversal goes on this far beyond the first yield
  constexpr long rows_per_leg = 400, rows_to_see_rest = 10;
  if (!(e.load > 0)) throw InputError("the normal load must be above zero");
  if (!(e.haste > 0)) throw InputError("the factor on the speed must be above zero");

  const double mass = e.mass();
  const ClosedForm form = closed_form(e);
  const Vibrations vibration = vibrations(e, form);
  MotionPlan plan;
  plan.time_step = 2 * M_PI / vibration.fastest / steps_per_period;
  plan.damping = 2 * half_critical * std::sqrt(e.substrate.normal_stiffness_at(e.load) / mass);
  const Speeds speed = speeds(e, form, vibration, plan.time_step);
  const auto add = [&](Leg::Purpose purpose, double distance, double at) {
    const long steps = std::max(2L, std::lround(std::abs(distance) / (at * plan.time_step)));
    plan.legs.push_back({purpose, distance, steps, std::max(1L, steps / rows_per_leg)});
  };

  const double start = start_over_yield * form.first_yield, turn = 2 * start;
  if (e.type == Motion::torsion) {
    add(Leg::Purpose::start, start, speed.slow);
    add(Leg::Purpose::reversal, -turn, speed.slow);
    return plan;
  }
  const double way = checked_path(e, form, start);
  const long settling = std::lround(settling_periods * 2 * M_PI / vibration.slowest / plan.time_step);
  plan.legs.push_back({Leg::Purpose::settle, 0, settling, std::max(1L, settling / rows_to_see_rest)});
  add(Leg::Purpose::start, start, speed.slow);
  add(Leg::Purpose::travel, way - 2 * start, speed.fast);
  add(Leg::Purpose::before_reversal, start, speed.slow);
  if (e.type == Motion::rail) return plan;
  for (const double sign : {-1.0, 1.0}) {
    add(Leg::Purpose::reversal, sign * turn, speed.slow);
    if (2 * way > turn + start) add(Leg::Purpose::travel, sign * (2 * way - turn - start), speed.fast);
    add(Leg::Purpose::before_reversal, sign * start, speed.slow);
  }
  return plan;
}

}  // namespace asperity

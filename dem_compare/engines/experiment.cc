#include "dem_compare/engines/experiment.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "core/error.h"
#include "core/nearest_name.h"
#include "core/quantity.h"

namespace asperity {
namespace {

constexpr double pi = boost::math::double_constants::pi;
using Type = EngineExperiment::Type;

const std::vector<std::pair<std::string, Type>>& type_names() {
  static const std::vector<std::pair<std::string, Type>> names{
      {"glued", Type::glued}, {"rolling", Type::rolling}, {"rail", Type::rail}, {"twisting", Type::twisting}};
  return names;
}

/// Springs that resist the rotation phi of the free sphere, and the angles at which the first and the last of them yield.
struct RotationSprings {
  double stiffness = 0;    ///< [N m/rad]
  double limit = 0;        ///< torque when all have yielded [N m]
  double first_yield = 0, last_yield = 0;  ///< [rad]
};

RotationSprings rotation_springs(const EngineExperiment& e) {
  const double c = e.rail_cosine(), s = std::sqrt(std::max(0.0, 1 - c * c));
  const double K_i = e.indenter.rolling_stiffness_at(e.indenter_load()), M_i = e.indenter.rolling_limit(e.indenter_load());
  const double K_s = e.substrate.rolling_stiffness_at(e.load), M_s = e.substrate.rolling_limit(e.load);
  const double yield_i = M_i / K_i, yield_s = M_s / (K_s * c);
  if (e.type == Type::rolling) return {K_i + K_s, M_i + M_s, std::min(yield_i, yield_s), std::max(yield_i, yield_s)};
  // Each slope sees phi cos(theta) as rolling and phi sin(theta) as torsion; eq:torsion of the paper for the limits.
  const double K_t = e.substrate.torsion_stiffness_at(e.load), M_t = e.substrate.torsion_limit(e.load);
  const double yield_t = M_t / (K_t * s);
  return {K_i + 2 * c * c * K_s + 2 * s * s * K_t, M_i + 2 * c * M_s + 2 * s * M_t, std::min({yield_i, yield_s, yield_t}),
          std::max({yield_i, yield_s, yield_t})};
}

/// Free sphere: plate, rotation and substrate springs in series. With f the force at the plate, x the sphere's way and k the
/// lateral springs: R(1 + c) f = K phi, x = R c phi + f/k_s, X = x + R phi + f/k_i, c = cos(theta), k_s of all slopes.
ClosedForm free_sphere(const EngineExperiment& e) {
  const double c = e.rail_cosine(), R = e.substrate.particle.radius, lever = R * (1 + c);
  const int slopes = e.type == Type::rail ? 2 : 1;
  const RotationSprings springs = rotation_springs(e);
  ClosedForm form;
  const double sliding = 1 / (slopes * e.substrate.lateral_stiffness_at(e.load)) + 1 / e.indenter.lateral_stiffness_at(e.indenter_load());
  const double compliance = lever * lever / springs.stiffness + sliding;
  form.slope = 1 / compliance;
  form.first_yield = springs.stiffness * springs.first_yield / lever * compliance;
  form.plateau = springs.limit / lever;
  form.full_yield = lever * springs.last_yield + sliding * form.plateau;
  form.rotation = 1 / lever;
  form.rolling_stiffness = springs.stiffness;
  return form;
}

}  // namespace

double EngineExperiment::rail_cosine() const { return type == Type::rail ? std::cos(rail_angle) : 1; }

double EngineExperiment::indenter_load() const { return type == Type::rail ? 2 * rail_cosine() * load : load; }

double EngineExperiment::mass() const {
  const double density = substrate.particle.density, R = substrate.particle.radius;
  if (!std::isfinite(density))
    throw InputError(substrate.file + ": 'particle/density' [kg/m^3] is missing, which a dynamic engine needs");
  return 4.0 / 3 * pi * R * R * R * density;
}

Type engine_experiment_type(const std::string& name) {
  std::vector<std::string> names;
  std::string list;
  for (const auto& [known, type] : type_names()) {
    if (known == name) return type;
    names.push_back(known);
    list += (list.empty() ? "" : ", ") + known;
  }
  const std::string meant = nearest_name(name, names);
  throw InputError("there is no experiment '" + name + "'; " +
                   (meant.empty() ? "there are " + list : "did you mean '" + meant + "'?"));
}

std::string engine_experiment_name(Type type) {
  for (const auto& [name, known] : type_names())
    if (known == type) return name;
  return "";
}

ClosedForm closed_form(const EngineExperiment& e) {
  ClosedForm form;
  switch (e.type) {
    case Type::glued:
      form.slope = e.substrate.lateral_stiffness_at(e.load);
      form.plateau = e.substrate.sliding_limit(e.load);
      form.first_yield = form.plateau / form.slope;
      break;
    case Type::twisting:
      form.slope = e.substrate.torsion_stiffness_at(e.load);
      form.plateau = e.substrate.torsion_limit(e.load);
      form.first_yield = form.plateau / form.slope;
      break;
    case Type::rolling:
    case Type::rail: form = free_sphere(e); break;
  }
  if (form.full_yield == 0) form.full_yield = form.first_yield;
  form.approach = e.substrate.hertz().approach(e.load);
  return form;
}

MotionPlan plan_motion(const EngineExperiment& e) {
  constexpr double steps_per_period = 30, half_critical = 0.5;
  constexpr double steps_to_yield = 100;      // of sliding, which is prescribed: no inertia
  constexpr double steps_to_twist = 1000;     // of spinning: cheap, and a limit laid on by a hook lags by one step
  constexpr double periods_to_yield = 40;     // of a free sphere: 1/(2 pi 40) of the limit is inertia
  constexpr double travel_haste = 10;         // speed between the stiffness measurements, prescribed motions
  constexpr double start_over_yield = 3;      // a slow start or reversal goes on this far beyond the first yield
  constexpr double settling_periods = 40;
  constexpr long rows_per_leg = 400, rows_to_see_rest = 10;
  if (!(e.load > 0)) throw InputError("the normal load must be above zero");
  if (!(e.haste > 0)) throw InputError("the factor on the speed must be above zero");

  const bool is_free = e.type == Type::rolling || e.type == Type::rail;
  const double mass = e.mass(), R = e.substrate.particle.radius, inertia = 0.4 * mass * R * R;
  const ClosedForm form = closed_form(e);
  const int slopes = e.type == Type::rail ? 2 : 1;
  double normal = slopes * e.substrate.normal_stiffness_at(e.load);
  double lateral = slopes * e.substrate.lateral_stiffness_at(e.load);
  double shortest = std::sqrt(normal / mass);  // angular frequencies
  if (is_free) {
    normal += e.indenter.normal_stiffness_at(e.indenter_load());
    lateral += e.indenter.lateral_stiffness_at(e.indenter_load());
    shortest = std::max(std::sqrt(normal / mass), std::sqrt((lateral * R * R + form.rolling_stiffness) / inertia));
  }
  double longest = std::sqrt(std::min(normal, lateral) / mass);
  if (is_free) {  // pure rolling against the springs of rolling and torsion
    const double lever = R * e.rail_cosine();
    longest = std::min(longest, std::sqrt(form.rolling_stiffness / (inertia + mass * lever * lever)));
  }
  MotionPlan plan;
  plan.time_step = 2 * pi / shortest / steps_per_period;
  plan.damping = 2 * half_critical * std::sqrt(e.substrate.normal_stiffness_at(e.load) / mass);

  const double period = 2 * pi / longest;
  const double prescribed_steps = e.type == Type::twisting ? steps_to_twist : steps_to_yield;
  const double slow = e.haste * (is_free ? form.first_yield / (periods_to_yield * period)
                                         : form.first_yield / (prescribed_steps * plan.time_step));
  // A free sphere that is taken along too fast slides: its momentum must stay far below what friction can give.
  constexpr double share_of_friction = 0.01;
  const double fast = is_free ? e.haste * share_of_friction *
                                    std::min(e.substrate.sliding_limit(e.load), e.indenter.sliding_limit(e.indenter_load())) /
                                    std::sqrt(lateral * mass)
                              : travel_haste * slow;
  const auto add = [&](Leg::Purpose purpose, double distance, double speed) {
    const long steps = std::max(2L, std::lround(std::abs(distance) / (speed * plan.time_step)));
    plan.legs.push_back({purpose, distance, steps, std::max(1L, steps / rows_per_leg)});
  };
  const double start = start_over_yield * form.first_yield, turn = 2 * start;
  const long settling = std::lround(settling_periods * period / plan.time_step);
  if (e.type != Type::twisting)
    plan.legs.push_back({Leg::Purpose::settle, 0, settling, std::max(1L, settling / rows_to_see_rest)});
  add(Leg::Purpose::start, start, slow);
  if (e.type == Type::twisting) {
    add(Leg::Purpose::reversal, -turn, slow);
    return plan;
  }
  const double way = e.type == Type::rail ? 2 * e.amplitude : e.amplitude;
  // Before a reversal all limits must have been reached, and after it once more, over twice the travel.
  const double least = std::max(2 * start, 2 * form.full_yield);
  if (way < least) {
    constexpr double rounding_up = 1.01;  // of the message
    const double amplitude = rounding_up * least * e.amplitude / way;
    throw InputError("an amplitude of " + format_quantity(e.amplitude, Dimension::length) +
                     " does not reach all the limits of this contact; take at least " + format_quantity(amplitude, Dimension::length));
  }
  add(Leg::Purpose::travel, way - 2 * start, std::max(slow, fast));
  add(Leg::Purpose::before_reversal, start, slow);
  if (e.type == Type::rail) return plan;
  for (int half_loop = 0; half_loop < 2; ++half_loop) {
    const double sign = half_loop == 0 ? -1 : 1;
    add(Leg::Purpose::reversal, sign * turn, slow);
    if (2 * way > turn + start) add(Leg::Purpose::travel, sign * (2 * way - turn - start), std::max(slow, fast));
    add(Leg::Purpose::before_reversal, sign * start, slow);
  }
  return plan;
}

}  // namespace asperity

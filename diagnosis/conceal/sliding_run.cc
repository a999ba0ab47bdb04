#include "diagnosis/conceal/sliding_run.h"

#include <algorithm>
#include <cmath>

#include "core/shear_moduli.h"
#include "diagnosis/conceal/sphere.h"

namespace asperity::hidden {

SlidingRun::SlidingRun(const World& world, const SlidingProgram& program, double friction, double load,
                       bool with_effects, unsigned seed)
    : world_(world),
      program_(program),
      with_effects_(with_effects),
      friction_(friction),
      load_(load),
      events_(seed) {
  const ElasticBody sphere{71e9, 0.17}, plane{179e9, 0.25};
  radius_ = Sphere{reduced_modulus(sphere, plane), 8.5e-6}.contact_radius_at_force(
      load + of("adhesion_offset", "adhesion_force"));  // Derjaguin, Muller & Toporov 1975
  stiffness_ = 8 * reduced_shear_modulus(sphere, plane) * radius_;
  if (has("partial_slip")) masing_ = MasingContact(stiffness_, limit(0, 0, 0, 0));
  next_event();
}

double SlidingRun::force_at(double position, double time, double speed, double cycle) {
  constexpr int steps = 40;
  const double from = position_, start = time_, compliance = of("lateral_compliance", "compliance");
  const int direction = position > from ? 1 : -1;
  if (direction != direction_ && position != from) {
    slip_ = 0;
    direction_ = direction;
    next_event();
  }
  for (int i = 1; i <= steps; ++i) {
    const double step = (position - from) / steps, dt = (time - start) / steps;
    advance_state(speed, dt);
    const double stiffness = 1 / (1 / stiffness_ + compliance), trial = force_ + stiffness * step;
    // The limit at the end of the step depends on what slips in it.
    double slipped = 0, most = limit(from + i * step, speed, cycle, 0);
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round) {
      slipped = std::max(0.0, (std::abs(trial) - most) / stiffness);
      most = limit(from + i * step, speed, cycle, slipped);
    }
    slip_ += slipped;
    sawtooth_ += slipped;
    force_ = slipped > 0 ? std::copysign(most, trial) : trial;
    if (sawtooth_ > period_) next_event();
  }
  position_ = position;
  time_ = time;
  if (has("partial_slip")) force_ = masing_.force(position);
  return recorded(time);
}

void SlidingRun::next_event() {
  std::normal_distribution<double> normal;
  constexpr double irregular_spacing = 0.005, irregular_size = 0.05;
  period_ = of("stick_slip", "period") * (1 + irregular_spacing * normal(events_));
  drop_ = of("stick_slip", "amplitude") * (1 + irregular_size * normal(events_));
  sawtooth_ = 0;
}

void SlidingRun::advance_state(double speed, double dt) {
  if (!has("rate_and_state")) return;
  const double length = of("rate_and_state", "slip_distance");
  if (theta_ <= 0) theta_ = length / speed;
  theta_ *= std::exp(-speed * dt / length * std::log(speed * theta_ / length));
}

double SlidingRun::limit(double position, double speed, double cycle, double slipped) const {
  double mu = friction_;
  if (has("velocity_dependence")) {
    constexpr double far_below = 1e-12;  // v* [m/s]
    const double reference = 1e-6, b = of("velocity_dependence", "coefficient");
    mu += b * (std::asinh(speed / (2 * far_below)) - std::asinh(reference / (2 * far_below)));
  }
  if (has("rate_and_state")) {
    const double a = of("rate_and_state", "a"), b = of("rate_and_state", "b"),
                 length = of("rate_and_state", "slip_distance");
    const double reference = 1e-6;
    mu += a * std::log(speed / reference) + b * std::log(reference * theta_ / length);
  }
  if (has("static_friction_peak"))
    mu *= 1 + (of("static_friction_peak", "peak_ratio") - 1) *
                  std::exp(-(slip_ + slipped) / of("static_friction_peak", "slip_length"));
  if (has("run_in")) mu *= 1 + of("run_in", "change") * std::exp(-cycle / of("run_in", "cycles"));
  if (has("position_weakening")) {
    const double x = (position - of("position_weakening", "place")) / of("position_weakening", "width");
    mu *= 1 - of("position_weakening", "share") * std::exp(-x * x / 2);
  }
  double most = mu * (load_ + of("adhesion_offset", "adhesion_force"));
  if (has("area_proportional_friction"))
    most = of("area_proportional_friction", "shear_strength") * pi * radius_ * radius_;
  if (has("stick_slip")) most -= drop_ * (1 - std::min(1.0, (sawtooth_ + slipped) / period_));
  return most;
}

double SlidingRun::recorded(double time) const {
  double force = force_ + of("lateral_zero_offset", "offset");
  if (has("surface_tilt")) {
    // Balance along and across the instrument's axis: N cos = f_n + T sin, F = N sin + T cos.
    const double angle = of("surface_tilt", "angle");
    force = (force + std::sin(angle) * load_) / std::cos(angle);
  }
  if (has("lateral_oscillation"))
    force += of("lateral_oscillation", "amplitude") *
             std::sin(2 * pi * time / of("lateral_oscillation", "period"));
  return force;
}

}  // namespace asperity::hidden

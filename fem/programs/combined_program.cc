#include "fem/programs/combined_program.h"

#include <algorithm>
#include <cmath>

namespace asperity::fem {
namespace {

bool by_force(const ExperimentInput& e) { return e.control == ExperimentInput::Control::force; }

double largest_load(const ExperimentInput& e) { return by_force(e) ? e.normal_load : e.normal_approach; }

double rolled_angle(const ProgramPart& part, double radius) { return part.roll + part.rolled_arc / radius; }

/// Positions of a part's steps as shares of it, the last one 1: no motion's steps are wider than its own.
std::vector<double> shares(const ProgramPart& part, double load_change, const ExperimentInput& e,
                           const MotionScales& scales) {
  std::vector<double> path;
  const bool rests =
      part.slide == 0 && part.slide_across == 0 && !part.rolls() && part.spin == 0 && load_change == 0;
  if (rests) {
    // What creeps at rest does so by decades of time: each step lasts twice as long as the one before.
    const int steps = part.steps > 0 ? part.steps : 1;
    for (int i = 1; i <= steps; ++i) path.push_back(std::expm1(i * M_LN2) / std::expm1(steps * M_LN2));
    path.back() = 1;
    return path;
  }
  if (part.steps > 0) {
    for (int i = 1; i <= part.steps; ++i) path.push_back(static_cast<double>(i) / part.steps);
    return path;
  }
  double onset = 1e9, largest = 1;
  const auto limit = [&](double length, double first, double step) {
    if (length == 0) return;
    if (first > 0) onset = std::min(onset, first / std::abs(length));
    if (step > 0) largest = std::min(largest, step / std::abs(length));
  };
  limit(std::hypot(part.slide, part.slide_across), scales.full_slip_shift, scales.largest_shift);
  limit(part.spin, scales.full_slip_angle, scales.largest_angle);
  limit(rolled_angle(part, scales.rolling_radius) * scales.rolling_radius, scales.largest_roll,
        scales.largest_roll);
  limit(load_change, 0, 1.0 / e.load_steps);
  return graded_path(1, std::min(onset, 10 * largest), largest);
}

/// Of a part [s]; 0: a second for each step.
double duration_of(const ProgramPart& part, double load_change, const ExperimentInput& e,
                   const MotionScales& scales) {
  if (part.duration > 0) return part.duration;
  const double arc = scales.rolling_radius * rolled_angle(part, scales.rolling_radius);
  const double path = std::max({std::hypot(part.slide, part.slide_across), std::abs(arc),
                                scales.contact_radius * std::abs(part.spin)});
  if (path == 0) return e.load_time * std::abs(load_change);
  const double speed = part.speed > 0 ? part.speed : e.speed;
  return speed > 0 ? path / speed : 0;
}

}  // namespace

std::vector<Station> combined_program(const std::vector<ProgramPart>& parts, const ExperimentInput& e,
                                      const MotionScales& scales, const RigidMotion& start) {
  std::vector<Station> stations;
  Station at{1.0, start, false};
  for (const auto& part : parts) {
    const Station begin = at;
    const auto wanted = by_force(e) ? part.load : part.approach;
    const double load_change = wanted ? *wanted / largest_load(e) - begin.load : 0;
    const double angle = rolled_angle(part, scales.rolling_radius);
    const double duration = duration_of(part, load_change, e, scales);
    double done = 0;
    for (const double share : shares(part, load_change, e, scales)) {
      const double step = share - done;
      // The particle rolls about an axis that spins with it.
      const double heading = begin.motion.spin + part.spin * (share - 0.5 * step),
                   arc = scales.rolling_radius * angle * step;
      at.load = begin.load + load_change * share;
      at.motion.x += part.slide * step + arc * std::cos(heading);
      at.motion.y += part.slide_across * step + arc * std::sin(heading);
      at.motion.roll = begin.motion.roll + angle * share;
      at.motion.spin = begin.motion.spin + part.spin * share;
      at.rolls_freely = part.rolls_freely();
      at.duration = duration > 0 ? duration * step : 1;
      stations.push_back(at);
      done = share;
    }
  }
  return stations;
}

MotionExtent extent_of(const std::vector<Station>& stations) {
  MotionExtent extent;
  for (const auto& station : stations) {
    const RigidMotion& motion = station.motion;
    extent.low_x = std::min(extent.low_x, motion.x), extent.high_x = std::max(extent.high_x, motion.x);
    extent.low_y = std::min(extent.low_y, motion.y), extent.high_y = std::max(extent.high_y, motion.y);
    extent.low_roll = std::min(extent.low_roll, motion.roll),
    extent.high_roll = std::max(extent.high_roll, motion.roll);
    extent.largest_spin = std::max(extent.largest_spin, std::abs(motion.spin));
  }
  return extent;
}

RigidMotion start_of(const MotionExtent& extent) {
  RigidMotion start;
  start.x = -0.5 * (extent.low_x + extent.high_x);
  start.y = -0.5 * (extent.low_y + extent.high_y);
  start.roll = -0.5 * (extent.low_roll + extent.high_roll);
  return start;
}

}  // namespace asperity::fem

#include "fem/programs/program.h"

#include <algorithm>
#include <cmath>

#include "fem/programs/combined_program.h"

namespace asperity::fem {
namespace {

constexpr double smallest_fraction = 1e-3;

double hertz_power(const ExperimentInput& e) {
  return e.control == ExperimentInput::Control::force ? 1.5 : 1.0;
}

/// Of each of `steps` that last `all` together [s].
double each_of(double all, int steps) { return all > 0 ? all / steps : 1; }

void load(const ExperimentInput& e, const RigidMotion& here, std::vector<Station>& program) {
  for (int i = 1; i <= e.load_steps; ++i)
    program.push_back({std::pow(static_cast<double>(i) / e.load_steps, hertz_power(e)), here, false,
                       each_of(e.load_time, e.load_steps)});
  for (int i = 0; i < e.hold_steps; ++i)
    program.push_back({1.0, here, false, each_of(e.hold_time, e.hold_steps)});
}

void unload(const ExperimentInput& e, std::vector<Station>& program) {
  const RigidMotion here = program.back().motion;
  const double from = program.back().load, duration = each_of(e.load_time, e.unload_steps);
  if (e.retract > 0) {
    const double last = -e.retract / e.normal_approach;
    for (int i = 1; i <= e.unload_steps; ++i)
      program.push_back({from + (last - from) * i / e.unload_steps, here, false, duration});
    return;
  }
  for (int i = e.unload_steps - 1; i >= 0; --i)
    program.push_back({std::max(smallest_fraction,
                                from * std::pow(static_cast<double>(i) / e.unload_steps, hertz_power(e))),
                       here, false, duration});
}

std::vector<double> even_path(double length, int steps) {
  std::vector<double> path;
  for (int i = 1; i <= steps; ++i) path.push_back(length * i / steps);
  return path;
}

void move(const ExperimentInput& e, const MotionScales& scales, std::vector<Station>& program) {
  const bool torsion = e.type == Motion::torsion, rolling = e.type == Motion::rolling;
  const RigidMotion start = program.back().motion;
  const double length = torsion ? e.angle : e.distance;
  const double onset = torsion   ? scales.full_slip_angle
                       : rolling ? scales.largest_roll
                                 : scales.full_slip_shift;
  const double largest = torsion   ? scales.largest_angle
                         : rolling ? scales.largest_roll
                                   : scales.largest_shift;
  const auto path = [&](double distance, double scale) {
    return e.motion_steps > 0 ? even_path(distance, e.motion_steps)
                              : graded_path(distance, scale * onset, largest);
  };
  double before = 0;
  const double lever = torsion ? scales.contact_radius : 1;
  const auto add = [&](double position) {
    Station station{1.0, start, rolling};
    if (e.speed > 0) station.duration = lever * std::abs(position - before) / e.speed;
    before = position;
    if (torsion)
      station.motion.spin += position;
    else
      station.motion.x += position;
    if (rolling) station.motion.roll += position / scales.rolling_radius;
    program.push_back(station);
  };
  for (const double position : path(length, 1)) add(position);
  if (!e.reverse) return;
  const double return_distance = e.return_distance > 0 ? std::min(e.return_distance, length) : length;
  // Slip after a reversal begins over twice the distance (Masing).
  for (const double back : path(return_distance, 2)) add(length - back);
}

}  // namespace

std::vector<double> graded_path(double length, double onset, double largest) {
  constexpr double first = 0.1, growth = 1.4;
  std::vector<double> path;
  double step = onset > 0 ? std::min(first * onset, largest) : largest, position = 0;
  while (length - position > 1.5 * step) {
    path.push_back(position += step);
    step = std::min(largest, step * growth);
  }
  path.push_back(length);
  return path;
}

std::vector<Station> make_program(const ExperimentInput& e, const MotionScales& scales) {
  std::vector<Station> program;
  RigidMotion start;
  if (e.type == Motion::rolling) start.x = -0.5 * e.distance, start.roll = start.x / scales.rolling_radius;
  if (e.type == Motion::program) {
    const auto parts = parse_motion_program(e.program);
    start = start_of(extent_of(combined_program(parts, e, scales, {})));
    load(e, start, program);
    const auto moved = combined_program(parts, e, scales, start);
    program.insert(program.end(), moved.begin(), moved.end());
    if (e.unload) unload(e, program);
    return program;
  }
  for (int cycle = 0; cycle < e.cycles; ++cycle) {
    load(e, start, program);
    if (e.type != Motion::normal) move(e, scales, program);
    if (e.unload) unload(e, program);
  }
  return program;
}

}  // namespace asperity::fem

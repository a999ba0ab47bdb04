#include "fem/output/frames.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace asperity::fem {
namespace {

constexpr int frames_by_default = 10;

double path_between(const RigidMotion& from, const RigidMotion& to, const MotionScales& scales) {
  const double shift = std::hypot(to.x - from.x, to.y - from.y),
               rolled = scales.rolling_radius * std::abs(to.roll - from.roll),
               spun = scales.contact_radius * std::abs(to.spin - from.spin);
  return std::hypot(std::max(shift, rolled), spun);
}

FrameTime time_of(const ExperimentInput& e, double path_length) {
  if (e.speed > 0 || e.load_time > 0 || e.hold_time > 0) return FrameTime::seconds;
  if (path_length > 0) return FrameTime::path;
  return e.control == ExperimentInput::Control::force ? FrameTime::load : FrameTime::approach;
}

/// By how much time goes on to a station from a load fraction before it, `path` [m] away.
double time_to(FrameTime is, const Station& station, double load_before, double path, double largest) {
  constexpr double nm = 1e-9, uN = 1e-6;
  const double load = std::abs(station.load - load_before);
  switch (is) {
    case FrameTime::seconds:
      return station.duration;
    case FrameTime::path:
      return path / nm + load;
    case FrameTime::load:
      return load * largest / uN;
    default:
      return load * largest / nm;
  }
}

/// Steps nearest to even times from the first to the last.
void show_evenly(Frames& frames) {
  const auto& time = frames.time;
  for (int k = 1; k <= frames_by_default; ++k) {
    const double wanted = time.front() + (time.back() - time.front()) * k / frames_by_default;
    const auto nearest = std::min_element(time.begin(), time.end(), [&](double a, double b) {
      return std::abs(a - wanted) < std::abs(b - wanted);
    });
    frames.shown[nearest - time.begin()] = 1;
  }
}

}  // namespace

Frames frames_of(const ExperimentInput& experiment, const std::vector<Station>& program,
                 const MotionScales& scales, double largest, int every) {
  Frames frames;
  RigidMotion before = program.front().motion;
  double path = 0;
  for (const auto& station : program) {
    path += path_between(before, station.motion, scales);
    frames.path_length.push_back(path);
    before = station.motion;
  }
  frames.time_is = time_of(experiment, path);
  // The path begins at 0, after the load of one nanometre's length.
  double time = frames.time_is == FrameTime::path ? -1 : 0, load = 0, path_before = 0;
  for (std::size_t k = 0; k < program.size(); ++k) {
    time += time_to(frames.time_is, program[k], load, frames.path_length[k] - path_before, largest);
    frames.time.push_back(time);
    const bool peak = program[k].load == 1.0 && load < 1.0;
    frames.shown.push_back(peak || k + 1 == program.size() || (every > 0 && (k + 1) % every == 0));
    load = program[k].load, path_before = frames.path_length[k];
  }
  if (every == 0) show_evenly(frames);
  return frames;
}

std::string Frames::time_text() const {
  switch (time_is) {
    case FrameTime::seconds:
      return "time in s";
    case FrameTime::path:
      return "path length in nm; pressing ends at 0, loading and unloading take a nanometre";
    case FrameTime::load:
      return "normal load in uN, counted on while it falls";
    default:
      return "approach in nm, counted on while it falls";
  }
}

}  // namespace asperity::fem

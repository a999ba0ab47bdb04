#include "diagnosis/choose/tell_apart.h"

#include <algorithm>
#include <cmath>

#include "core/printed.h"

namespace asperity {
namespace {

struct Proposal {
  std::string words;
  Samples samples;
};

constexpr int steps_of_branch = 60;

void end_run(Samples& samples, std::size_t begin, bool independent, bool displacement) {
  SampleRun run;
  run.begin = begin;
  run.end = samples.list.size();
  run.independent_rows = independent;
  run.response_is_displacement = displacement;
  samples.runs.push_back(run);
  for (std::size_t i = begin; i < samples.list.size(); ++i) samples.list[i].index = i;
  samples.parts = static_cast<int>(samples.runs.size());
}

Sample typical(const Experiment& e) {
  Sample s;
  s.radius = e.radius;
  s.normal_force = e.typical_force;
  s.rms_roughness = std::sqrt(std::max(e.smoothest, 1e-12) * std::max(e.roughest, 1e-12));
  s.speed = e.slowest > 0 ? std::sqrt(e.slowest * e.fastest) : 0;
  return s;
}

std::string load_words(double factor, const Experiment& e, double load) {
  return (factor > 1 ? "a higher load of " : "a lower load of ") +
         format_quantity(load, Dimension::force, 2) + " (" + (factor > 1 ? "largest" : "smallest") +
         " so far " + format_quantity(factor > 1 ? e.largest_force : e.smallest_force, Dimension::force, 2) +
         ")";
}

/// Load, hold and unload to a largest displacement (or force).
Samples indentation(const Experiment& e, double reach, double hold_time, double off_contact, double duration,
                    bool force_drives) {
  Samples samples;
  samples.segment_names = {"load", "hold", "unload"};
  double time = 0;
  const auto push = [&](double value, int segment, int direction, double in_hold, int hold) {
    Sample s = typical(e);
    s.time = time;
    (force_drives ? s.normal_force : s.normal_displacement) = value;
    s.segment = s.part = segment;
    s.direction = direction;
    s.hold_time = in_hold;
    s.hold = hold;
    samples.list.push_back(s);
  };
  const double step = duration / (2 * steps_of_branch);
  for (int i = 0; i <= steps_of_branch; ++i, time += step)
    push(-off_contact + (reach + off_contact) * i / steps_of_branch, 0, 1, 0, 0);
  if (hold_time > 0)
    for (int i = 1; i <= steps_of_branch; ++i) {
      time += hold_time / steps_of_branch;
      push(reach, 1, 1, hold_time * i / steps_of_branch, 1);
    }
  for (int i = 0; i <= steps_of_branch; ++i, time += step)
    push(reach - (reach + off_contact) * i / steps_of_branch, 2, -1, 0, hold_time > 0 ? 1 : 0);
  end_run(samples, 0, false, force_drives);
  return samples;
}

/// Loops of one load and speed.
Samples loops(const Experiment& e, double load, double stroke, double speed, int cycles) {
  Samples samples;
  samples.segment_names = {"forward", "backward"};
  double x = 0, time = 0;
  const double step = stroke / steps_of_branch;
  for (int cycle = 0; cycle < cycles; ++cycle)
    for (int segment = 0; segment < 2; ++segment)
      for (int i = 0; i < steps_of_branch; ++i) {
        Sample s = typical(e);
        const int direction = segment == 0 ? 1 : -1;
        x += direction * step;
        time += speed > 0 ? step / speed : 1;
        s.time = time;
        s.lateral_displacement = x;
        s.normal_force = load;
        s.speed = speed;
        s.direction = direction;
        s.since_reversal = step * (i + 1);
        s.cycle = cycle;
        s.cycles_passed = cycle + (segment + (i + 1.0) / steps_of_branch) / 2;
        s.segment = segment;
        samples.list.push_back(s);
      }
  end_run(samples, 0, false, false);
  return samples;
}

Samples one_row(const Sample& row) {
  Samples samples;
  samples.segment_names = {"series"};
  samples.list.push_back(row);
  end_run(samples, 0, true, false);
  return samples;
}

std::vector<Proposal> for_normal(const Experiment& e, const Samples& recorded) {
  const bool force_drives = recorded.runs.front().response_is_displacement;
  const double reach = force_drives ? e.largest_force : e.largest_displacement;
  const double duration = e.duration > 0 ? e.duration : 1;
  const auto words = [&](double factor) {
    return force_drives ? format_quantity(factor * reach, Dimension::force, 2)
                        : format_quantity(factor * reach, Dimension::length, 2);
  };
  std::vector<Proposal> list;
  for (const double factor : {0.1, 0.3, 3.0})
    list.push_back({std::string("load and unload to ") + words(factor) +
                        (factor < 1 ? " only, where low loads are resolved" : ", beyond what was recorded"),
                    indentation(e, factor * reach, 0, 0, duration, force_drives)});
  const double hold = std::max(60.0, 10 * e.hold_duration);
  list.push_back({"hold the largest load for " + format_quantity(hold, Dimension::time, 2),
                  indentation(e, reach, hold, 0, duration, force_drives)});
  if (!force_drives)
    list.push_back({"record approach and retraction out of contact too, to " +
                        format_quantity(reach, Dimension::length, 2) + " above the surface",
                    indentation(e, reach, 0, reach, duration, false)});
  list.push_back(
      {"load and unload ten times more slowly", indentation(e, reach, 0, 0, 10 * duration, force_drives)});
  return list;
}

std::vector<Proposal> for_traces(const Experiment& e) {
  std::vector<Proposal> list;
  const double speed = e.slowest > 0 ? std::sqrt(e.slowest * e.fastest) : 0;
  for (const double factor : {0.1, 0.3, 3.0, 10.0}) {
    const double load = factor * (factor > 1 ? e.largest_force : e.smallest_force);
    list.push_back({"record loops at " + load_words(factor, e, load), loops(e, load, e.stroke, speed, 2)});
  }
  for (const double factor : {0.05, 0.2, 3.0})
    list.push_back(
        {"record loops of " + format_quantity(factor * e.stroke, Dimension::length, 2) +
             (factor < 1 ? ", short enough that the contact hardly slides" : ", longer than those so far"),
         loops(e, e.typical_force, factor * e.stroke, speed, 2)});
  if (speed > 0)
    for (const double factor : {0.01, 100.0})
      list.push_back({"record loops at " + format_quantity(factor * speed, Dimension::speed, 2),
                      loops(e, e.typical_force, e.stroke, factor * speed, 2)});
  list.push_back({"record three times as many cycles",
                  loops(e, e.typical_force, e.stroke, speed,
                        std::min(60, 3 * static_cast<int>(std::max(1.0, e.cycles))))});
  return list;
}

std::vector<Proposal> for_series(const Experiment& e, const Samples& recorded) {
  std::vector<Proposal> list;
  // Around a row as it was recorded, one setting changed.
  Sample row = recorded.list[recorded.runs.front().begin];
  row.normal_force = e.typical_force;
  for (const double factor : {0.1, 0.3, 3.0, 10.0}) {
    Sample s = row;
    s.normal_force = factor * (factor > 1 ? e.largest_force : e.smallest_force);
    list.push_back({"measure at " + load_words(factor, e, s.normal_force), one_row(s)});
  }
  for (const double factor : {0.3, 3.0}) {
    Sample s = row;
    s.radius *= factor;
    list.push_back(
        {"measure with a particle of radius " + format_quantity(s.radius, Dimension::length, 2), one_row(s)});
  }
  if (e.mode == Motion::rolling || e.mode == Motion::rail)
    for (const double rms : {0.2e-9, 10e-9}) {
      Sample s = row;
      s.rms_roughness = rms;
      list.push_back(
          {"measure on a substrate of " + format_quantity(rms, Dimension::length, 2) + " RMS roughness",
           one_row(s)});
    }
  if (e.mode == Motion::rail)
    for (const double degrees : {0.0, 70.0}) {
      Sample s = row;
      s.rail_angle = degrees * (M_PI / 180);
      list.push_back({degrees == 0 ? "measure on a plane substrate"
                                   : printed("measure in a rail of %.0f degrees", degrees),
                      one_row(s)});
    }
  if (e.mode == Motion::sliding || e.mode == Motion::rolling) {
    Sample s = row;
    s.direction = -s.direction;
    list.push_back({"measure in the opposite direction too", one_row(s)});
  }
  for (const double factor : {0.01, 100.0})
    if (e.slowest > 0) {
      Sample s = row;
      s.speed = factor * std::sqrt(e.slowest * e.fastest);
      list.push_back({"measure at " + format_quantity(s.speed, Dimension::speed, 2), one_row(s)});
    }
  return list;
}

/// Largest difference of two predictions.
double difference(const ModelFit& one, const ModelFit& other, const Samples& samples) {
  const auto a = one.simulate(samples), b = other.simulate(samples);
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::isfinite(a[i]) && std::isfinite(b[i])) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace

std::string experiment_that_tells_apart(const FitProblem& problem, const ModelFit& one,
                                        const ModelFit& other) {
  const Experiment& e = problem.experiment;
  std::vector<Proposal> proposals = e.mode == Motion::normal ? for_normal(e, problem.samples)
                                    : e.has_trace            ? for_traces(e)
                                                             : for_series(e, problem.samples);
  std::vector<double> sd = problem.noise.sd;
  std::nth_element(sd.begin(), sd.begin() + static_cast<long>(sd.size() / 2), sd.end());
  const double noise = sd[sd.size() / 2];
  const double here = difference(one, other, problem.thin) / noise;
  const Proposal* best = nullptr;
  double largest = 0;
  for (const auto& proposal : proposals) {
    const double found = difference(one, other, proposal.samples) / noise;
    if (found > largest) largest = found, best = &proposal;
  }
  if (!best || largest < std::max(1.0, 1.5 * here))
    return printed(
        "no change of load, path, speed, radius or roughness within reach separates the two by more than "
        "%.1f times the noise; repeat the measurement without the sample, or with another instrument",
        std::max(largest, here));
  return best->words +
         printed(": there the two differ by up to %.0f times the noise of a sample, in these data by %.1f",
                 largest, here);
}

}  // namespace asperity

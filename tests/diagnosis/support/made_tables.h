// Recordings made by hand, from formulas and not from the mechanics that diagnoses: the paper's sphere on
// silicon.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "core/shear_moduli.h"
#include "diagnosis/recording/recording.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity::test {

/// Three load-unload runs under displacement control; `force` of the displacement and time.
inline Recording indentation(const std::function<double(double d, double t)>& force, double noise,
                             unsigned seed) {
  Recording r;
  r.mode = Motion::normal;
  r.particle = borosilicate();
  r.substrate = silicon();
  RecordingTable table;
  table.file = "indentation.csv";
  table.control = {"normal_displacement"};
  table.response = "normal_force";
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  for (int run = 1; run <= 3; ++run)
    for (int i = 0; i <= 300; ++i) {
      const double d = (60 - 5 * run) * nm * (i <= 150 ? i / 150.0 : (300 - i) / 150.0), t = 0.1 * i;
      table.columns["run"].push_back(run);
      table.columns["time"].push_back(t);
      table.columns["normal_displacement"].push_back(d);
      table.columns["normal_force"].push_back(force(d, t) + noise * normal(random));
      table.segment.push_back(i <= 150 ? "load" : "unload");
    }
  r.tables = {table};
  return r;
}

/// Friction loops at three loads. `force_change` of position, load and direction is added to an
/// elastic-sliding loop whose spring is `compliance` + Mindlin's.
inline Recording loops(double compliance,
                       const std::function<double(double x, double load, int direction)>& force_change,
                       double noise, unsigned seed) {
  Recording r;
  r.mode = Motion::sliding;
  r.particle = borosilicate();
  r.substrate = silicon();
  RecordingTable table;
  table.file = "loops.csv";
  table.control = {"lateral_displacement", "normal_force"};
  table.response = "lateral_force";
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const Experiment e = experiment(Motion::sliding);
  int run = 0;
  for (const double load : {200 * uN, 500 * uN, 1000 * uN}) {
    ++run;
    const double a = std::cbrt(0.75 * load * 8.5e-6 / e.reduced_modulus()), limit = 0.23 * load;
    const double spring = 1 / (1 / (8 * reduced_shear_modulus(e.particle, e.substrate) * a) + compliance);
    double q = 0, x = 0, t = 0;
    for (int cycle = 0; cycle < 3; ++cycle)
      for (const int direction : {1, -1})
        for (int i = 0; i < 100; ++i) {
          const double step = direction * 1 * nm;
          x += step;
          q = std::max(-limit, std::min(limit, q + spring * step));
          table.columns["run"].push_back(run);
          table.columns["cycle"].push_back(cycle);
          table.columns["time"].push_back(t += 0.01);
          table.columns["lateral_displacement"].push_back(x);
          table.columns["normal_force"].push_back(load);
          table.columns["lateral_force"].push_back(q + force_change(x, load, direction) +
                                                   noise * normal(random));
          table.segment.push_back(direction > 0 ? "forward" : "backward");
        }
  }
  r.tables = {table};
  return r;
}

}  // namespace asperity::test

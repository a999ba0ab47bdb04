// Loops of sliding whose events of slip come at uneven distances, from Mindlin's spring and a limit that
// rises by a saw-tooth between them.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/shear_moduli.h"
#include "diagnosis/recording/recording.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity::test {

/// The paper's sphere on silicon. SI units.
struct LoopsOfEvents {
  std::vector<double> loads;
  double friction = 0.3, drop = 0, period = 0;  ///< [-], of the force in an event [N], mean distance [m]
  double step = 0, noise = 0;                   ///< between samples [m], of the force [N]
  int strokes = 0, samples = 0;                 ///< of each load, of each stroke
  unsigned seed = 1;

  /// Events do not begin anew at reversals; their distances scatter by 4 %.
  Recording recording() const {
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
    double left = 0, spacing = period, x = 0, run = 0;
    for (const double load : loads) {
      const double radius = e.hertz().contact_radius(load),
                   spring = 8 * reduced_shear_modulus(e.particle, e.substrate) * radius;
      double force = 0;
      ++run;
      for (int stroke = 0; stroke < strokes; ++stroke)
        for (int i = 0; i < samples; ++i) {
          const int direction = stroke % 2 == 0 ? 1 : -1;
          x += direction * step;
          if ((left -= step) <= 0) left += spacing = period * (1 + 0.04 * normal(random));
          const double limit = friction * load + drop * (0.5 - left / spacing);
          force = std::clamp(force + spring * direction * step, -limit, limit);
          table.columns["run"].push_back(run);
          table.columns["cycle"].push_back(stroke / 2);
          table.columns["time"].push_back(0.01 * static_cast<double>(table.segment.size()));
          table.columns["lateral_displacement"].push_back(x);
          table.columns["normal_force"].push_back(load);
          table.columns["lateral_force"].push_back(force + noise * normal(random));
          table.segment.emplace_back(direction > 0 ? "forward" : "backward");
        }
    }
    r.tables = {table};
    return r;
  }
};

}  // namespace asperity::test

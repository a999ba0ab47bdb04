// The steady resistance of a motion that has slipped as a whole, and its fluctuation.
#pragma once

#include <optional>
#include <vector>

#include "fem/output/step_record.h"

namespace asperity::fem {

struct SteadyResistance {
  double mean, sd;  ///< over the way, each step weighted with its length; the sd is the fluctuation about the mean
  double way;       ///< [m] or [rad]
};

/// Lateral force against the motion over normal force, where at most 2 % of the closed nodes stick, on the way out and back;
/// none if it never slides.
std::optional<SteadyResistance> steady_sliding(const std::vector<StepRecord>& records);
/// Largest rolling moment of smooth elastic bodies without friction, eight spacings in the contact radius: noise of the mesh, over
/// the load times the contact radius (Rolling_analytic in tests/fem/rolling_test.cc).
constexpr double rolling_noise = 5e-4;
/// Rolling moment against the motion [N m], where the particle has rolled by more than its contact radius since the last reversal.
std::optional<SteadyResistance> steady_rolling(const std::vector<StepRecord>& records, double radius);
/// Energy dissipated per angle rolled [N m] on the same way, on all of it where that is too short: what is left of the moment when the
/// hills of the surfaces, which give back what they take, are taken out. A short way back dissipates hardly anything.
std::optional<double> rolling_dissipation(const std::vector<StepRecord>& records, double radius);
/// Torsion moment [N m] in the same sense as sliding.
std::optional<SteadyResistance> steady_torsion(const std::vector<StepRecord>& records);

}  // namespace asperity::fem

// The steady resistance of a motion as result.json states it, by the definition of core/steady_motion.h.
#pragma once

#include <optional>
#include <vector>

#include "results/history.h"

namespace asperity::fem {

/// Mean resistance and its scatter along the path.
struct SteadyResistance {
  double mean;         ///< of sliding over the normal force [-], of torsion and rolling [N m]
  double sd;           ///< standard deviation of the force or moment along the path, in the same unit
  double path_length;  ///< [m] or [rad]
};

/// Energy dissipated per path length, over the normal force; none if it never slides as a whole.
std::optional<SteadyResistance> steady_sliding(const std::vector<HistoryRow>& records);
/// Energy dissipated per angle.
std::optional<SteadyResistance> steady_torsion(const std::vector<HistoryRow>& records);
/// Largest rolling moment of smooth elastic bodies without friction, eight spacings in the contact radius:
/// noise of the mesh, over the load times the contact radius (Rolling_analytic in tests/fem/rolling_test.cc).
constexpr double rolling_noise = 5e-4;
/// Mean moment against the motion; on rough surfaces mostly the conservative topographic part.
/// radius: of the particle [m].
std::optional<SteadyResistance> steady_rolling(const std::vector<HistoryRow>& records, double radius);

/// Energy that steady rolling dissipates: its resistance.
struct RollingDissipation {
  double per_angle;   ///< [N m]
  double unbalanced;  ///< drift of the work that the energy balance leaves open there, per angle [N m]
  double step;        ///< largest step of the path there [m]
};
/// Over the same path as steady_rolling(). What the balance left open while the load came on is no part of
/// it: it is the same before and after. radius [m].
std::optional<RollingDissipation> rolling_dissipation(const std::vector<HistoryRow>& records, double radius);

}  // namespace asperity::fem

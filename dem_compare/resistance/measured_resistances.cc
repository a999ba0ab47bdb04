#include "dem_compare/resistance/measured_resistances.h"

#include <cmath>

namespace asperity {

Uncertain MeasuredMagnitude::over() const { return ratio(simulated, measured); }
double MeasuredMagnitude::sigmas() const {
  return (simulated.value - measured.value) / std::hypot(simulated.sd, measured.sd);
}
Uncertain MeasuredTrend::over() const { return ratio(simulated, measured); }
double MeasuredTrend::sigmas() const {
  return (simulated.value - measured.value) / std::hypot(simulated.sd, measured.sd);
}

bool MeasuredTrend::is_opposite() const {
  constexpr double two_sigma = 2;
  const auto told = [](const Uncertain& slope) { return std::abs(slope.value) > two_sigma * slope.sd; };
  return told(simulated) && told(measured) && simulated.value * measured.value < 0;
}
Agreement MeasuredTrend::agreement() const {
  constexpr double two_sigma = 2;
  if (!std::isfinite(sigmas())) return Agreement::unknown;
  if (is_opposite()) return Agreement::opposite;
  if (std::abs(sigmas()) > two_sigma) return Agreement::contradict;
  return sign_of(measured) == Trend::Sign::none ? Agreement::no_trend : Agreement::agree;
}

}  // namespace asperity

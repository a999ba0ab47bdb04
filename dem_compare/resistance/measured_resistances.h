// Simulated resistances and their trend with roughness beside measured ones.
#pragma once

#include <string>
#include <vector>

#include "dem_compare/resistance/roughness_trend.h"

namespace asperity {

/// One contact and load: F/P of sliding, M/(P r) of rolling and torsion. Of rolling the mean with the
/// indenter's contact, where that is in the study under the same load.
struct MeasuredMagnitude {
  const MovingContact* contact = nullptr;
  const MovingContact* indenter = nullptr;
  const MotionMode* mode = nullptr;
  double load = 0;  ///< [N]
  Uncertain simulated, measured;
  std::string source;
  Uncertain over() const;  ///< simulated over measured
  double sigmas() const;   ///< difference over both sds [-]
};

/// At two standard deviations; `no_trend`: the measured trend is not significant and the simulated one agrees
/// with it.
enum class Agreement { unknown, agree, no_trend, contradict, opposite };

/// Change per metre of RMS of the silicon's contact.
struct MeasuredTrend {
  const RoughnessTrend* trend = nullptr;
  double load = 0;  ///< [N]; NaN: of the coefficient mu, the slope over the loads
  Uncertain simulated, measured;
  Uncertain over() const;       ///< simulated over measured
  double sigmas() const;        ///< difference over both sds [-]
  bool is_opposite() const;     ///< both are significant, and have different signs
  Agreement agreement() const;  ///< by sign and size
};

/// mu and h of sliding, and of rolling with lambda = r, over two measured loads or more.
struct MeasuredLaw {
  const MovingContact* contact = nullptr;
  const MovingContact* indenter = nullptr;  ///< rolling: the other half of the mean
  const MotionMode* mode = nullptr;
  double lowest_load = 0, highest_load = 0;  ///< [N]
  CoefficientOverLoads simulated;
  Uncertain coefficient, offset;  ///< measured
};

/// All that both state.
struct AgainstPublished {
  std::vector<MeasuredMagnitude> magnitudes;
  std::vector<MeasuredLaw> laws;
  std::vector<MeasuredTrend> trends;
  std::vector<std::string> remarks;  ///< why a number of the paper has no partner
};

}  // namespace asperity

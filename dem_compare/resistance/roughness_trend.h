// How resistances change with the RMS roughness of the substrate, its spectrum kept: at each load, part by
// part, and over the loads.
#pragma once

#include <string>
#include <vector>

#include "dem_compare/resistance/moving_study.h"
#include "dem_compare/resistance/trend.h"

namespace asperity {

/// Resistances are over MovingState::scale(); slopes are per metre of RMS.
struct TrendAtLoad {
  double load = 0;  ///< [N]
  Trend total, friction, plastic, adhesion;
  Trend force;  ///< of the mean force or moment
};

/// mu and h of R = mu lambda (f + h), lambda = 1 for sliding and r else, of one contact over its loads.
struct CoefficientOverLoads {
  double rms = 0;  ///< [m]
  Uncertain coefficient, offset;
};

/// Straight line through resistances over lambda [N], with equal weights; needs two loads.
CoefficientOverLoads coefficient_over_loads(double rms, const std::vector<double>& loads,
                                            const std::vector<Uncertain>& resistances);

struct RoughnessTrend {
  const MotionMode* mode = nullptr;
  std::vector<const MovingContact*> contacts;  ///< by RMS
  std::vector<TrendAtLoad> loads;
  Uncertain relative;  ///< slope over mean per metre, over the loads; errors assumed to be common
  std::vector<CoefficientOverLoads> coefficients;  ///< of contacts with two loads or more
  Trend coefficient;                               ///< of mu over RMS

  /// Of the trend over all loads.
  Trend::Sign sign() const;
  /// Slope of a part over the mean of the whole per metre, over the loads.
  Uncertain relative_of(Trend TrendAtLoad::*part) const;
};

/// True for contacts that differ by the RMS of the substrate alone; a smooth substrate goes with every
/// spectrum.
bool differ_by_roughness(const MovingContact& one, const MovingContact& other);

/// One per family of contacts that differ by the substrate's RMS alone, and motion that two of them have at
/// the same load. Where the same realisations were solved on all surfaces, slopes are taken realisation by
/// realisation and block by block: what scatters on all of them alike drops out.
std::vector<RoughnessTrend> roughness_trends(const MovingStudy& study);

}  // namespace asperity

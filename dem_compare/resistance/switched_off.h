// What one mechanism contributes: contacts that differ in it alone, on the same surfaces. SI units.
#pragma once

#include <string>
#include <vector>

#include "dem_compare/resistance/moving_study.h"
#include "dem_compare/resistance/trend.h"

namespace asperity {

/// A pair of such contacts at one load, and the difference between them.
struct Contribution {
  enum class Mechanism { yielding, relaxation, adhesion } mechanism = Mechanism::yielding;
  const MovingContact *with = nullptr, *without = nullptr;
  const MotionMode* mode = nullptr;
  double load = 0;
  int realisations = 0;  ///< compared, each with itself
  Uncertain whole;       ///< resistance with the mechanism [N] or [N m]
  Uncertain difference;  ///< with less without
  /// Part by part: switching yielding off also changes what slip takes, by another area and topography.
  ResistanceParts parts;

  /// The difference over the resistance with the mechanism.
  Uncertain share() const;
  /// At two standard deviations.
  bool is_told() const { return std::abs(difference.value) > 2 * difference.sd; }
};

/// How what a mechanism contributes changes with the substrate's RMS: pairs on surfaces of one spectrum.
struct ContributionTrend {
  const Contribution *smoothest = nullptr, *roughest = nullptr;
  Trend difference;  ///< over MovingState::scale(), per metre of RMS
  double whole = 0;  ///< mean of the resistances with the mechanism, over the same scale
  Uncertain relative() const { return {difference.slope.value / whole, difference.slope.sd / whole}; }
};

/// "yielding"; in sentences and in resistance.json.
const char* name_of(Contribution::Mechanism mechanism);

/// Pairs in which one contact has a finite yield stress, a relaxing share, or a work of adhesion, and the
/// other has none, all else the same.
std::vector<Contribution> contributions(const MovingStudy& study);
/// Point into `contributions`.
std::vector<ContributionTrend> contribution_trends(const std::vector<Contribution>& contributions);

}  // namespace asperity

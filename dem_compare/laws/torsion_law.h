// Any of the torsion laws, as one value. SI units.
#pragma once

#include <vector>

#include "dem_compare/laws/any_law.h"
#include "dem_compare/laws/rotation_mode.h"

namespace asperity {

/// What a torsion law remembers of its contact; resistance: moment about the normal [N m].
struct TorsionHistory : SpringSlider<double> {
  double angle = 0;  ///< since the contact closed [rad]; of laws with partial slip
  /// Angles at which the twist turned back and that no wider loop has wiped out [rad].
  std::vector<double> turns{};
};

/// The kind, for the registry: rotations about the normal.
struct TorsionMode : RotationMode<TorsionHistory, double> {
  static constexpr const char* name = "torsion";
};

using TorsionLaw = LawOf<TorsionMode>;

}  // namespace asperity

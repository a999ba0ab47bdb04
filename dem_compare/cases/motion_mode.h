// Sliding, torsion and rolling: where a history has them, and what result.json and parameters.json call them.
#pragma once

#include <optional>
#include <vector>

#include "core/motion.h"
#include "engines/parameters/contact_parameters.h"
#include "results/history.h"

namespace asperity {

/// What tells the modes apart.
struct MotionMode {
  Motion motion;
  const char* title;
  /// A pure number [-].
  std::vector<double> History::*position;
  std::vector<double> History::*resistance;
  const char* resistance_unit;
  const char* stiffness_key;  ///< in `effective` of result.json
  const char* stiffness_unit;
  const char* path_entry;  ///< of the case file, for advice
  bool path_is_length;     ///< to be counted in contact diameters
  bool has_length;         ///< mu lambda (f + h) instead of mu (f + h)
  double
      stiffness_exponent;  ///< of the contact radius: Mindlin 1949, Reissner & Sagoci 1944; rolling: assumed
  std::optional<EffectiveQuantity> ContactParameters::*friction;
  std::optional<EffectiveQuantity> ContactParameters::*offset;
  std::optional<EffectiveQuantity> ContactParameters::*stiffness;
};
const MotionMode& sliding_mode();
const MotionMode& torsion_mode();
const MotionMode& rolling_mode();

}  // namespace asperity

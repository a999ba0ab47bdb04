// Laws of one mode of motion (sliding, torsion, rolling) from the cases of that experiment: steady resistance after full slip,
// R = mu lambda (f + h), its length lambda where it has one, and the stiffness without slip. SI units.
// A resistance holds for constant load and for ways beyond full slip; see steady_motion.h and resistance_law.h.
#pragma once

#include <string>
#include <vector>

#include "dem_compare/derive/law_report.h"
#include "dem_compare/derive/parameter_sets.h"
#include "dem_compare/derive/steady_motion.h"

namespace asperity {

/// What tells the modes apart.
struct MotionMode {
  const char* experiment;  ///< of the case file
  const char* title;
  std::vector<double> ContactHistory::*position;
  std::vector<double> ContactHistory::*resistance;
  const char* resistance_unit;
  const char* stiffness_key;   ///< in `effective` of result.json
  const char* stiffness_unit;
  const char* way_entry;       ///< of the case file, for advice
  bool way_is_length;          ///< to be counted in contact diameters
  bool has_length;             ///< mu lambda (f + h) instead of mu (f + h)
  double stiffness_exponent;   ///< of the contact radius, smooth elastic contact
  PartialSlip partial_slip;
  std::optional<EffectiveQuantity> ContactParameters::*friction;
  std::optional<EffectiveQuantity> ContactParameters::*offset;
  std::optional<EffectiveQuantity> ContactParameters::*stiffness;
};
const MotionMode& sliding_mode();
const MotionMode& torsion_mode();
const MotionMode& rolling_mode();

/// Sets the quantities of the mode (for sliding, reduced_shear_modulus too); `parameters` must have E* already.
LawReport derive_motion(const ParameterSet& set, const MotionMode& mode, ContactParameters& parameters);

}  // namespace asperity

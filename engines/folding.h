// A law of the load squeezed into the one number an engine takes for it, and the error this makes over the
// loads it was fitted on.
#pragma once

#include <functional>
#include <optional>

#include "engines/parameters/contact_parameters.h"

namespace asperity {

using OfLoad = std::function<double(double load)>;

/// The number and what it costs.
struct Folded {
  double number = 0;  ///< the engine's law is number * shape(load) (in the unit of both laws' ratio)
  LoadRange range;    ///< loads of the errors [N]
  double error_low = 0, error_high = 0;  ///< (engine - record)/record at both ends [-]

  /// Whether both errors are below rounding.
  bool is_exact() const;
};

/// The number with which the engine is right at `at_load`; without one, as far above the record at one end of
/// the range as below it at the other.
Folded fold(const OfLoad& record, const OfLoad& shape, const LoadRange& range, std::optional<double> at_load);

/// Errors of an engine whose law leaves no number to choose.
Folded unfoldable(const OfLoad& record, const OfLoad& engine, const LoadRange& range);

}  // namespace asperity

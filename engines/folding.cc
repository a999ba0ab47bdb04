#include "engines/folding.h"

#include <algorithm>
#include <cmath>

namespace asperity {

bool Folded::is_exact() const {
  constexpr double rounding = 1e-9;
  return std::max(std::abs(error_low), std::abs(error_high)) < rounding;
}

Folded fold(const OfLoad& record, const OfLoad& shape, const LoadRange& range,
            std::optional<double> at_load) {
  const double low = shape(range.low) / record(range.low), high = shape(range.high) / record(range.high);
  Folded folded;
  folded.range = range;
  folded.number = at_load ? record(*at_load) / shape(*at_load) : 2 / (low + high);
  folded.error_low = folded.number * low - 1;
  folded.error_high = folded.number * high - 1;
  return folded;
}

Folded unfoldable(const OfLoad& record, const OfLoad& engine, const LoadRange& range) {
  return {1, range, engine(range.low) / record(range.low) - 1, engine(range.high) / record(range.high) - 1};
}

}  // namespace asperity

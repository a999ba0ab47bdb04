// Any of the normal laws, as one value. advance() is pure: the caller keeps the state that was last accepted.
#pragma once

#include <variant>

#include "dem_compare/laws/dmt.h"
#include "dem_compare/laws/hertz_offset.h"
#include "dem_compare/laws/jkr.h"
#include "dem_compare/laws/linear_normal.h"
#include "dem_compare/laws/maugis_dugdale.h"

namespace asperity {

using NormalLaw = std::variant<HertzOffset, LinearNormal, Dmt, Jkr, MaugisDugdale>;

/// State at an approach [m] that was reached from `before`.
inline NormalState advance(const NormalLaw& law, const NormalState& before, double approach) {
  return std::visit([&](const auto& l) { return l.advance(before, approach); }, law);
}
/// Approach in equilibrium with a pressing force [N].
inline double approach_at(const NormalLaw& law, double force) {
  return std::visit([&](const auto& l) { return l.approach(force); }, law);
}
inline double radius_of(const NormalLaw& law) {
  return std::visit([](const auto& l) { return l.radius; }, law);
}

}  // namespace asperity

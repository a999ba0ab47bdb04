// Any of the sliding laws, as one value. advance() is pure: the caller keeps the history that was last accepted.
#pragma once

#include <variant>

#include "dem_compare/laws/linear_sliding.h"
#include "dem_compare/laws/mindlin.h"
#include "dem_compare/laws/mindlin_deresiewicz.h"

namespace asperity {

using SlidingLaw = std::variant<Mindlin, MindlinDeresiewicz, LinearSliding>;

/// History after a shift [m] of the particle's surface against the other one, at the new normal state.
inline SlidingHistory advance(const SlidingLaw& law, const SlidingHistory& before, const NormalState& normal,
                              const Eigen::Vector3d& increment) {
  return std::visit([&](const auto& l) { return l.advance(before, normal, increment); }, law);
}
inline const CoulombLimit& friction_of(const SlidingLaw& law) {
  return std::visit([](const auto& l) -> const CoulombLimit& { return l.friction; }, law);
}
inline CoulombLimit& friction_of(SlidingLaw& law) {
  return std::visit([](auto& l) -> CoulombLimit& { return l.friction; }, law);
}

}  // namespace asperity

#include "fem/contact/steady_prediction.h"

#include <algorithm>
#include <cmath>

namespace asperity::fem {

void SteadyPrediction::remember(ContactState& before, const ContactState& after, double target) {
  // The states before and after were solved at one target, or the change is that of a load.
  const bool moves = target == target_;
  target_ = target;
  reached_.clear();
  if (!moves) return;
  before_.take(before);
  reached_ = after.multiplier;
  motion_ = after.motion;
}

PathMemory SteadyPrediction::memory(const ContactState& accepted) const {
  PathMemory kept;
  kept.target = target_;
  if (reached_.empty() || reached_ != accepted.multiplier || !(motion_ == accepted.motion)) return kept;
  const auto& u = before_.displacement;
  kept.motion = before_.motion, kept.multiplier = before_.multiplier, kept.shear = before_.shear;
  kept.displacement.assign(u.begin(), u.begin() + u.locally_owned_size());
  return kept;
}

void SteadyPrediction::restore(const PathMemory& memory, const ContactState& accepted) {
  target_ = memory.target;
  reached_.clear();
  if (memory.multiplier.size() != accepted.multiplier.size() ||
      memory.displacement.size() != accepted.displacement.locally_owned_size())
    return;
  before_ = accepted;
  before_.motion = memory.motion, before_.multiplier = memory.multiplier, before_.shear = memory.shear;
  std::copy(memory.displacement.begin(), memory.displacement.end(), before_.displacement.begin());
  reached_ = accepted.multiplier;
  motion_ = accepted.motion;
}

double SteadyPrediction::share_of_last_step(const ContactState& accepted, const RigidMotion& motion,
                                            double target) const {
  if (target != target_ || reached_.empty() || reached_ != accepted.multiplier ||
      !(motion_ == accepted.motion))
    return 0;
  const auto path = [&](const RigidMotion& from, const RigidMotion& to) {
    return std::array<double, 4>{to.x - from.x, to.y - from.y, radius_ * (to.roll - from.roll),
                                 reach_ * (to.spin - from.spin)};
  };
  const auto last = path(before_.motion, motion_), next = path(motion_, motion);
  double along = 0, last_length = 0, next_length = 0;
  for (int c = 0; c < 4; ++c) {
    along += last[c] * next[c];
    last_length += last[c] * last[c];
    next_length += next[c] * next[c];
  }
  // A wider turn or a far longer step leads to other asperities.
  constexpr double same_direction = 0.9, longest = 2;
  if (last_length == 0 || along < same_direction * std::sqrt(last_length * next_length)) return 0;
  return std::min(longest, std::sqrt(next_length / last_length));
}

void SteadyPrediction::move_on(ContactState& state, double share) {
  state.displacement.zero_out_ghost_values();
  before_.displacement.zero_out_ghost_values();
  state.displacement.sadd(1 + share, -share, before_.displacement);
  state.displacement.update_ghost_values();
  for (std::size_t r = 0; r < state.multiplier.size(); ++r) {
    state.multiplier[r] =
        std::max(0.0, state.multiplier[r] + share * (state.multiplier[r] - before_.multiplier[r]));
    for (int c = 0; c < 2; ++c) state.shear[c][r] += share * (state.shear[c][r] - before_.shear[c][r]);
  }
}

}  // namespace asperity::fem

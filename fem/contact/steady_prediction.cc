#include "fem/contact/steady_prediction.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity::fem {

void SteadyPrediction::remember(ContactState& before, const ContactState& after, double target) {
  target_before_ = std::exchange(target_, target);
  before_.take(before);
  reached_ = after.multiplier;
  motion_ = after.motion;
}

PathMemory SteadyPrediction::memory(const ContactState& accepted) const {
  PathMemory kept;
  kept.target = target_, kept.target_before = target_before_;
  if (reached_.empty() || reached_ != accepted.multiplier || !(motion_ == accepted.motion)) return kept;
  const auto& u = before_.displacement;
  kept.motion = before_.motion, kept.multiplier = before_.multiplier, kept.shear = before_.shear;
  kept.displacement.assign(u.begin(), u.begin() + u.locally_owned_size());
  return kept;
}

void SteadyPrediction::restore(const PathMemory& memory, const ContactState& accepted) {
  target_ = memory.target, target_before_ = memory.target_before;
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
  if (reached_.empty() || reached_ != accepted.multiplier || !(motion_ == accepted.motion)) return 0;
  const bool is_pressed = std::any_of(reached_.begin(), reached_.end(), [](double p) { return p > 0; });
  if (!is_pressed) return 0;
  // A wider turn or a far longer step leads to other asperities.
  constexpr double same_direction = 0.9, longest = 2;
  const bool load_changed = target_ != target_before_, load_changes = target != target_,
             moved = !(motion_ == before_.motion), moves = !(motion == motion_);
  if (load_changed != load_changes || moved != moves || moves == load_changes) return 0;
  if (load_changes) {
    const double share = (target - target_) / (target_ - target_before_);
    return share > 0 ? std::min(longest, share) : 0;
  }
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

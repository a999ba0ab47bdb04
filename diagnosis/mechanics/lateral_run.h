// A run of lateral motion: the position of the contact and its slip, driven sample by sample.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/shear_moduli.h"
#include "diagnosis/mechanics/lateral_limit.h"
#include "diagnosis/mechanics/mechanics.h"
#include "diagnosis/mechanics/scalar_root.h"
#include "diagnosis/mechanics/strip_contact.h"

namespace asperity {

class LateralRun {
 public:
  explicit LateralRun(const Mechanics& mechanics)
      : mechanics_(mechanics),
        lateral_(mechanics_.lateral),
        sliding_modulus_(
            asperity::reduced_shear_modulus(mechanics.experiment.particle, mechanics.experiment.substrate)) {}

  /// Fully developed motion, one row of a series: lateral force [N].
  double steady(const Sample& sample) {
    const double force = sample.direction * limit(state_of(sample, 0));
    return force + addition(sample);
  }

  /// Lateral force of the first sample, from rest or from the one recorded there [N].
  double first(const Sample& sample, double recorded) {
    last_sample_ = &sample;
    const SlipState state = state_of(sample, 0);
    const double most = limit(state);
    const double start = recorded == 0 ? 0 : std::clamp(recorded - addition(sample), -most, most);
    stiffness_ = stiffness_at(state);
    if (lateral_.stick == LateralMechanics::Stick::strips && stiffness_ > 0) {
      StripContact virgin = strips_;
      force_ = virgin.advance(stiffness_, most, state.contact_radius, shift_for(start, most), strips_);
    } else {
      force_ = start;
    }
    position_ = sample.lateral_displacement - lateral_.compliance * force_;
    return force_ + addition(sample);
  }

  /// Lateral force of the sample that follows the last [N]. A turn between the two is passed on the way.
  double next(const Sample& sample) {
    if (!sample.turn) return move_to(sample);
    turn_ = *last_sample_;
    turn_.lateral_displacement = sample.turn->displacement;
    turn_.time = sample.turn->time;
    move_to(turn_);
    return move_to(sample);
  }

 private:
  static constexpr double gross = 1e-6;  // of the limit: rounding

  double move_to(const Sample& sample) {
    const double step = sample.lateral_displacement - last_sample_->lateral_displacement;
    if (sample.direction != last_sample_->direction) slip_ = path_ = 0;
    SlipState state = state_of(sample, sample.time - last_sample_->time);
    const double stiffness = stiffness_at(state), before = position_;
    // The path of this step slips if the last one did: what the limit depends on is taken at the step's end.
    if (slips_) state.slip += std::abs(step);
    if (path_ > 0) state.path = path_ += std::abs(step);
    const double most = limit(state);
    if (lateral_.stick == LateralMechanics::Stick::strips)
      move_strips(sample, stiffness, most, state.contact_radius);
    else
      move_spring(sample, stiffness, most);
    slips_ = std::abs(force_) >= most * (1 - gross) && force_ * sample.direction > 0;
    if (slips_) slip_ += std::abs(position_ - before);
    if (slips_ && path_ == 0) path_ = std::abs(position_ - before);
    last_sample_ = &sample;
    return force_ + addition(sample);
  }

  SlipState state_of(const Sample& sample, double time_step) const {
    SlipState state;
    state.sample = &sample;
    state.normal_force = sample.normal_force;
    state.contact_radius = attracted_radius(mechanics_, sample);
    state.slip = slip_;
    state.speed = sample.speed;
    state.time_step = time_step;
    return state;
  }
  double limit(const SlipState& state) {
    const Sample& sample = *state.sample;
    const bool at_substrate = at_ == ForcePlace::substrate;
    double coefficient = lateral_.coefficient;
    for (auto& change : lateral_.coefficient_changes) coefficient = change(coefficient, state);
    double most = lateral_limit(mechanics_, sample, coefficient, at_substrate);
    for (auto& change : lateral_.limit_changes) most = change(most, state);
    if (lateral_.correction)
      most = most * lateral_.correction->limit_factor(sample) + lateral_.correction->limit_offset(sample);
    for (const auto& part : lateral_.beside) most += part(state);
    return std::max(0.0, most);
  }
  double stiffness_at(const SlipState& state) const {
    const double factor = lateral_.correction ? lateral_.correction->stiffness_factor(*state.sample) : 1;
    return factor * 8 * sliding_modulus_ * state.contact_radius;
  }
  double addition(const Sample& sample) const {
    double sum = 0;
    for (const auto& part : lateral_.additions) sum += part(sample);
    return sum;
  }
  void move_spring(const Sample& sample, double stiffness, double most) {
    const double rescale =
        stiffness < stiffness_ && stiffness_ > 0 ? stiffness / stiffness_ : 1;  // spring_slider.h
    const double held = force_ * rescale;
    const double trial = (held + stiffness * (sample.lateral_displacement - position_)) /
                         (1 + stiffness * lateral_.compliance);
    force_ = std::clamp(trial, -most, most);
    position_ = sample.lateral_displacement - lateral_.compliance * force_;
    stiffness_ = stiffness;
  }
  void move_strips(const Sample& sample, double stiffness, double most, double contact_radius) {
    StripContact now;
    const auto force_of = [&](double position) {
      return strips_.advance(stiffness, most, contact_radius, position - position_, now);
    };
    double position = sample.lateral_displacement;
    if (lateral_.compliance > 0 && stiffness > 0) {
      const auto excess = [&](double x) {
        return x + lateral_.compliance * force_of(x) - sample.lateral_displacement;
      };
      const double guess = sample.lateral_displacement - lateral_.compliance * force_;
      position = increasing_root(excess, guess, std::max(1e-12, 0.1 * most / stiffness),
                                 1e-6 * most / stiffness + 1e-16);
    }
    force_ = force_of(position);
    strips_ = now;
    position_ = position;
    stiffness_ = stiffness;
  }
  /// Shift from rest to a force (Cattaneo 1938; Mindlin 1949).
  double shift_for(double force, double most) const {
    if (most <= 0) return 0;
    const double part = std::min(1.0, std::abs(force) / most);
    return std::copysign(1.5 * most / stiffness_ * (1 - std::pow(1 - part, 2.0 / 3.0)), force);
  }

 public:
  ForcePlace at_ = ForcePlace::indenter;

 private:
  Mechanics mechanics_;
  LateralMechanics& lateral_;
  double sliding_modulus_ = 0;
  const Sample* last_sample_ = nullptr;
  Sample turn_;  ///< between two samples
  StripContact strips_;
  double force_ = 0, position_ = 0, stiffness_ = 0, slip_ = 0, path_ = 0;
  bool slips_ = false;
};

}  // namespace asperity

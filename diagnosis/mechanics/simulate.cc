// One pass through the recording: the assembled mechanics driven sample by sample.
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>

#include "dem_compare/laws/mindlin.h"
#include "dem_compare/laws/shear_moduli.h"
#include "diagnosis/mechanics/lateral_limit.h"
#include "diagnosis/mechanics/mechanics.h"
#include "diagnosis/mechanics/scalar_root.h"
#include "diagnosis/mechanics/strip_contact.h"

namespace asperity {
namespace {

// ---- normal

class NormalRun {
 public:
  explicit NormalRun(const NormalMechanics& mechanics) : mechanics_(mechanics) {
    if (mechanics_.correction)
      if (auto solved = mechanics_.correction->contact_for(*mechanics_.contact))
        mechanics_.contact = std::move(solved);
    forget();
  }

  /// Restart without history: rows of a series.
  void forget() { contact_ = mechanics_.contact->clone(); }

  double force_at(const Sample& sample) {
    begin_step(sample);
    const double shifted = sample.normal_displacement - shift(sample);
    const double d = mechanics_.series.empty() && mechanics_.delays.empty() && !mechanics_.correction
                         ? shifted
                         : contact_displacement(shifted);
    accept(d);
    return reading(contact_->force(d) + addition(sample, sample.normal_displacement));
  }

  double displacement_at(const Sample& sample) {
    begin_step(sample);
    const double shifted = shift(sample);
    if (mechanics_.additions.empty() && mechanics_.readings.empty()) {
      const double d = contact_->displacement(sample.normal_force);
      if (std::isfinite(d)) {
        step_ = d - last_;
        last_ = d;
        const double whole = d + series(sample.normal_force) + delayed(d) + shifted;
        accept(d);
        return whole;
      }
    }
    const auto whole = [&](double d) { return d + series(contact_->force(d)) + delayed(d) + shifted; };
    const auto excess = [&](double d) {
      return reading(contact_->force(d) + addition(sample, whole(d))) - sample.normal_force;
    };
    // As far again as the last step went.
    const double root = increasing_root(excess, last_ + step_, std::max(smallest_step, 0.5 * std::abs(step_)),
                                        displacement_tolerance);
    // A law that cannot carry the force sends the search ever further, sample by sample.
    const double d = std::clamp(root, -farthest, farthest);
    step_ = d - last_;
    last_ = d;
    const double displacement = whole(d);
    accept(d);
    return displacement;
  }

 private:
  static constexpr double displacement_tolerance = 1e-14;  // [m], far below what any instrument resolves
  static constexpr double farthest = 1;                    // [m], where no contact is any more
  static constexpr double smallest_step = 1e-12;           // [m], in which a root is looked for

  void begin_step(const Sample& sample) {
    time_step_ = begun_ ? std::max(0.0, sample.time - time_) : 0;
    time_ = sample.time;
    begun_ = true;
    sample_ = &sample;
    contact_->begin_step(time_step_);
  }
  void accept(double d) {
    contact_->accept(d);
    for (auto& part : mechanics_.delays) part.accept(d, time_step_);
  }
  double delayed(double d) const {
    double sum = 0;
    for (const auto& part : mechanics_.delays) sum += part.after(d, time_step_);
    return sum;
  }
  double shift(const Sample& sample) {
    double sum = 0;
    for (auto& part : mechanics_.shifts) sum += part(sample);
    return sum;
  }
  double series(double force) const {
    double sum = 0;
    for (const auto& part : mechanics_.series) sum += part(force);
    if (mechanics_.correction) sum += mechanics_.correction->displacement(*sample_, force);
    return sum;
  }
  double addition(const Sample& sample, double displacement) const {
    double sum = 0;
    for (const auto& part : mechanics_.additions) sum += part(sample, displacement);
    return sum;
  }
  double reading(double force) const {
    for (const auto& part : mechanics_.readings) force = part(force);
    return force;
  }
  /// Solves d + series(f(d)) + delayed(d) = given for the contact's own displacement d.
  double contact_displacement(double given) {
    const double free = given - delayed(0) - series(0);
    const auto excess = [&](double d) { return d + series(contact_->force(d)) + delayed(d) - given; };
    const double step = given - last_given_;
    last_given_ = given;
    last_ = free <= 0
                ? pulled_displacement(excess, free)
                : increasing_root(excess, std::min(last_ + step, given),
                                  std::max(smallest_step, 0.5 * std::abs(step)), displacement_tolerance);
    return last_;
  }
  /// Below first touch an attraction may hold, which the series draws out: until the whole displacement has
  /// its minimum, and the contact snaps to where it is free.
  template <class Excess>
  double pulled_displacement(const Excess& excess, double free) const {
    const double release = contact_->release();
    if (!(release < 0 && contact_->force(release / 2) < 0)) return free;
    constexpr int bits = 24;
    const auto at_part = [&](double part) { return excess(part * release) / -release; };  // of order one
    const double fold = release * boost::math::tools::brent_find_minima(at_part, 0.0, 1.0, bits).first;
    const double least = excess(fold);
    if (least >= 0) return free;
    double high = std::max(last_, 0.0), f_high = excess(high);
    while (f_high < 0) high += std::abs(release), f_high = excess(high);
    return root_between(excess, fold, high, least, f_high, displacement_tolerance);
  }

  NormalMechanics mechanics_;
  std::unique_ptr<NormalContact> contact_;
  double last_ = 0, last_given_ = 0, step_ = 0, time_ = 0, time_step_ = 0;
  bool begun_ = false;
  const Sample* sample_ = nullptr;
};

// ---- lateral

class LateralRun {
 public:
  explicit LateralRun(const Mechanics& mechanics) : mechanics_(mechanics), lateral_(mechanics_.lateral) {
    const Experiment& e = mechanics.experiment;
    sliding_modulus_ = asperity::sliding_modulus(e.particle, e.substrate);
  }

  /// Fully developed motion: one row of a series.
  double steady(const Sample& sample) {
    const double force = sample.direction * limit(state_of(sample, 0));
    return force + addition(sample);
  }

  double first(const Sample& sample, double recorded) {
    last_sample_ = &sample;
    const SlipState state = state_of(sample, 0);
    const double most = limit(state);
    const double start = recorded == 0 ? 0 : std::clamp(recorded - addition(sample), -most, most);
    stiffness_ = 8 * sliding_modulus_ * state.contact_radius;
    if (lateral_.stick == LateralMechanics::Stick::strips && stiffness_ > 0) {
      StripContact virgin = strips_;
      force_ = virgin.advance(stiffness_, most, state.contact_radius, shift_for(start, most), strips_);
    } else {
      force_ = start;
    }
    position_ = sample.lateral_displacement - lateral_.compliance * force_;
    return force_ + addition(sample);
  }

  double next(const Sample& sample) {
    const double step = sample.lateral_displacement - last_sample_->lateral_displacement;
    if (sample.direction != last_sample_->direction) slip_ = path_ = 0;
    SlipState state = state_of(sample, sample.time - last_sample_->time);
    const double stiffness = 8 * sliding_modulus_ * state.contact_radius;
    // The path of this step slips if the last one did: what the limit depends on is taken at the step's end.
    if (slips_) state.slip += std::abs(step);
    if (path_ > 0) state.path = path_ += std::abs(step);
    const double most = limit(state);
    const double before = position_;
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

 private:
  static constexpr double gross = 1e-6;  // of the limit: rounding

  SlipState state_of(const Sample& sample, double time_step) const {
    SlipState state;
    state.sample = &sample;
    state.normal_force = sample.normal_force;
    state.contact_radius = hertz_radius(mechanics_, sample);
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
    return std::max(0.0, most);
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
  StripContact strips_;
  double force_ = 0, position_ = 0, stiffness_ = 0, slip_ = 0, path_ = 0;
  bool slips_ = false;
};

}  // namespace

std::vector<double> simulate(const Mechanics& mechanics, const Samples& samples) {
  std::vector<double> response(samples.list.size(), 0.0);
  for (const auto& run : samples.runs) {
    if (mechanics.experiment.mode == Motion::normal) {
      NormalRun state(mechanics.normal);
      for (std::size_t i = run.begin; i < run.end; ++i) {
        if (run.independent_rows) state.forget();
        response[i] = run.response_is_displacement ? state.displacement_at(samples.list[i])
                                                   : state.force_at(samples.list[i]);
      }
      continue;
    }
    LateralRun state(mechanics);
    state.at_ = run.at;
    for (std::size_t i = run.begin; i < run.end; ++i) {
      const Sample& sample = samples.list[i];
      response[i] = run.independent_rows ? state.steady(sample)
                    : i == run.begin     ? state.first(sample, run.first_response)
                                         : state.next(sample);
    }
  }
  return response;
}

}  // namespace asperity

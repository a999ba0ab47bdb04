#include "diagnosis/mechanics/relaxing_contact.h"

#include <algorithm>
#include <cmath>

namespace asperity {

RelaxingContact::RelaxingContact(const Hertz& law, const RelaxingModulus& modulus)
    : law_(law), parts_(std::min(modulus.size(), most_parts)) {
  for (std::size_t k = 0; k < parts_; ++k) {
    share_[k] = modulus[k].share;
    time_constant_[k] = modulus[k].time;
    for_good_ -= share_[k];
  }
}

void RelaxingContact::begin_step(double time_step) {
  step_ = time_step;
  for (std::size_t k = 0; k < parts_; ++k) {
    const double time = step_ / time_constant_[k];
    decay_[k] = {std::exp(-time), time > 1e-9 ? -std::expm1(-time) / time : 1};
  }
}

double RelaxingContact::force(double d) const {
  if (d <= 0) return 0;
  if (!grows_at(d)) return shrunk_force(d);
  const Instant largest = state_as_it_grows(d);
  return std::max(0.0, with_shares(largest.force, largest.force_left));
}

void RelaxingContact::accept(double d) {
  d = std::max(0.0, d);
  const Instant now = state_as_it_grows(d);
  if (d == 0) {
    growth_.assign(1, now);
    shrinking_ = {};
  } else if (grows_at(d)) {
    growth_.push_back(now);
    shrinking_ = {};
  } else {
    shrinking_ = shrinking_at(d);
  }
  time_ += step_;
  last_ = now;
}

double RelaxingContact::with_shares(double whole, const OfParts& of_parts) const {
  double sum = for_good_ * whole;
  for (std::size_t k = 0; k < parts_; ++k) sum += share_[k] * of_parts[k];
  return sum;
}

/// After this step, with depth and elastic force growing evenly over it.
RelaxingContact::Instant RelaxingContact::state_as_it_grows(double d) const {
  Instant now{time_ + step_, d, elastic(d), {}, {}};
  for (std::size_t k = 0; k < parts_; ++k) {
    now.depth_left[k] = last_.depth_left[k] * decay_[k].left + (d - last_.depth) * decay_[k].mean;
    now.force_left[k] = last_.force_left[k] * decay_[k].left + (now.force - last_.force) * decay_[k].mean;
  }
  return now;
}

RelaxingContact::OfParts RelaxingContact::shrinking_at(double d) const {
  OfParts shrinking{};
  for (std::size_t k = 0; k < parts_; ++k)
    shrinking[k] = shrinking_[k] * decay_[k].left + (d - last_.depth) * decay_[k].mean;
  return shrinking;
}

/// Integral of psi(t - s) over the depth since the contact was largest [m].
double RelaxingContact::regained_at(double d) const {
  return with_shares(d - growth_.back().depth, shrinking_at(d));
}

RelaxingContact::OfParts RelaxingContact::decayed(const OfParts& values, double time) const {
  OfParts now{};
  for (std::size_t k = 0; k < parts_; ++k)
    now[k] = values[k] * std::exp((time - time_ - step_) / time_constant_[k]);
  return now;
}

/// Of a contact that is smaller than it was, as at t_1.
double RelaxingContact::shrunk_force(double d) const {
  const double since_largest = regained_at(d);
  const Instant& largest = growth_.back();
  const OfParts largest_left = decayed(largest.depth_left, largest.time);
  const auto regained_since = [&](const Instant& m) {
    OfParts difference = decayed(m.depth_left, m.time);
    for (std::size_t k = 0; k < parts_; ++k) difference[k] = largest_left[k] - difference[k];
    return since_largest + with_shares(largest.depth - m.depth, difference);
  };
  const auto force_of = [&](const Instant& m) { return with_shares(m.force, decayed(m.force_left, m.time)); };
  const auto after = std::partition_point(growth_.begin(), growth_.end(),
                                          [&](const Instant& m) { return regained_since(m) >= 0; });
  if (after == growth_.begin() || after == growth_.end()) return 0;
  const double before = regained_since(*(after - 1)), part = before / (before - regained_since(*after));
  return (1 - part) * force_of(*(after - 1)) + part * force_of(*after);
}

}  // namespace asperity

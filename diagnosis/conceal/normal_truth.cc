#include "diagnosis/conceal/normal_truth.h"

#include <algorithm>
#include <cmath>

namespace asperity::hidden {
double HystereticTruth::force(double approach, double) const {
  if (approach >= turn_) return closing_.advance(state_, approach).force;
  const double pinned =
      state_.force - 2 * closing_.reduced_modulus * state_.contact_radius * (turn_ - approach);
  return std::max(pinned, opening_.advance(opening_state_, approach).force);
}

void HystereticTruth::take(double approach, double) {
  if (approach >= turn_ || turn_ == 0) {
    state_ = closing_.advance(state_, approach);
    turn_ = std::max(0.0, approach);
  }
  opening_state_ = opening_.advance(opening_state_, approach);
}

PlasticTruth::PlasticTruth(double reduced_modulus, double radius, double poissons_ratio,
                           double yield_stress) {
  constexpr double hardness_over_yield = 2.8;
  const double slope =
      pi * (0.454 + 0.41 * poissons_ratio) * hardness_over_yield * yield_stress / (2 * reduced_modulus);
  critical_ = slope * slope * radius;
  critical_force_ = 4.0 / 3 * reduced_modulus * std::sqrt(radius) * std::pow(critical_, 1.5);
}

double PlasticTruth::loading_force(double approach) const {
  if (approach <= 0) return 0;
  const double w = approach / critical_;
  // The fits meet Hertz at w = 1.48 and each other near 6.6: there one takes over from the other without a
  // jump.
  if (w < 1) return critical_force_ * std::pow(w, 1.5);
  return critical_force_ *
         std::min(std::pow(w, 1.5), std::min(1.03 * std::pow(w, 1.425), 1.40 * std::pow(w, 1.263)));
}

double PlasticTruth::force(double approach, double) const {
  if (approach >= largest_) return loading_force(approach);
  const double d = largest_ / critical_;
  const double residual = d <= 1 ? 0 : largest_ * (1 - std::pow(d, -0.28)) * (1 - std::pow(d, -0.69));
  if (approach <= residual) return 0;
  const double exponent = d <= 1 ? 1.5 : 1.5 * std::pow(d, -0.0331);
  return loading_force(largest_) * std::pow((approach - residual) / (largest_ - residual), exponent);
}

double CreepingTruth::elastic(double approach, double time) const {
  // q after a step in which delta_e stays: exact; then delta_e + q(delta_e) = delta, linear while in contact.
  const double decay = std::exp(-time / time_),
               e = (approach - delayed_ * decay) / (1 + share_ * (1 - decay));
  return e > 0 ? e : approach - delayed_ * decay;
}

}  // namespace asperity::hidden

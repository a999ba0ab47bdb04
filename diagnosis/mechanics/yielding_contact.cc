#include "diagnosis/mechanics/yielding_contact.h"

#include <cmath>

namespace asperity {
namespace {

constexpr double pi = M_PI;

}  // namespace

YieldingContact::YieldingContact(const Hertz& law, double yield, double hardness, double poisson)
    : law_(law),
      hardness_(hardness),
      of_poisson_(1.295 * std::exp(0.736 * poisson)),
      beyond_poisson_(poisson - 0.235) {
  const double pressure = pi * of_poisson_ * yield / 2;
  critical_depth_ = std::pow(pressure / law.reduced_modulus, 2) * law.radius;
  critical_force_ = 4.0 / 3 * std::pow(law.radius / law.reduced_modulus, 2) * std::pow(pressure, 3);
  exponent_ = 0.14 * std::exp(23 * yield / law.reduced_modulus);
}

double YieldingContact::force(double d) const {
  if (d <= 0) return 0;
  if (d >= deepest_) return virgin(d);
  if (d <= residual_) return 0;
  return largest_ * std::pow((d - residual_) / (deepest_ - residual_), unloading_);
}

double YieldingContact::displacement(double force) const {
  if (force <= 0 || force > largest_) return std::numeric_limits<double>::quiet_NaN();
  return residual_ + (deepest_ - residual_) * std::pow(force / largest_, 1 / unloading_);
}

void YieldingContact::accept(double d) {
  if (d <= deepest_) return;
  deepest_ = d;
  largest_ = virgin(d);
  const double w = d / critical_depth_;
  residual_ = 0;
  unloading_ = 1.5;
  if (w <= 1) return;
  residual_ = d * std::pow(1 - std::pow(w, -0.373 - 0.051 * beyond_poisson_), 1.733);
  unloading_ = 1.345 + 0.155 * std::pow(w, -0.545);
}

double YieldingContact::virgin(double d) const {
  const double w = d / critical_depth_, elastic = critical_force_ * w * std::sqrt(w);
  if (w <= 1) return elastic;
  // Powers as exponentials of logarithms that several share.
  const double log_w = std::log(w), log_beyond = std::log(w - 1);
  static const double log_onset = std::log(1.9);  // below, the radius is Hertz' (Jackson & Green 2005)
  const double a = std::sqrt(law_.radius * d * std::exp(exponent_ * std::max(0.0, log_w - log_onset)));
  const double hardness = hardness_ - 0.92 * (1 - std::cos(pi * std::min(1.0, a / law_.radius)));
  const double u = w - 1, by_poisson = 1 + 0.0036188 * beyond_poisson_ * u / (1 + u / 1654),
               plastic =
                   0.06656 * std::exp(1.8812 * log_beyond - 1.1649 * std::log1p(u / 1.9357)) * by_poisson;
  // f/f_c of Jackson & Green (2005, eq. 14), for how the force depends on H/Y: on hardening, and on the size
  // of the contact, which the finite elements of small contacts do not tell. Its jump at w = 1 is left out.
  const double by_elastic = std::exp(-std::exp(5.0 / 12 * log_w) / 4) * w * std::sqrt(w),
               by_hardness = -4 / of_poisson_ * std::expm1(-std::exp(5.0 / 9 * log_w) / 25) * w,
               changed =
                   (by_elastic + by_hardness * hardness) / (by_elastic + by_hardness * without_hardening);
  return elastic / std::sqrt(1 + plastic) * (1 + (changed - 1) * (1 - std::exp(1 - w)));
}

bool particle_is_softer(const Experiment& e) {
  if (e.particle_yield != e.substrate_yield) return e.particle_yield < e.substrate_yield;
  return e.particle.youngs_modulus <= e.substrate.youngs_modulus;
}

const ElasticBody& softer_body(const Experiment& e) {
  return particle_is_softer(e) ? e.particle : e.substrate;
}

}  // namespace asperity

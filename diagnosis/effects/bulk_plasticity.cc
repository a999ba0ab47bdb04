// A sphere that yields under the contact. With w = d/d_c, C = 1.295 exp(0.736 nu) (Jackson & Green 2005):
//   d_c = (pi C Y/(2 E*))^2 R,  f_c = 4/3 (R/E*)^2 (pi C Y/2)^3.
// Loading: Hertz up to w = 1, then between Hertz and the fully plastic sphere, with u = w - 1:
//   f/f_c = w^(3/2) [1 + (2.84 Y/H)^2 P]^(-1/2),  P = 0.0514 u^1.757/(1 + u/2.677)^1.037,
//   H/Y = h - 0.92 [1 - cos(pi a/R)],  a^2 = R d (w/1.9)^B,  B = 0.14 exp(23 Y/E*)  (Jackson & Green 2005);
// h = 2.84 without hardening, free: published laws differ, and hardening raises it.
// Unloading from w_m as Etsion, Kligerman & Kadin (2005) describe it:
//   f = f_m [(d - d_r)/(d_m - d_r)]^n,  d_r/d_m = (1 - w_m^(-0.378))^1.768,  n = 1.345 + 0.155 w_m^(-0.545);
// reloading follows it back to f_m.
// The numbers are fitted to axisymmetric finite elements without hardening
// (tests/data/references/02_elastoplastic_*) of nu = 0.17 to 0.3 and w up to 110: force within 1 %, imprint
// within 0.6 % of d_m. Jackson & Green's own curve is 2 % above these where yielding begins, and Etsion's
// imprint a sixth below.
#include <cmath>

#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

constexpr double pi = M_PI;
constexpr double without_hardening = 2.84;  // H/Y

class YieldingContact : public NormalContact {
 public:
  YieldingContact(const Hertz& law, double yield, double hardness, double poisson)
      : law_(law), hardness_(hardness), of_poisson_(1.295 * std::exp(0.736 * poisson)) {
    const double pressure = pi * of_poisson_ * yield / 2;
    critical_depth_ = std::pow(pressure / law.reduced_modulus, 2) * law.radius;
    critical_force_ = 4.0 / 3 * std::pow(law.radius / law.reduced_modulus, 2) * std::pow(pressure, 3);
    exponent_ = 0.14 * std::exp(23 * yield / law.reduced_modulus);
  }
  std::unique_ptr<NormalContact> clone() const override { return std::make_unique<YieldingContact>(*this); }
  double force(double d) const override {
    if (d <= 0) return 0;
    if (d >= deepest_) return virgin(d);
    if (d <= residual_) return 0;
    return largest_ * std::pow((d - residual_) / (deepest_ - residual_), unloading_);
  }
  double displacement(double force) const override {
    if (force <= 0 || force > largest_) return std::numeric_limits<double>::quiet_NaN();
    return residual_ + (deepest_ - residual_) * std::pow(force / largest_, 1 / unloading_);
  }
  void accept(double d) override {
    if (d <= deepest_) return;
    deepest_ = d;
    largest_ = virgin(d);
    const double w = d / critical_depth_;
    residual_ = 0;
    unloading_ = 1.5;
    if (w <= 1) return;
    residual_ = d * std::pow(1 - std::pow(w, -0.378), 1.768);
    unloading_ = 1.345 + 0.155 * std::pow(w, -0.545);
  }

 private:
  double virgin(double d) const {
    const double w = d / critical_depth_, elastic = critical_force_ * w * std::sqrt(w);
    if (w <= 1) return elastic;
    constexpr double onset = 1.9;  // below, the radius is that of Hertz (Jackson & Green 2005)
    const double a = std::sqrt(law_.radius * d * std::pow(std::max(1.0, w / onset), exponent_));
    const double hardness = hardness_ - 0.92 * (1 - std::cos(pi * std::min(1.0, a / law_.radius)));
    const double plastic = 0.0514 * std::pow(w - 1, 1.757) / std::pow(1 + (w - 1) / 2.677, 1.037);
    const double changed =
        fit_of_jackson_and_green(w, hardness) / fit_of_jackson_and_green(w, without_hardening);
    return elastic / std::sqrt(1 + plastic) * (1 + (changed - 1) * (1 - std::exp(1 - w)));
  }
  /// f/f_c of Jackson & Green (2005, eq. 14), for how the force depends on H/Y: on hardening, and on the size
  /// of the contact, which the finite elements of small contacts do not tell. Its jump at w = 1 is left out
  /// above.
  double fit_of_jackson_and_green(double w, double hardness) const {
    return std::exp(-std::pow(w, 5.0 / 12) / 4) * w * std::sqrt(w) +
           4 * hardness / of_poisson_ * (1 - std::exp(-std::pow(w, 5.0 / 9) / 25)) * w;
  }
  Hertz law_;
  double hardness_, of_poisson_;  ///< H/Y of a small contact, C(nu) = 1.295 exp(0.736 nu)
  double critical_depth_ = 0, critical_force_ = 0, exponent_ = 0;
  double deepest_ = 0, largest_ = 0, residual_ = 0, unloading_ = 1.5;
};

/// The body that yields first: of the lower yield stress where the case has one, else of the lower modulus,
/// as if both were of the same strength.
bool particle_is_softer(const Experiment& e) {
  if (e.particle_yield != e.substrate_yield) return e.particle_yield < e.substrate_yield;
  return e.particle.youngs_modulus <= e.substrate.youngs_modulus;
}

class BulkPlasticity : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "bulk_plasticity",
        "Plasticity under the contact",
        "f/f_c = w^(3/2) [1 + P(w)]^(-1/2) f_JG(w, H)/f_JG(w, 2.84 Y), w = d/d_c; unloading f_m [(d - "
        "d_r)/(d_m - d_r)]^n",
        "Jackson & Green 2005 (d_c, f_c, H, f_JG); Etsion, Kligerman & Kadin 2005 (unloading); numbers "
        "fitted to "
        "axisymmetric finite elements",
        "The softer body yields under the contact: loading is softer than elastic, unloading is steeper, and "
        "an imprint stays.",
        EffectKind::contact,
        {Motion::normal},
        {},
        {"normal_law"},
        1,
        true,
        0.1,
        0.015};
    return d;
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    // The yield stress at which yielding would just begin under the largest load (1.6 Y = peak pressure), and
    // well below it.
    const double onset = e.hertz().peak_pressure(e.largest_force) / 1.6;
    EffectParameter yield{"yield_stress",
                          "Pa",
                          "Y of the softer body",
                          0.01 * onset,
                          1.5 * onset,
                          true,
                          {0.08 * onset, 0.25 * onset, 0.6 * onset}};
    if (e.yield_hint > yield.low && e.yield_hint < yield.high) yield.starts.push_back(e.yield_hint);
    for (const double of_case : values_in_case(e))
      if (of_case > yield.low && of_case < yield.high) yield.starts.push_back(of_case);
    // Of finite elements the hardness is an answer, and no parameter.
    if (e.by_finite_elements) return {yield};
    return {yield,
            {"hardness_ratio",
             "",
             "H/Y of a small contact; 2.84 without hardening",
             1.8,
             4,
             false,
             {without_hardening}}};
  }
  EntersBy enters_by(const Experiment&) const override { return EntersBy::finite_elements; }
  std::vector<double> values_in_case(const Experiment& e) const override {
    const double yield = std::min(e.particle_yield, e.substrate_yield);
    return std::isfinite(yield) ? std::vector<double>{yield} : std::vector<double>{};
  }
  bool returns_on_another_curve() const override { return true; }
  std::vector<CaseChange> case_changes(const Experiment& e, const double* p) const override {
    return {{particle_is_softer(e) ? "Particle/Yield stress" : "Substrate/Yield stress", p[0], "Pa"}};
  }
  std::string why_not_by_finite_elements(const Experiment&) const override { return ""; }
  void assemble(Mechanics& m, const double* p) const override {
    const Experiment& e = m.experiment;
    const double poisson = particle_is_softer(e) ? e.particle.poisson_ratio : e.substrate.poisson_ratio;
    const double hardness = e.by_finite_elements ? without_hardening : p[1];
    m.normal.contact = std::make_shared<YieldingContact>(m.geometry, p[0], hardness, poisson);
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(bulk_plasticity, BulkPlasticity)

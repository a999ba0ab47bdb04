// A sphere that yields under the contact, by the law of yielding_contact.h.
#include <cmath>

#include "diagnosis/catalogue/effect.h"
#include "diagnosis/mechanics/yielding_contact.h"

namespace asperity {
namespace {

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
             {YieldingContact::without_hardening}}};
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
    const double hardness = e.by_finite_elements ? YieldingContact::without_hardening : p[1];
    m.normal.contact =
        std::make_shared<YieldingContact>(m.geometry, p[0], hardness, softer_body(e).poisson_ratio);
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(bulk_plasticity, BulkPlasticity)

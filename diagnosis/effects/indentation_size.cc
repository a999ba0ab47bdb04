// A body whose yield stress is higher in a small volume (Nix & Gao 1998, by the depth of the
// indentation):
//   Y = Y_0 [1 + h*/d]^(1/2),
// in the law of a yielding sphere (yielding_contact.h); the history is that of the deepest point so far.
#include <cmath>

#include "diagnosis/catalogue/effect.h"
#include "diagnosis/mechanics/yielding_contact.h"

namespace asperity {
namespace {

class SizeDependentContact : public NormalContact {
 public:
  SizeDependentContact(const Hertz& law, double yield, double length, double poisson)
      : law_(law), yield_(yield), length_(length), poisson_(poisson), at_deepest_(contact_at(length)) {}
  std::unique_ptr<NormalContact> clone() const override {
    return std::make_unique<SizeDependentContact>(*this);
  }
  double force(double d) const override {
    if (d <= 0) return 0;
    return d > deepest_ ? contact_at(d).force(d) : at_deepest_.force(d);
  }
  double displacement(double force) const override { return at_deepest_.displacement(force); }
  void accept(double d) override {
    if (d <= deepest_) return;
    deepest_ = d;
    at_deepest_ = contact_at(d);
    at_deepest_.accept(d);
  }

 private:
  YieldingContact contact_at(double d) const {
    return {law_, yield_ * std::sqrt(1 + length_ / d), YieldingContact::without_hardening, poisson_};
  }
  Hertz law_;
  double yield_, length_, poisson_;
  YieldingContact at_deepest_;
  double deepest_ = 0;
};

class IndentationSize : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{"indentation_size",
                                     "Yield stress that grows at small depth",
                                     "Y = Y_0 (1 + h*/d)^(1/2) in the law of bulk_plasticity",
                                     "Nix & Gao 1998; Swadener, George & Pharr 2002",
                                     "A small indentation needs denser dislocations for its shape: the body "
                                     "is harder than at large depth.",
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
  int effects_held() const override { return 2; }  // bulk_plasticity, and its yield stress that varies
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    constexpr double least = 0.2;  // of the range: below, the yield stress hardly varies in what was recorded
    const double onset = e.hertz().peak_pressure(e.largest_force) / 1.6, range = e.largest_displacement;
    return {{"yield_stress",
             "Pa",
             "Y_0 of the softer body at large depth",
             0.01 * onset,
             1.5 * onset,
             true,
             {0.05 * onset, 0.2 * onset}},
            {"length", "m", "h*", least * range, 100 * range, true, {0.5 * range, 2 * range}}};
  }
  std::string why_not_by_finite_elements(const Experiment&) const override {
    return "a yield stress that follows the depth of the indentation is no law of a material point";
  }
  void assemble(Mechanics& m, const double* p) const override {
    m.normal.contact = std::make_shared<SizeDependentContact>(m.geometry, p[0], p[1],
                                                              softer_body(m.experiment).poisson_ratio);
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(indentation_size, IndentationSize)

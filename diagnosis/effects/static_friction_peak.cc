// More friction after each reversal than in steady sliding: mu_s = ratio mu_d, which decays with slip:
//   mu = mu_d [1 + (ratio - 1) exp(-s/L)],  s: path slipped since the reversal.
#include <cmath>

#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class StaticFrictionPeak : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{"static_friction_peak",
                                     "Static friction above dynamic friction",
                                     "mu = mu_d [1 + (ratio - 1) exp(-s/L)]",
                                     "Rabinowicz 1951; Baumberger & Caroli 2006, sec. 3",
                                     "To set the contact in motion takes more than to keep it moving; the "
                                     "excess fades over a slip length.",
                                     EffectKind::contact,
                                     {Motion::sliding, Motion::rolling, Motion::rail},
                                     {},
                                     {},
                                     2,
                                     true,
                                     0.15};  // off a fall linear in slip (Ida 1972) by 13 to 18 % at best
    return d;
  }
  bool can_show(const Experiment& e) const override { return e.has_trace; }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double path = e.stroke;
    return {{"peak_ratio", "", "static over dynamic friction", 1, 10, false, {1.1, 1.5}},
            {"slip_length",
             "m",
             "L, over which the excess fades",
             1e-4 * path,
             path,
             true,
             {0.01 * path, 0.05 * path, 0.2 * path}}};
  }
  EntersBy enters_by(const Experiment& e) const override {
    return e.is_lateral() ? EntersBy::on_friction : EntersBy::reduced_law_only;
  }
  void assemble(Mechanics& m, const double* p) const override {
    const double excess = p[0] - 1, length = p[1];
    m.lateral.coefficient_changes.push_back([excess, length](double mu, const SlipState& s) {
      return mu * (1 + excess * std::exp(-s.slip / length));
    });
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(static_friction_peak, StaticFrictionPeak)

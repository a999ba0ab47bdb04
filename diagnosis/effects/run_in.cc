// Friction that changes from cycle to cycle towards a steady value: mu_n = mu [1 + change exp(-n/cycles)],
// n: cycles so far, with the part of the present one that has passed.
#include <cmath>

#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class RunIn : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{"run_in",
                                     "Running-in",
                                     "mu_n = mu [1 + change exp(-n/cycles)]",
                                     "Blau 2005, sec. 2; Colaco & Serro 2020",
                                     "The surfaces change while they slide (films, asperities, debris): "
                                     "friction goes to a steady value over some cycles.",
                                     EffectKind::contact,
                                     {Motion::sliding, Motion::rolling, Motion::rail},
                                     {},
                                     {},
                                     3,
                                     true,
                                     0.1};
    return d;
  }
  bool can_show(const Experiment& e) const override { return e.cycles >= fewest_cycles; }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    // A change that hardly fades would stand for a friction that the case says wrongly.
    const double longest = (e.by_finite_elements ? 3 : 10) * e.cycles;
    return {
        {"change",
         "",
         "relative change of mu at the beginning against the steady value",
         -0.95,
         10,
         false,
         {-0.2, 0.2}},
        {"cycles", "", "over which the change fades", 0.1, longest, true, {0.1 * e.cycles, 0.4 * e.cycles}}};
  }
  EntersBy enters_by(const Experiment& e) const override {
    return e.is_lateral() ? EntersBy::on_friction : EntersBy::reduced_law_only;
  }
  void assemble(Mechanics& m, const double* p) const override {
    const double change = p[0], cycles = p[1];
    m.lateral.coefficient_changes.push_back([change, cycles](double mu, const SlipState& s) {
      return mu * (1 + change * std::exp(-s.sample->cycles_passed / cycles));
    });
  }

 private:
  static constexpr double fewest_cycles = 3;
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(run_in, RunIn)

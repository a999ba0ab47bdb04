// A shear strength of the interface beside friction in proportion to load: |f_l| <= tau_0 pi a^2 + mu f_n, a
// by Hertz.
#include <cmath>

#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class TwoTermFriction : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "two_term_friction",
        "Friction of two terms, area and load",
        "|f_l| <= tau_0 pi a^2 + mu f_n, a^3 = 3 f_n R/(4 E*)",
        "Bowden & Tabor 1950; Briscoe & Evans 1982 (shear strength tau_0 + mu p)",
        "The shear strength of the interface has a part of its own and one that grows with pressure: "
        "friction "
        "follows the area at low load and the load at high load.",
        EffectKind::contact,
        {Motion::sliding},
        {},
        {"sliding_law"},
        1};
    return d;
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double strength = e.largest_response / e.hertz().contact_area(e.largest_force);
    return {{"shear_strength", "Pa", "tau_0", 0, 30 * strength, false, {0.1 * strength, 0.5 * strength}}};
  }
  EntersBy enters_by(const Experiment&) const override { return EntersBy::finite_elements; }
  std::vector<CaseChange> case_changes(const Experiment&, const double* p) const override {
    return {{"Interface/Adhesive shear strength", p[0], "Pa"}};
  }
  void assemble(Mechanics& m, const double* p) const override {
    const double strength = p[0];
    m.lateral.limit_changes.push_back([strength](double limit, const SlipState& s) {
      return limit + strength * M_PI * s.contact_radius * s.contact_radius;
    });
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(two_term_friction, TwoTermFriction)

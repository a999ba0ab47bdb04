// The contact is on another curvature (or modulus) than the nominal one: R -> ratio R in f = 4/3 E* R^(1/2)
// d^(3/2).
#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class EffectiveRadius : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "effective_radius",
        "Effective radius (or modulus)",
        "f = 4/3 E* (ratio R)^(1/2) d^(3/2)",
        "Hertz 1882; Johnson 1985, ch. 4",
        "The sphere is flatter or more curved at the contact than its nominal radius says, or the bodies "
        "stiffer or softer: a normal "
        "curve cannot distinguish these (a ratio of radii q stands for a ratio of moduli q^(1/2)).",
        EffectKind::contact,
        {Motion::normal},
        {},
        {},
        0};
    return d;
  }
  std::vector<EffectParameter> parameters(const Experiment&) const override {
    return {{"radius_ratio",
             "",
             "radius at the contact over the nominal one",
             0.1,
             10,
             true,
             {0.5, 0.9, 1.1, 2},
             false,
             1}};
  }
  EntersBy enters_by(const Experiment&) const override { return EntersBy::finite_elements; }
  std::vector<CaseChange> case_changes(const Experiment& e, const double* p) const override {
    return {{"Particle/Radius", p[0] * e.radius, "m"}};
  }
  std::string why_not_by_finite_elements(const Experiment&) const override { return ""; }
  void assemble(Mechanics& m, const double* p) const override {
    m.geometry.radius *= p[0];
    m.normal.contact = std::make_shared<HertzContact>(m.geometry);
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(effective_radius, EffectiveRadius)

// Resistance that no load changes: |f_l| <= mu f_n + f_0. With one mu that is an offset of the load; where
// roughness changes mu the two part.
#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class ConstantLateralForce : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "constant_lateral_force",
        "Lateral force that does not depend on load",
        "|f_l| <= mu f_n + f_0",
        "Coulomb 1785 (friction of two terms); Bowden & Tabor 1950",
        "A part of the resistance is the same at every load and on every surface: a meniscus that is drawn "
        "along, a guide that rubs.",
        EffectKind::contact,
        {Motion::sliding, Motion::rolling, Motion::rail}};
    return d;
  }
  /// Without other values of mu it is the offset of adhesion, which is named so.
  NeededValues needs() const override { return {"rms_roughness", 2}; }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double f = e.largest_response;
    return {{"force", "N", "f_0", 0, 3 * f, false, {0.05 * f, 0.3 * f}}};
  }
  EntersBy enters_by(const Experiment& e) const override {
    return e.mode == Motion::rolling ? EntersBy::beside : EntersBy::reduced_law_only;
  }
  void assemble(Mechanics& m, const double* p) const override {
    const double force = p[0];
    m.lateral.beside.push_back([force](const SlipState&) { return force; });
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(constant_lateral_force, ConstantLateralForce)

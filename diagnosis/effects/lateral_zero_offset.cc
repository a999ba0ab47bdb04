// The lateral sensor does not read zero without force: f_l = f + f0.
#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class LateralZeroOffset : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "lateral_zero_offset",
        "Zero of the lateral sensor",
        "f_l = f + f0",
        "Ogletree, Carpick & Salmeron 1996, sec. II",
        "The sensor's zero is off by a constant, whatever the load or the direction of motion.",
        EffectKind::instrument,
        {Motion::sliding, Motion::rolling, Motion::rail, Motion::torsion}};
    return d;
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double f = e.largest_response;
    return {{"offset", "N", "f0", -2 * f, 2 * f, false, {-0.05 * f, 0.05 * f}}};
  }
  void assemble(Mechanics& m, const double* p) const override {
    const double offset = p[0];
    m.lateral.additions.push_back([offset](const Sample&) { return offset; });
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(lateral_zero_offset, LateralZeroOffset)

// Adhesion that presses the surfaces together without a load from outside: |f_l| <= mu (f_n + h).
#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class AdhesionOffset : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "adhesion_offset",
        "Offset of sliding friction by adhesion",
        "|f_l| <= mu (f_n + h)",
        "Derjaguin 1934; Fuchs, Weinhart et al. 2014, eq. (yield1)",
        "Friction does not vanish with the load: attraction acts like an additional normal force.",
        EffectKind::contact,
        {Motion::sliding, Motion::torsion}};
    return d;
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    return {{"adhesion_force",
             "N",
             "h",
             0,
             30 * e.largest_force,
             false,
             {0.03 * e.typical_force, 0.3 * e.typical_force}}};
  }
  void assemble(Mechanics& m, const double* p) const override { m.lateral.offset += p[0]; }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(adhesion_offset, AdhesionOffset)

// Rolling resistance that does not vanish with the load: f_l = mu_ro (f_n + h_ro).
#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class RollingAdhesionOffset : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "rolling_adhesion_offset",
        "Offset of rolling friction by adhesion",
        "f_l = mu_ro (f_n + h_ro)",
        "Fuchs, Weinhart et al. 2014, eq. (fs1); Dominik & Tielens 1995",
        "Rolling costs a force without a load: attraction holds the rear edge of the contact.",
        EffectKind::contact,
        {Motion::rolling, Motion::rail}};
    return d;
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    return {{"adhesion_force",
             "N",
             "h_ro",
             0,
             30 * e.largest_force,
             false,
             {0.05 * e.typical_force, 0.5 * e.typical_force}}};
  }
  EntersBy enters_by(const Experiment& e) const override {
    return e.is_lateral() ? EntersBy::on_friction : EntersBy::reduced_law_only;
  }
  void assemble(Mechanics& m, const double* p) const override { m.lateral.offset += p[0]; }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(rolling_adhesion_offset, RollingAdhesionOffset)

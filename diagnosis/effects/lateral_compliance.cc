// Lateral compliance in series with the sliding contact: x = x_contact + C f_l.
#include "core/shear_moduli.h"
#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class LateralCompliance : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "lateral_compliance",
        "Lateral compliance in series",
        "x = x_contact + C f_l",
        "Carpick, Ogletree & Salmeron 1997, eq. (1)",
        "Indenter, cantilever or particle mounting is laterally compliant: after a reversal the force turns "
        "more slowly than the contact's own stiffness would let it.",
        EffectKind::instrument,
        {Motion::sliding, Motion::rolling, Motion::rail}};
    return d;
  }
  bool can_show(const Experiment& e) const override { return e.has_trace; }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double a = e.hertz().contact_radius(e.typical_force);
    const double contact = 1 / (8 * reduced_shear_modulus(e.particle, e.substrate) * a);
    const double largest = e.largest_response > 0 ? e.stroke / e.largest_response : 1e4 * contact;
    return {{"compliance",
             "m/N",
             "C of what lies in series with the contact",
             0,
             2 * largest,
             false,
             {contact, 0.02 * largest, 0.1 * largest, 0.3 * largest}}};
  }
  void assemble(Mechanics& m, const double* p) const override { m.lateral.compliance += p[0]; }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(lateral_compliance, LateralCompliance)

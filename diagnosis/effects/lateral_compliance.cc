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
    const double contact = of_contact(e);
    const double largest = e.largest_response > 0 ? e.stroke / e.largest_response : 1e4 * contact;
    return {{"compliance",
             "m/N",
             "C of what lies in series with the contact",
             0,
             2 * largest,
             false,
             {contact, 0.02 * largest, 0.1 * largest, 0.3 * largest}}};
  }
  /// A tenth of the contact's own compliance, with which it lies in series: attraction that presses the
  /// surfaces together widens the contact (Derjaguin, Muller & Toporov 1975) or does not, and roughness makes
  /// it softer than Mindlin's.
  std::vector<double> left_open(const Experiment& e) const override { return {0.1 * of_contact(e)}; }
  void assemble(Mechanics& m, const double* p) const override { m.lateral.compliance += p[0]; }

 private:
  /// Mindlin (1949), no slip, at a typical load [m/N].
  static double of_contact(const Experiment& e) {
    const double a = e.hertz().contact_radius(e.typical_force);
    return 1 / (8 * reduced_shear_modulus(e.particle, e.substrate) * a);
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(lateral_compliance, LateralCompliance)

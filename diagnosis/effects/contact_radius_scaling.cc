// The length over which rolling (or torsion) resists is the radius of the contact, not of the particle: mu r
// -> mu a.
#include "core/hertz.h"
#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class ContactRadiusScaling : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{"contact_radius_scaling",
                                     "Resistance scales with the contact radius",
                                     "2 r f_l = sum over the contacts of mu a f_n; torsion: M = mu a f_n",
                                     "Tabor 1955; Johnson 1985, sec. 9.2; Lubkin 1951 for torsion; Fuchs, "
                                     "Weinhart et al. 2014, sec. 3.2.3",
                                     "The lever of the resistance is the contact's radius, which grows with "
                                     "load (f_n^(1/3)) and with the particle's: force grows as f_n^(4/3).",
                                     EffectKind::contact,
                                     {Motion::rolling, Motion::rail, Motion::torsion},
                                     {"rolling_friction", "torsion_friction"},
                                     {"rolling_coefficient"},
                                     1};
    return d;
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double mu =
        e.largest_response / e.largest_force * e.radius / e.hertz().contact_radius(e.largest_force);
    std::vector<EffectParameter> list{{"rolling_friction",
                                       "",
                                       "mu of rolling (in torsion: of torsion) with lambda = a",
                                       1e-3 * mu,
                                       100 * mu,
                                       true,
                                       {0.5 * mu, 1.5 * mu}}};
    return list;
  }
  std::string why_not_by_finite_elements(const Experiment&) const override {
    return "how the resistance follows the contact radius is what the solution says";
  }
  void assemble(Mechanics& m, const double* p) const override {
    m.lateral.length = LengthScale::contact_radius;
    m.lateral.coefficient = p[0];
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(contact_radius_scaling, ContactRadiusScaling)

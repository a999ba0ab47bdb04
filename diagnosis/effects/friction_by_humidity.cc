// Water that condenses between asperities presses the surfaces together: |f_l| <= mu (f_n + h(H)). The number
// of bridges grows with the Kelvin radius r_K = lambda/ln(1/H) (Riedo, Levy & Brune 2002; Halsey & Levine
// 1998):
//   h = h_50 ln(2)/ln(1/H),  h_50: at a relative humidity of one half.
#include <algorithm>
#include <cmath>

#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class FrictionByHumidity : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "friction_by_humidity",
        "Friction depends on humidity",
        "|f_l| <= mu (f_n + h), h = h_50 ln(2)/ln(1/H)",
        "Riedo, Levy & Brune 2002; Halsey & Levine 1998; Bocquet et al. 1998",
        "Menisci between the asperities pull the surfaces together; damper air makes more and larger ones.",
        EffectKind::contact,
        {Motion::sliding, Motion::rolling},
        {},
        {},
        2,
        true,
        0.1};
    return d;
  }
  NeededValues needs() const override { return {"humidity", one_more_than_its_constants}; }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    return {{"adhesion_force",
             "N",
             "h_50, at 50 % relative humidity",
             0,
             30 * e.largest_force,
             false,
             {0.03 * e.typical_force, 0.3 * e.typical_force}}};
  }
  void assemble(Mechanics& m, const double* p) const override {
    const double half = p[0];
    m.lateral.offsets.push_back([half](const Sample& s) {
      constexpr double driest = 1e-3, dampest = 0.99;  // in which the law says something
      return half * std::log(2.0) / -std::log(std::clamp(s.humidity, driest, dampest));
    });
  }

 private:
  static constexpr int one_more_than_its_constants = 3;  // with mu
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(friction_by_humidity, FrictionByHumidity)

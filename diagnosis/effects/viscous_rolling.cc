// Rolling resistance in proportion to speed: mu_ro = mu + k v.
#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class ViscousRolling : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{"viscous_rolling",
                                     "Viscous rolling resistance",
                                     "f_l = (mu_ro + k v) f_n",
                                     "Brilliantov & Poschel 1998, eq. (13)",
                                     "The solid gives back less of the energy the faster it is deformed.",
                                     EffectKind::contact,
                                     {Motion::rolling, Motion::rail},
                                     {},
                                     {"rate"},
                                     3};
    return d;
  }
  bool can_show(const Experiment& e) const override {
    return e.slowest > 0 && e.fastest > least_ratio * e.slowest;
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double scale = e.largest_response / (e.largest_force * e.fastest);
    return {{"coefficient", "s/m", "k", 0, 100 * scale, false, {0.1 * scale, scale}}};
  }
  EntersBy enters_by(const Experiment& e) const override {
    return e.is_lateral() ? EntersBy::on_friction : EntersBy::reduced_law_only;
  }
  void assemble(Mechanics& m, const double* p) const override {
    const double k = p[0];
    m.lateral.coefficient_changes.push_back([k](double mu, const SlipState& s) { return mu + k * s.speed; });
  }

 private:
  static constexpr double least_ratio = 1.5;
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(viscous_rolling, ViscousRolling)

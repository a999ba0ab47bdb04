// Another local friction than the case of finite elements states: |t| <= mu p at each point of the interface.
// Reduced laws have their coefficient fitted before physics is added.
#include <algorithm>

#include "dem_compare/laws/hertzian_torsion.h"
#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class FrictionCoefficient : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "friction_coefficient",
        "Local friction other than the case says",
        "|t| <= mu p",
        "Coulomb 1785",
        "Friction of the interface itself, an input of the case that only an experiment tells.",
        EffectKind::contact,
        {Motion::sliding, Motion::torsion},
        {"sliding_friction", "torsion_friction"},
        {"coefficient"},
        0};
    return d;
  }
  bool is_another_value() const override { return true; }
  bool can_show(const Experiment& e) const override { return e.by_finite_elements; }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double recorded = local_friction(e), of_case = e.case_friction > 0 ? e.case_friction : recorded;
    return {{"coefficient",
             "",
             "local mu",
             1e-3 * std::min(of_case, recorded),
             1e3 * std::max(of_case, recorded),
             true,
             {recorded, 0.7 * recorded},
             false,
             of_case}};
  }
  EntersBy enters_by(const Experiment&) const override { return EntersBy::finite_elements; }
  std::vector<CaseChange> case_changes(const Experiment&, const double* p) const override {
    return {{"Interface/Friction coefficient", p[0], ""}};
  }
  void assemble(Mechanics& m, const double* p) const override {
    m.lateral.coefficient = p[0] * per_local(m.experiment);
  }

 private:
  /// Coefficient of the law, over the radius of the contact in torsion, for local friction of 1.
  static double per_local(const Experiment& e) {
    return e.mode == Motion::torsion ? full_slip_torsion_coefficient(1) : 1;
  }
  /// That with which the recorded resistance would be the whole of it.
  static double local_friction(const Experiment& e) {
    const double lever = e.mode == Motion::torsion ? e.hertz().contact_radius(e.largest_force) / e.radius : 1;
    return e.largest_response / (e.largest_force * lever * per_local(e));
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(friction_coefficient, FrictionCoefficient)

// Adhesion that presses the surfaces together without a load from outside: |f_l| <= mu (f_n + h).
#include <cmath>

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
  EntersBy enters_by(const Experiment& e) const override {
    return e.mode == Motion::sliding ? EntersBy::finite_elements : EntersBy::reduced_law_only;
  }
  /// Attraction that presses a sphere as h does (DMT: h = 2 pi w R) over the case's range, which friction
  /// does not tell.
  std::vector<CaseChange> case_changes(const Experiment& e, const double* p) const override {
    constexpr double usual_range = 1e-9;
    return {
        {"Interface/Work of adhesion", p[0] / (2 * M_PI * e.radius), "J/m^2"},
        {"Interface/Adhesion range", e.case_adhesion_range > 0 ? e.case_adhesion_range : usual_range, "m"}};
  }
  void assemble(Mechanics& m, const double* p) const override { m.lateral.offset += p[0]; }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(adhesion_offset, AdhesionOffset)

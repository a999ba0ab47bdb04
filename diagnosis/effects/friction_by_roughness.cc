// Sliding friction that changes with the roughness of the substrate: mu = b + c rms.
#include <algorithm>

#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class FrictionByRoughness : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "friction_by_roughness",
        "Sliding friction depends on roughness",
        "mu = b + c rms",
        "Makinson 1948; Bhushan 1999 (slope of asperities); Fuchs, Weinhart et al. 2014",
        "Asperities interlock or plough more on a rougher substrate (c above zero), or less of the surfaces "
        "adheres (c below zero).",
        EffectKind::contact,
        {Motion::sliding},
        {"sliding_friction"},
        {"sliding_law", "coefficient"},
        1};
    return d;
  }
  NeededValues needs() const override { return {"rms_roughness", one_more_than_its_constants}; }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double mu = e.largest_response / e.largest_force, slope = mu / e.roughest;
    return {{"smooth_friction", "", "b, of a smooth substrate", 1e-3 * mu, 10 * mu, true, {0.3 * mu, mu}},
            {"slope", "1/m", "c", -10 * slope, 10 * slope, false, {-0.3 * slope, 0.3 * slope}}};
  }
  /// Local friction, of each recorded surface its own.
  EntersBy enters_by(const Experiment& e) const override {
    return e.case_rms > 0 ? EntersBy::finite_elements : EntersBy::reduced_law_only;
  }
  std::vector<CaseChange> case_changes(const Experiment& e, const double* p) const override {
    if (!(e.case_rms > 0)) return {};
    return {{"Interface/Friction coefficient", std::max(0.0, p[0] + p[1] * e.case_rms), ""}};
  }
  void assemble(Mechanics& m, const double* p) const override {
    const double b = p[0], c = p[1];
    m.lateral.coefficient_changes.insert(
        m.lateral.coefficient_changes.begin(),
        [b, c](double, const SlipState& s) { return std::max(0.0, b + c * s.sample->rms_roughness); });
  }

 private:
  static constexpr int one_more_than_its_constants = 3;
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(friction_by_roughness, FrictionByRoughness)

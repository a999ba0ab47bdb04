// Rolling friction that falls with the roughness of the substrate: mu_ro = b + c exp(-rms/d).
#include <cmath>

#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class RoughnessDependentRolling : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "roughness_dependent_rolling",
        "Rolling friction depends on roughness",
        "mu_ro = b + c exp(-rms/d)",
        "Fuchs, Weinhart et al. 2014, eq. (murofit)",
        "Asperities keep the surfaces apart: rougher substrates resist rolling less.",
        EffectKind::contact,
        {Motion::rolling, Motion::rail},
        {"rolling_friction"},
        {"rolling_coefficient"},
        1};
    return d;
  }
  NeededValues needs() const override { return {"rms_roughness", one_more_than_its_constants}; }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double mu = e.largest_response / e.largest_force, rms = e.roughest;
    return {{"b", "", "of a very rough substrate", 1e-3 * mu, 10 * mu, true, {0.3 * mu, mu}},
            {"c", "", "added by a smooth one", -3 * mu, 100 * mu, false, {0.3 * mu, mu}},
            {"decay_length", "m", "d", 0.03 * rms, 10 * rms, true, {0.2 * rms, rms}}};
  }
  std::string why_not_by_finite_elements(const Experiment&) const override {
    return "the case is solved with each recorded roughness, and says itself how it rolls there";
  }
  void assemble(Mechanics& m, const double* p) const override {
    const double b = p[0], c = p[1], d = p[2];
    m.lateral.coefficient_changes.insert(
        m.lateral.coefficient_changes.begin(),
        [b, c, d](double, const SlipState& s) { return b + c * std::exp(-s.sample->rms_roughness / d); });
  }

 private:
  static constexpr int one_more_than_its_constants = 4;  // through three roughnesses it always passes
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(roughness_dependent_rolling, RoughnessDependentRolling)

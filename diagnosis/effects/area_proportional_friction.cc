// Friction that follows the area of the contact instead of the load: f_l = tau pi a^2, a by Hertz.
#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class AreaProportionalFriction : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "area_proportional_friction",
        "Friction proportional to the area of contact",
        "f_l = tau pi a^2, a^3 = 3 f_n R/(4 E*)",
        "Bowden & Tabor 1950; Carpick, Ogletree & Salmeron 1997; Homola et al. 1990",
        "The interface has a shear strength of its own: friction grows with the real area, f_n^(2/3) for a "
        "smooth sphere, and not with load.",
        EffectKind::contact,
        {Motion::sliding},
        {"sliding_friction"},
        {"sliding_law", "coefficient"},
        1};
    return d;
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double area = e.hertz().contact_area(e.largest_force), strength = e.largest_response / area;
    return {{"shear_strength",
             "Pa",
             "tau",
             1e-3 * strength,
             100 * strength,
             true,
             {0.7 * strength, 1.5 * strength}}};
  }
  EntersBy enters_by(const Experiment&) const override { return EntersBy::finite_elements; }
  std::vector<CaseChange> case_changes(const Experiment&, const double* p) const override {
    return {{"Interface/Friction coefficient", 0, ""}, {"Interface/Shear strength", p[0], "Pa"}};
  }
  void assemble(Mechanics& m, const double* p) const override {
    m.lateral.follows_area = true;
    m.lateral.coefficient = p[0];
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(area_proportional_friction, AreaProportionalFriction)

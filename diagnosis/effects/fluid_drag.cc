// The fluid around the probe resists its motion: f = f_contact + b d'(t).
#include <algorithm>

#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class FluidDrag : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "fluid_drag",
        "Drag of the fluid",
        "f = f_contact + b dd/dt",
        "Alcaraz et al. 2002, eq. (2)",
        "Liquid or air around the cantilever resists its motion. The force is above its value at rest on "
        "approach and below it on retraction, in proportion to the speed, far off the surface too; it must "
        "not be taken for adhesion or for a lossy contact.",
        EffectKind::instrument,
        {Motion::normal}};
    return d;
  }
  /// A few samples below first touch may be noise of the displacement.
  bool can_show(const Experiment& e) const override {
    constexpr std::size_t fewest = 20;
    return e.samples_off_contact >= fewest && e.has_trace && e.has_time && e.has_unloading &&
           e.response_is_force && e.fastest_approach > 0;
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    constexpr double slow = 1e-12;  // where nothing moves, for which it is not asked [m/s]
    const double most = e.largest_response / std::max(e.fastest_approach, slow);
    return {{"coefficient", "N s/m", "b", 0, most, false, {0.005 * most, 0.05 * most}, false, 0}};
  }
  void assemble(Mechanics& m, const double* p) const override {
    const double coefficient = p[0];
    m.normal.additions.push_back([coefficient](const Sample& s, double) { return coefficient * s.approach; });
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(fluid_drag, FluidDrag)

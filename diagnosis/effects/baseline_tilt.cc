// The force sensor's zero moves with displacement, in contact or not: f = f_contact + b d.
#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class BaselineTilt : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{"baseline_tilt",
                                     "Tilted baseline",
                                     "f = f_contact + b d",
                                     "Butt, Cappella & Kappl 2005, sec. 3.2 (baseline of force curves)",
                                     "A spring of the instrument (support of the indenter, optical "
                                     "interference) adds a force in proportion to displacement; it is "
                                     "there without the sample too, and must not be taken for attraction.",
                                     EffectKind::instrument,
                                     {Motion::normal}};
    return d;
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double slope = e.largest_force / e.largest_displacement;
    return {{"slope", "N/m", "b", -slope, slope, false, {-0.02 * slope, 0.02 * slope}, false, 0}};
  }
  std::string not_recorded(const Experiment& e) const override {
    return e.has_off_contact ? "" : "record approach and retraction out of contact too";
  }
  void assemble(Mechanics& m, const double* p) const override {
    const double slope = p[0];
    m.normal.additions.push_back(
        [slope](const Sample&, double displacement) { return slope * displacement; });
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(baseline_tilt, BaselineTilt)

// The sensor of the normal force does not read zero without force: f = f_contact + f0.
#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class NormalZeroOffset : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "normal_zero_offset",
        "Zero of the normal force",
        "f = f_contact + f0",
        "Butt, Cappella & Kappl 2005, sec. 3.2 (baseline of force curves)",
        "The force sensor's zero is off by a constant, in contact or not. It shows as a force far off the "
        "surface, and must be taken off before a force in contact means anything.",
        EffectKind::instrument,
        {Motion::normal}};
    return d;
  }
  /// A few samples below first touch may be noise of the displacement.
  bool can_show(const Experiment& e) const override {
    constexpr std::size_t fewest = 20;
    return e.samples_off_contact >= fewest && e.has_trace && e.response_is_force;
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double f = e.largest_response;
    return {{"offset", "N", "f0", -f, f, false, {-0.02 * f, 0.02 * f}, false, 0}};
  }
  void assemble(Mechanics& m, const double* p) const override {
    const double offset = p[0];
    m.normal.additions.push_back([offset](const Sample&, double) { return offset; });
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(normal_zero_offset, NormalZeroOffset)

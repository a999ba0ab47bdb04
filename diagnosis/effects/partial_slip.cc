// Slip that begins at the edge of the contact and spreads inwards before the whole contact slides (Cattaneo
// 1938; Mindlin & Deresiewicz 1953), with its full history: mechanics/strip_contact.h. At constant load, from
// rest:
//   x = 3 mu f_n/(16 G* a) [1 - (1 - f_l/(mu f_n))^(2/3)].
#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class PartialSlip : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "partial_slip",
        "Partial slip before sliding",
        "x = 3 mu f_n/(16 G* a) [1 - (1 - f_l/(mu f_n))^(2/3)]; Masing's rule after reversals",
        "Cattaneo 1938; Mindlin & Deresiewicz 1953; Johnson 1985, eq. (7.42)",
        "An annulus at the edge of the contact slips at any lateral force: the loop bends before gross "
        "sliding instead of turning a corner.",
        EffectKind::contact,
        {Motion::sliding},
        {},
        {"stick"},
        1};
    return d;
  }
  bool can_show(const Experiment& e) const override { return e.has_trace && !e.by_finite_elements; }
  std::vector<EffectParameter> parameters(const Experiment&) const override { return {}; }
  void assemble(Mechanics& m, const double*) const override {
    m.lateral.stick = LateralMechanics::Stick::strips;
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(partial_slip, PartialSlip)

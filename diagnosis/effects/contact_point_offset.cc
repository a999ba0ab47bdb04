// The displacement counted from elsewhere than the first touch: d = d_contact + d0.
#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class ContactPointOffset : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{"contact_point_offset",
                                     "Offset of the contact point",
                                     "d = d_contact + d0",
                                     "Dimitriadis et al. 2002 (contact point as a fitted quantity)",
                                     "Zero displacement was set before or after the surfaces touched; the "
                                     "whole curve is shifted along its displacement.",
                                     EffectKind::instrument,
                                     {Motion::normal},
                                     {},
                                     {},
                                     2,
                                     true,
                                     0.005};
    return d;
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double range = e.largest_displacement;
    return {{"offset",
             "m",
             "d0, displacement at which the surfaces touch",
             -2 * range,
             2 * range,
             false,
             {-0.3 * range, -0.03 * range, 0.03 * range, 0.3 * range},
             false,
             0}};
  }
  void assemble(Mechanics& m, const double* p) const override {
    const double offset = p[0];
    m.normal.shifts.push_back([offset](const Sample&) { return offset; });
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(contact_point_offset, ContactPointOffset)

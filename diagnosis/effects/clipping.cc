// The force sensor is at the end of its range: reading = min(f, f_end).
#include <algorithm>

#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class Clipping : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "clipping",
        "Clipped sensor",
        "reading = min(f, f_end)",
        "IEC 60050-311 (measuring range; overload)",
        "Beyond the end of its range the sensor or the converter reads the same, whatever the force.",
        EffectKind::instrument,
        {Motion::normal},
        {},
        {"reading"},
        6};
    return d;
  }
  bool can_show(const Experiment& e) const override { return e.response_is_force && e.has_trace; }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double f = e.largest_force;
    return {{"limit", "N", "f_end", 0.01 * f, 1.05 * f, true, {0.9 * f, 0.97 * f, 0.995 * f}}};
  }
  void assemble(Mechanics& m, const double* p) const override {
    const double limit = p[0];
    m.normal.readings.push_back([limit](double force) { return std::min(force, limit); });
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(clipping, Clipping)

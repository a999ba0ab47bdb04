// A body that relaxes: the modulus falls from E* to (1 - g) E* with the time constant tau (standard linear
// solid). While the contact grows (Lee & Radok 1960)
//   f = 4/3 R^(1/2) int E(t - s) d[d(s)^(3/2)],  E(t) = E* [1 - g + g exp(-t/tau)],
// and on the way back the same until the force is zero, where the contact opens (of Ting's 1966 solution this
// leaves out that the part still in contact remembers its own time).
#include <algorithm>
#include <cmath>

#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class RelaxingContact : public NormalContact {
 public:
  RelaxingContact(const Hertz& law, double share, double time_constant)
      : law_(law), share_(share), time_constant_(time_constant) {}
  std::unique_ptr<NormalContact> clone() const override { return std::make_unique<RelaxingContact>(*this); }
  void begin_step(double time_step) override { step_ = time_step / time_constant_; }
  double force(double d) const override {
    if (d <= 0) return 0;
    const double now = elastic(d);
    return std::max(0.0, (1 - share_) * now + share_ * stretched(now));
  }
  void accept(double d) override {
    const double now = elastic(d);
    stretched_ = stretched(now);
    last_ = now;
  }

 private:
  double elastic(double d) const {
    return d > 0 ? 4.0 / 3 * law_.reduced_modulus * std::sqrt(law_.radius * d) * d : 0;
  }
  /// Force of the part that relaxes, with the elastic force growing evenly over the step.
  double stretched(double now) const {
    const double left = std::exp(-step_), mean = step_ > 1e-9 ? (1 - left) / step_ : 1;
    return stretched_ * left + (now - last_) * mean;
  }
  Hertz law_;
  double share_, time_constant_;
  double stretched_ = 0, last_ = 0, step_ = 0;  ///< [N], [N], time step over the time constant
};

class Viscoelasticity : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "viscoelasticity",
        "Viscoelastic body",
        "f = 4/3 R^(1/2) int E(t - s) d[d(s)^(3/2)], E(t) = E* [1 - g + g exp(-t/tau)]",
        "Lee & Radok 1960; Ting 1966; Johnson 1985, sec. 6.5",
        "The body gives way with time: the faster it is pressed the stiffer it is, and unloading lies below "
        "loading without an imprint that stays.",
        EffectKind::contact,
        {Motion::normal},
        {},
        {"normal_law"},
        1,
        true,
        0.1};
    return d;
  }
  /// In a hold it is creep, which is named so. Pressed at one speed it looks like yielding, which is nearer
  /// at hand for a stiff body.
  bool can_show(const Experiment& e) const override {
    constexpr double least_ratio = 2, stiffest_polymer = 20e9;
    return e.has_time && e.has_unloading && e.hold_duration == 0 &&
           (e.fastest_run > least_ratio * e.slowest_run || e.reduced_modulus() < stiffest_polymer);
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double time = e.duration;
    return {
        {"share", "", "g, part of the modulus that relaxes", 1e-3, 0.999, false, {0.1, 0.5}},
        {"time_constant", "s", "tau", 1e-3 * time, 100 * time, true, {0.05 * time, 0.3 * time, 2 * time}}};
  }
  void assemble(Mechanics& m, const double* p) const override {
    m.normal.contact = std::make_shared<RelaxingContact>(m.geometry, p[0], p[1]);
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(viscoelasticity, Viscoelasticity)

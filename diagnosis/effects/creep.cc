// Displacement that grows while the contact is pressed: d = d_contact + q,  tau dq/dt = A d_contact/d_H - q
// (a Kelvin element in series), d_H: by Hertz under the largest load. In a hold at that load q goes to A as
// exp(-t/tau); in the ramps it follows as far as their time allows. Under displacement control the force
// relaxes by it.
#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class Creep : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "creep",
        "Creep",
        "d = d_contact + q, tau dq/dt = A d_contact/d_H - q; held at the largest load: q = A [1 - "
        "exp(-t/tau)]",
        "Kelvin & Voigt; Johnson 1985, sec. 6.5; Chudoba & Richter 2001, eq. (1)",
        "The approach keeps growing while the load is held, quickly at first and towards a limit.",
        EffectKind::contact,
        {Motion::normal},
        {},
        {},
        2,
        true,
        0.15};
    return d;
  }
  bool can_show(const Experiment& e) const override { return e.hold_duration > 0 && e.has_time; }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double range = e.largest_displacement, hold = e.hold_duration;
    return {{"amplitude",
             "m",
             "A, growth in a long hold",
             1e-5 * range,
             3 * range,
             true,
             {0.01 * range, 0.1 * range}},
            {"time_constant", "s", "tau", 1e-3 * hold, 30 * hold, true, {0.05 * hold, 0.3 * hold, 2 * hold}}};
  }
  EntersBy enters_by(const Experiment&) const override { return EntersBy::in_series; }
  std::string why_not_by_finite_elements(const Experiment&) const override { return ""; }
  void assemble(Mechanics& m, const double* p) const override {
    m.normal.delays.push_back({p[0] / m.experiment.hertz().approach(m.experiment.largest_force), p[1]});
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(creep, Creep)

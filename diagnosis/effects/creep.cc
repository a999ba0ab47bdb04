// Displacement that grows while the load is held: d = d_contact + A [1 - exp(-t/tau)] in each hold, t since it began; what has
// grown stays. Under displacement control the force relaxes by it.
#include <cmath>

#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class Creep : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "creep", "Creep in holds", "d = d_contact + A [1 - exp(-t_hold/tau)]", "Kelvin & Voigt; Chudoba & Richter 2001, eq. (1)",
        "The contact goes on giving way while the load is held, quickly at first and then to a limit.",
        EffectKind::contact, {Mode::normal}, {}, {}, 2, true, 0.15};
    return d;
  }
  bool can_show(const Experiment& e) const override { return e.hold_duration > 0 && e.has_time; }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double range = e.largest_displacement, hold = e.hold_duration;
    return {{"amplitude", "m", "A, growth in a long hold", 1e-5 * range, 3 * range, true, {0.01 * range, 0.1 * range}},
            {"time_constant", "s", "tau", 1e-3 * hold, 30 * hold, true, {0.05 * hold, 0.3 * hold, 2 * hold}}};
  }
  void assemble(Mechanics& m, const double* p) const override {
    const double amplitude = p[0], tau = p[1];
    m.normal.shifts.push_back([amplitude, tau, grown = 0.0, in_hold = 0.0, hold = 0](const Sample& s) mutable {
      if (s.hold != hold) grown += in_hold, in_hold = 0, hold = s.hold;
      if (s.hold_time > 0) in_hold = amplitude * (1 - std::exp(-s.hold_time / tau));
      return grown + in_hold;
    });
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(creep, Creep)

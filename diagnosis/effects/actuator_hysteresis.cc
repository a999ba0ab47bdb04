// A piezo without a sensor of its own does not come back along its way there: on the way back the
// displacement that is recorded lies beside the one that was made, by nothing at both ends of the way and by
// most in its middle,
//   d = d_contact + 4 h x (1 - x) on the way back,  x: the part of the way, from its start to its turning
//   point.
#include <algorithm>

#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class ActuatorHysteresis : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "actuator_hysteresis",
        "Hysteresis of the actuator",
        "d = d_contact + 4 h x (1 - x) on the way back, x = (d - d_start)/(d_turn - d_start)",
        "Hues, Draper, Lee & Colton 1994, Rev. Sci. Instrum. 65, 1561",
        "The piezo's displacement is what was asked of it, not what was measured; on the way back it lags "
        "behind. Unlike yielding it leaves nothing at the start of the way, and it may have either sign.",
        EffectKind::instrument,
        {Motion::normal},
        {},
        {},
        2,
        true,
        0.15};
    return d;
  }
  bool can_show(const Experiment& e) const override {
    return e.response_is_force && e.has_trace && e.has_unloading;
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double range = e.largest_displacement;
    return {{"lag",
             "m",
             "h, largest shift of the way back",
             -0.5 * range,
             0.5 * range,
             false,
             {-0.05 * range, 0.05 * range},
             false,
             0}};
  }
  EntersBy enters_by(const Experiment&) const override { return EntersBy::reduced_law_only; }
  std::string why_not_by_finite_elements(const Experiment&) const override {
    return "beside a solved case its loop is not yet told from that of yielding";
  }
  void assemble(Mechanics& m, const double* p) const override {
    const double lag = p[0];
    m.normal.shifts.push_back([lag, begun = false, start = 0.0, turn = 0.0](const Sample& s) mutable {
      if (!begun) start = turn = s.normal_displacement, begun = true;
      if (s.direction > 0) turn = std::max(turn, s.normal_displacement);
      if (s.direction > 0 || turn <= start) return 0.0;
      const double x = std::clamp((s.normal_displacement - start) / (turn - start), 0.0, 1.0);
      return 4 * lag * x * (1 - x);
    });
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(actuator_hysteresis, ActuatorHysteresis)

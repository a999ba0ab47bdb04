// Friction with a memory of the last contact: mu = mu0 + a ln(v/v0) + b ln(v0 theta/L),  d theta/dt = 1 - v
// theta/L (ageing law: Dieterich 1979; Ruina 1983). Between samples the speed is taken as constant: theta
// goes to L/v as exp(-v dt/L). Beside the slip law (Ruina 1983) it comes back later after a step up and
// sooner after one down: by 13 % of b ln r at most for steps of a ratio r of 3.
#include <cmath>

#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class RateAndState : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{"rate_and_state",
                                     "Rate-and-state friction",
                                     "mu = mu0 + a ln(v/v0) + b ln(v0 theta/L), d theta/dt = 1 - v theta/L",
                                     "Dieterich 1979; Ruina 1983, eq. (1); Marone 1998",
                                     "A change of speed makes friction jump at once (a) and come back over a "
                                     "slip distance (b), while contacts are renewed.",
                                     EffectKind::contact,
                                     {Motion::sliding},
                                     {},
                                     {"rate"},
                                     3,
                                     true,
                                     0.15};
    return d;
  }
  bool can_show(const Experiment& e) const override {
    return e.has_trace && e.has_time && e.slowest > 0 && e.fastest > least_ratio * e.slowest;
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double mu = e.largest_response / e.largest_force, path = std::max(e.stroke, e.slowest * e.duration);
    return {{"a", "", "direct effect", 0, mu, false, {0.01 * mu, 0.05 * mu}},
            {"b", "", "evolution effect", -mu, mu, false, {0.005 * mu, 0.02 * mu, 0.08 * mu}},
            {"slip_distance", "m", "L", 1e-5 * path, path, true, {0.003 * path, 0.02 * path, 0.1 * path}}};
  }
  EntersBy enters_by(const Experiment& e) const override {
    return e.mode == Motion::sliding ? EntersBy::on_friction : EntersBy::reduced_law_only;
  }
  void assemble(Mechanics& m, const double* p) const override {
    const double a = p[0], b = p[1], length = p[2];
    const double slowest = 0.1 * m.experiment.slowest,
                 reference = std::sqrt(m.experiment.slowest * m.experiment.fastest);
    m.lateral.coefficient_changes.push_back(
        [a, b, length, slowest, reference, theta = 0.0](double mu, const SlipState& s) mutable {
          const double v = std::max(s.speed, slowest), steady = length / v;
          theta = theta > 0 ? steady + (theta - steady) * std::exp(-v * s.time_step / length) : steady;
          return mu + a * std::log(v / reference) + b * std::log(reference * theta / length);
        });
  }

 private:
  static constexpr double least_ratio = 1.5;
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(rate_and_state, RateAndState)

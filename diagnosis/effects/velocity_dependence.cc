// Friction that follows the logarithm of speed: mu = mu0 + b ln(v/v0), v0 the geometric mean of the speeds
// recorded.
#include <cmath>

#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class VelocityDependence : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{"velocity_dependence",
                                     "Friction depends on speed",
                                     "mu = mu0 + b ln(v/v0)",
                                     "Gnecco et al. 2000, eq. (3); Dieterich 1979 (steady state)",
                                     "Bonds of the contact break with the help of heat and time: friction "
                                     "changes by the same amount for every factor of speed.",
                                     EffectKind::contact,
                                     {Motion::sliding, Motion::rolling, Motion::rail, Motion::torsion},
                                     {},
                                     {"rate"},
                                     3};
    return d;
  }
  bool can_show(const Experiment& e) const override {
    return e.slowest > 0 && e.fastest > least_ratio * e.slowest;
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double mu = e.largest_response / e.largest_force;
    return {{"coefficient",
             "",
             "b, change of mu for a factor e of speed",
             -mu,
             mu,
             false,
             {-0.05 * mu, 0.05 * mu}}};
  }
  EntersBy enters_by(const Experiment& e) const override {
    return e.is_lateral() ? EntersBy::on_friction : EntersBy::reduced_law_only;
  }
  void assemble(Mechanics& m, const double* p) const override {
    const double b = p[0], slowest = 0.1 * m.experiment.slowest,
                 reference = std::sqrt(m.experiment.slowest * m.experiment.fastest);
    m.lateral.coefficient_changes.push_back([b, slowest, reference](double mu, const SlipState& s) {
      return mu + b * std::log(std::max(s.speed, slowest) / reference);
    });
  }

 private:
  static constexpr double least_ratio = 1.5;  // of speeds that count as different
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(velocity_dependence, VelocityDependence)

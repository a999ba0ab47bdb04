// Spin against the slopes of a rail costs a moment M = mu_to r f_s (Fuchs, Weinhart et al. 2014, eq:murail,
// eq:muto2):
//   mu_rail = (2 cos(theta) mu_ro + sin(theta) mu_to)/(1 + cos(theta)) at one slope.
#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class TorsionResistance : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{"torsion_resistance",
                                     "Torsion resistance in the rail",
                                     "f_l = [2 mu_ro + tan(theta) mu_to]/(1 + cos(theta)) f_n at the plate",
                                     "Fuchs, Weinhart et al. 2014, eqs. (murail), (muto2)",
                                     "In a groove the particle does not only roll but spins against the "
                                     "slopes; the spin is resisted too, the more the steeper they are.",
                                     EffectKind::contact,
                                     {Motion::rail},
                                     {"torsion_friction"}};
    return d;
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double mu = e.largest_response / e.largest_force;
    return {{"torsion_friction", "", "mu_to, moment over r f_n", 1e-4 * mu, 100 * mu, true, {0.1 * mu, mu}}};
  }
  void assemble(Mechanics& m, const double* p) const override { m.lateral.torsion_coefficient = p[0]; }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(torsion_resistance, TorsionResistance)

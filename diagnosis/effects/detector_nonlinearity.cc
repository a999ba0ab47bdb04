// The force sensor reads less (or more) than in proportion at large deflection, as a split photodiode does
// towards its edge:
//   reading = f [1 - c (f/f_max)^2],  f_max: the largest reading of the recording.
#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class DetectorNonlinearity : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "detector_nonlinearity",
        "Nonlinear force sensor",
        "reading = f [1 - c (f/f_max)^2]",
        "Schaeffer 2002, J. Appl. Phys. 91, 4739; Butt, Cappella & Kappl 2005",
        "The sensor is calibrated for small deflections and is not in proportion at large ones.",
        EffectKind::instrument,
        {Motion::normal},
        {},
        {"reading"},
        5};
    return d;
  }
  /// While a contact is only loaded, yielding does the same.
  bool can_show(const Experiment& e) const override { return e.response_is_force && e.has_unloading; }
  std::vector<EffectParameter> parameters(const Experiment&) const override {
    constexpr double turns_back = 1.0 / 3;  // where the reading would fall as the force grows
    return {{"coefficient", "", "c", -0.9, turns_back, false, {-0.1, 0.05, 0.15}, false, 0}};
  }
  void assemble(Mechanics& m, const double* p) const override {
    const double coefficient = p[0], largest = m.experiment.largest_force;
    m.normal.readings.push_back([coefficient, largest](double force) {
      const double part = force / largest;
      return force * (1 - coefficient * part * part);
    });
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(detector_nonlinearity, DetectorNonlinearity)

// Compliance of frame, cantilever or holder in series with the contact: d = d_contact + C f_n.
#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class InstrumentCompliance : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "instrument_compliance",
        "Compliance of the instrument",
        "d = d_contact + C f_n",
        "Oliver & Pharr 1992, eq. (7)",
        "A compliance between the displacement sensor and the contact deforms in proportion to the load, so "
        "that part of the recorded displacement never reaches the contact.",
        EffectKind::instrument,
        {Motion::normal}};
    return d;
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double contact = e.largest_displacement / e.largest_force;
    return {{"compliance",
             "m/N",
             "C of what lies in series with the contact",
             0,
             100 * contact,
             false,
             {0.1 * contact, contact}}};
  }
  std::string not_recorded(const Experiment& e) const override {
    // Finite elements try yielding with the case's own bodies; reduced laws are not exact enough to.
    return e.has_unloading || e.by_finite_elements || !e.has_trace
               ? ""
               : "record the unloading, along which an elastic compliance goes back and yielding does not";
  }
  void assemble(Mechanics& m, const double* p) const override {
    const double compliance = p[0];
    m.normal.series.push_back([compliance](double force) { return compliance * force; });
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(instrument_compliance, InstrumentCompliance)

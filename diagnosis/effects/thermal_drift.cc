// The instrument moves against the sample at a constant rate: d = d_contact + rate t, t since the beginning
// of the run.
#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class ThermalDrift : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{"thermal_drift",
                                     "Thermal drift",
                                     "d = d_contact + rate t",
                                     "Oliver & Pharr 1992, sec. III; ISO 14577-1, sec. 8",
                                     "Instrument or sample expand at a steady rate, so that displacement "
                                     "grows with time whether or not the load changes.",
                                     EffectKind::instrument,
                                     {Motion::normal}};
    return d;
  }
  bool can_show(const Experiment& e) const override { return e.has_time && e.has_trace; }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double rate = e.largest_displacement / e.duration;
    return {{"rate",
             "m/s",
             "drift of the displacement",
             -3 * rate,
             3 * rate,
             false,
             {-0.05 * rate, 0.05 * rate},
             false,
             0}};
  }
  std::string not_recorded(const Experiment& e) const override {
    return e.hold_duration > 0 || e.has_unloading ? "" : "hold the largest load, and record the unloading";
  }
  void assemble(Mechanics& m, const double* p) const override {
    const double rate = p[0];
    m.normal.shifts.push_back([rate, begun = false, start = 0.0](const Sample& s) mutable {
      if (!begun) start = s.time, begun = true;
      return rate * (s.time - start);
    });
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(thermal_drift, ThermalDrift)

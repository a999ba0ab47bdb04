// A body that relaxes: the modulus falls from E* to (1 - g) E* with the time constant tau (standard linear
// solid); the law of the contact is relaxing_contact.h. Of a case of finite elements it is the shear modulus
// of one body that relaxes so, and E* as relaxing_modulus.h says.
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "diagnosis/catalogue/effect.h"
#include "diagnosis/mechanics/relaxing_contact.h"
#include "diagnosis/mechanics/yielding_contact.h"
#include "diagnosis/outcome/diagnosis.h"

namespace asperity {
namespace {

bool is_of_elastic_case(const Experiment& e) {
  return std::isinf(std::min(e.particle_yield, e.substrate_yield)) && e.case_work_of_adhesion == 0 &&
         e.case_attraction_force == 0;
}

/// The body that relaxes: of the case, where one does, or else the softer one.
bool particle_relaxes(const Experiment& e) {
  return e.case_relaxes() ? e.particle_relaxation.share > 0 : particle_is_softer(e);
}

/// The shear modulus of that body, where E* of the pair relaxes by `pair`.
RelaxingPart shear_of(const Experiment& e, const RelaxingPart& pair) {
  return particle_relaxes(e) ? relaxing_shear(e.particle, pair, e.substrate)
                             : relaxing_shear(e.substrate, pair, e.particle);
}

RelaxingModulus modulus_of(const Experiment& e, const RelaxingPart& shear) {
  return particle_relaxes(e) ? relaxing_modulus(e.particle, shear, e.substrate)
                             : relaxing_modulus(e.substrate, shear, e.particle);
}

class Viscoelasticity : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "viscoelasticity",
        "Viscoelastic body",
        "f = 4/3 R^(1/2) int E(t - s) d[d(s)^(3/2)], E(t) = E* [1 - g + g exp(-t/tau)]",
        "Lee & Radok 1960; Ting 1966; Johnson 1985, sec. 6.5",
        "The body gives way with time: the faster it is pressed the stiffer it is, and unloading lies below "
        "loading without an imprint that stays. Where the contact shrinks, the integral ends at the time at "
        "which it was as large.",
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
  /// at hand for a stiff body. A case that relaxes may do so by other numbers.
  bool can_show(const Experiment& e) const override {
    constexpr double least_ratio = 2, stiffest_polymer = 20e9;
    if (e.case_relaxes()) return e.has_time;
    return e.has_time && e.has_unloading && e.hold_duration == 0 &&
           (e.fastest_run > least_ratio * e.slowest_run || e.reduced_modulus() < stiffest_polymer);
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double time = e.duration, shortest = 1e-3 * time, longest = 100 * time;
    EffectParameter share{"share", "", "g, part of the modulus that relaxes", 1e-3, 0.999, false, {0.1, 0.5}},
        constant{"time_constant", "s", "tau", shortest, longest, true, {0.05 * time, 0.3 * time, 2 * time}};
    const std::vector<double> of_case = values_in_case(e);
    if (!of_case.empty()) {
      share.starts.push_back(of_case[0]);
      constant.starts.push_back(std::clamp(of_case[1], shortest, longest));
    }
    return {share, constant};
  }
  std::vector<double> values_in_case(const Experiment& e) const override {
    if (!e.case_relaxes()) return {};
    const RelaxingPart shear = particle_relaxes(e) ? e.particle_relaxation : e.substrate_relaxation;
    const RelaxingPart of_pair = as_one_part(modulus_of(e, shear));
    return {of_pair.share, of_pair.time};
  }
  EntersBy enters_by(const Experiment& e) const override {
    return is_of_elastic_case(e) ? EntersBy::on_force : EntersBy::reduced_law_only;
  }
  std::string why_not_by_finite_elements(const Experiment& e) const override {
    return is_of_elastic_case(e)
               ? ""
               : "its law holds for elastic bodies without adhesion, and the case yields or attracts";
  }
  /// With the time of loading, half of what was recorded: it is pressed and drawn back without a hold.
  std::vector<CorrectedEntry> corrected_entries(const Experiment& e,
                                                const std::vector<DiagnosedParameter>& found) const override {
    if (!is_of_elastic_case(e)) return {};
    const std::string section = particle_relaxes(e) ? "Particle/" : "Substrate/";
    const RelaxingPart at = shear_of(e, {found[0].value, found[1].value});
    CorrectedEntry share{section + "Relaxing share", "", at.share, at.share, at.share, ""},
        time{section + "Relaxation time", "s", at.time, at.time, at.time, ""};
    for (const double of_pair : {found[0].low, found[0].high})
      for (const double constant : {found[1].low, found[1].high}) {
        const RelaxingPart corner = shear_of(e, {of_pair, constant});
        share.low = std::min(share.low, corner.share), share.high = std::max(share.high, corner.share);
        time.low = std::min(time.low, corner.time), time.high = std::max(time.high, corner.time);
      }
    const double loading = 0.5 * e.duration;
    return {share, time, {"Experiment/Load time", "s", loading, loading, loading, ""}};
  }
  void assemble(Mechanics& m, const double* p) const override {
    const RelaxingPart of_pair{p[0], p[1]};
    const Experiment& e = m.experiment;
    m.normal.contact = std::make_shared<RelaxingContact>(
        m.geometry, e.by_finite_elements ? modulus_of(e, shear_of(e, of_pair)) : RelaxingModulus{of_pair});
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(viscoelasticity, Viscoelasticity)

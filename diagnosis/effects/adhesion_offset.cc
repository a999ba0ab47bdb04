// Adhesion that presses the surfaces together without a load from outside: |f_l| <= mu (f_n + h).
#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class AdhesionOffset : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "adhesion_offset",
        "Offset of sliding friction by adhesion",
        "|f_l| <= mu (f_n + h)",
        "Derjaguin 1934; Fuchs, Weinhart et al. 2014, eq. (yield1)",
        "Friction does not vanish with the load: attraction acts like an additional normal force, in "
        "sliding on the radius of the contact too (Derjaguin, Muller & Toporov 1975).",
        EffectKind::contact,
        {Motion::sliding, Motion::torsion}};
    return d;
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const std::vector<double> of_case = values_in_case(e);
    const bool attracts = !of_case.empty();  // none at all is an answer then
    return {{"adhesion_force",
             "N",
             "h",
             0,
             30 * e.largest_force,
             false,
             {0.03 * e.typical_force, 0.3 * e.typical_force},
             attracts,
             attracts ? of_case.front() : std::numeric_limits<double>::quiet_NaN()}};
  }
  EntersBy enters_by(const Experiment& e) const override {
    return e.is_lateral() ? EntersBy::finite_elements : EntersBy::reduced_law_only;
  }
  /// One force beyond the contact. Where the case gives a range of attraction, its work of adhesion.
  std::vector<CaseChange> case_changes(const Experiment& e, const double* p) const override {
    if (!(e.case_adhesion_range > 0)) return {{"Interface/Attraction force", p[0], "N"}};
    return {{"Interface/Work of adhesion", p[0] / force_per_work(e, e.typical_force), "J/m^2"}};
  }
  std::vector<double> values_in_case(const Experiment& e) const override {
    if (e.mode != Motion::sliding && e.mode != Motion::torsion) return {};
    const double force = e.case_adhesion_range > 0
                             ? e.case_work_of_adhesion * force_per_work(e, e.typical_force)
                             : e.case_attraction_force;
    return force > 0 ? std::vector<double>{force} : std::vector<double>{};
  }
  /// h is that of a typical load where the case gives a range.
  void assemble(Mechanics& m, const double* p) const override {
    const Experiment& e = m.experiment;
    if (!(e.by_finite_elements && e.case_adhesion_range > 0)) {
      m.lateral.offset += p[0];
      return;
    }
    const double work = p[0] / force_per_work(e, e.typical_force);
    m.lateral.offsets.push_back([e, work](const Sample& sample) {
      return work * force_per_work(e, std::max(0.0, sample.normal_force));
    });
  }

 private:
  /// What attraction over the case's range presses per work of adhesion [N m^2/J]: around the contact 2 pi R
  /// (DMT), and across it its area over the range (Derjaguin 1934).
  static double force_per_work(const Experiment& e, double load) {
    const double a = e.hertz().contact_radius(load);
    return 2 * M_PI * e.radius + M_PI * a * a / e.case_adhesion_range;
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(adhesion_offset, AdhesionOffset)

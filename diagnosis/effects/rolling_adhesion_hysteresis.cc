// Rolling closes the contact in front and opens it behind, both over its width 2 a. What opening takes more
// than closing gave is lost:
//   f_l = 2 a (w_opening - w_closing),   a: Hertz' radius under the load
// (Kendall 1975). It grows as f_n^(1/3), so that neither a share of the load nor a constant force stands for
// it. The width is what closing reaches: Hertz' where it gains nothing, and up to that of Johnson, Kendall &
// Roberts (1971) with the work on approach, which this law leaves out and finite elements do not.
#include <algorithm>
#include <cmath>

#include "core/attraction_zone.h"
#include "diagnosis/catalogue/effect.h"
#include "diagnosis/mechanics/attraction_in_case.h"

namespace asperity {
namespace {

class RollingAdhesionHysteresis : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "rolling_adhesion_hysteresis",
        "Rolling loses work of adhesion",
        "f_l = mu_ro f_n + 2 a (w_opening - w_closing)",
        "Kendall 1975 (rolling); Johnson, Kendall & Roberts 1971",
        "The rear edge of the contact takes more work to open than the front edge gave when it closed. An "
        "input of the case that a recording of rolling tells.",
        EffectKind::contact,
        {Motion::rolling},
        {},
        {"attraction"}};
    return d;
  }
  /// Reduced laws keep the offset of load by which engines write it.
  bool can_show(const Experiment& e) const override { return e.by_finite_elements; }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double recorded = e.largest_response / (2 * e.hertz().contact_radius(e.largest_force));
    const std::vector<double> of_case = values_in_case(e);
    const double own = of_case.empty() ? recorded : of_case.front();
    EffectParameter lost{"work_lost",
                         "J/m^2",
                         "w on separation less w on approach",
                         1e-3 * std::min(own, recorded),
                         1e2 * std::max(own, recorded),
                         true,
                         {recorded, 0.3 * recorded}};
    if (!of_case.empty()) lost.no_effect = own;
    return {lost};
  }
  EntersBy enters_by(const Experiment&) const override { return EntersBy::finite_elements; }
  std::vector<double> values_in_case(const Experiment& e) const override {
    if (e.mode != Motion::rolling || !(e.case_work_of_separation > e.case_work_of_adhesion)) return {};
    return {e.case_work_of_separation - e.case_work_of_adhesion};
  }
  /// The work on approach stays. Where the case has no range, the shortest that its mesh resolves.
  std::vector<CaseChange> case_changes(const Experiment& e, const double* p) const override {
    const double opening = e.case_work_of_adhesion + p[0];
    const bool has_range = e.case_adhesion_range > 0;
    auto changes = dugdale_in_case(e, opening, has_range ? e.case_adhesion_range : resolved_range(e, opening),
                                   cells_of_rear_edge);
    changes.front().value = e.case_work_of_adhesion;
    if (!has_range && !(e.case_spacing > 0)) changes.push_back({spacing_entry, spacing_of(e), "m"});
    changes.push_back({"Interface/Work of adhesion on separation", opening, "J/m^2"});
    return changes;
  }
  void assemble(Mechanics& m, const double* p) const override {
    const double lost = p[0], mu = m.lateral.coefficient;
    if (!(mu > 0)) return;
    const Hertz geometry = m.geometry;
    m.lateral.offsets.push_back([geometry, lost, mu](const Sample& sample) {
      return 2 * geometry.contact_radius(std::max(0.0, sample.normal_force)) * lost / mu;
    });
  }

 private:
  /// Over the zone of attraction: with three the energy lost is off by a tenth to a quarter, with four and a
  /// quarter by 3 %.
  static constexpr double cells_of_rear_edge = 5;

  /// Of the mesh; where the case derives its own from the load, one for the largest [m].
  static double spacing_of(const Experiment& e) {
    constexpr double cells_over_radius = 18;
    return e.case_spacing > 0 ? e.case_spacing
                              : e.hertz().contact_radius(e.largest_force) / cells_over_radius;
  }

  /// Its zone is some cells long; no shorter than Johnson, Kendall & Roberts' limit asks for.
  static double resolved_range(const Experiment& e, double work) {
    constexpr double lambda_of_jkr = 10, beyond_rounding = 1.05;
    const double shortest = range_of_attraction(e, work, lambda_of_jkr),
                 zone = attraction_zone(e.reduced_modulus(), work, work / shortest);
    // The zone grows as the square of the range.
    return shortest * std::sqrt(std::max(1.0, beyond_rounding * cells_of_rear_edge * spacing_of(e) / zone));
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(rolling_adhesion_hysteresis, RollingAdhesionHysteresis)

// Attraction between the surfaces, from DMT (alpha = 0) to JKR (alpha = 1): Maugis' solution (1992,
// maugis_dugdale.h) with the lambda of that alpha (attraction_in_case.h). The contact forms at d = 0 and
// breaks where d has its minimum (fixed grips), or a spring in series lets it.
// On a law other than Hertz' the attraction is a constant force while the surfaces touch (DMT).
#include <algorithm>
#include <cmath>
#include <memory>

#include "diagnosis/catalogue/effect.h"
#include "diagnosis/mechanics/attraction_in_case.h"
#include "diagnosis/mechanics/contact_on_law.h"
#include "diagnosis/mechanics/maugis_contact.h"

namespace asperity {
namespace {

/// A constant attraction on any law, while that law presses.
class AttractedContact : public ContactOnLaw {
 public:
  AttractedContact(const NormalContact& law, double pull_off) : ContactOnLaw(law), pull_off_(pull_off) {}
  std::unique_ptr<NormalContact> clone() const override { return std::make_unique<AttractedContact>(*this); }
  double force(double d) const override {
    const double pressed = law().force(d);
    return pressed > 0 ? pressed - pull_off_ : 0;
  }

 private:
  double pull_off_;
};

MaugisContact contact_of(const Hertz& law, const double* p) {
  const double lambda = lambda_of_transition(p[1]);
  return {law, p[0] / maugis_branch(lambda)->pull_off(), lambda};
}

class Adhesion : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{"adhesion",
                                     "Adhesion",
                                     "f = a^3 - lambda a^2 (u + m^2 t), d = a^2 - 4/3 lambda a u in Maugis' "
                                     "units, lambda = -0.924 ln(1 - alpha); DMT: alpha = 0, JKR: alpha = 1",
                                     "Derjaguin, Muller & Toporov 1975; Johnson, Kendall & Roberts 1971; "
                                     "Maugis 1992; after Carpick, Ogletree & Salmeron 1999, eq. (9)",
                                     "The surfaces attract each other: the contact is larger than its load "
                                     "alone makes it, and it takes a pull to open it.",
                                     EffectKind::contact,
                                     {Motion::normal},
                                     {},
                                     {"attraction"},
                                     2,
                                     false};
    return d;
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double f = e.largest_force;
    EffectParameter transition{
        "transition", "", "alpha, from DMT (0) to JKR (1)", 0, 1, false, {0, 0.05, 0.2, 0.4, 0.6, 0.8, 0.95}};
    transition.bounds_are_meant = true;
    if (e.by_finite_elements) {
      constexpr double least = 0.05;  // in DMT's limit the range of attraction is infinite
      transition.low = least;
      transition.starts = {least, 0.3, 0.6, 0.95};
    }
    EffectParameter force{"pull_off_force",
                          "N",
                          "h",
                          1e-5 * f,
                          10 * f,
                          true,
                          {0.001 * f, 0.004 * f, 0.015 * f, 0.06 * f, 0.3 * f}};
    if (const std::vector<double> of_case = values_in_case(e); !of_case.empty()) {
      force.starts.push_back(std::clamp(of_case[0], force.low, force.high));
      transition.starts.push_back(std::clamp(of_case[1], transition.low, transition.high));
      force.no_effect = of_case[0];
    }
    return {force, transition};
  }
  std::vector<double> values_in_case(const Experiment& e) const override {
    if (!e.case_attracts() || e.case_work_of_separation > e.case_work_of_adhesion) return {};
    const double work = e.case_work_of_adhesion,
                 transition = transition_of_lambda(lambda_of_range(e, work, e.case_adhesion_range));
    const auto branch = maugis_branch(lambda_of_transition(transition));
    return {branch->pull_off() * M_PI * work * e.radius, transition};
  }
  EntersBy enters_by(const Experiment&) const override { return EntersBy::finite_elements; }
  std::string why_not_by_finite_elements(const Experiment&) const override { return ""; }
  std::vector<double> values_as_solved(const Experiment& e, const double* p) const override {
    const double lambda = lambda_of_transition(p[1]), solved = lambda_as_solved(e, p);
    return {p[0], solved < lambda ? transition_of_lambda(solved) : p[1]};
  }
  /// Dugdale's attraction (Maugis 1992): w = h/(c pi R), c of that lambda.
  std::vector<CaseChange> case_changes(const Experiment& e, const double* p) const override {
    const auto branch = maugis_branch(lambda_as_solved(e, p));
    const double work = p[0] / (branch->pull_off() * M_PI * e.radius);
    auto changes = dugdale_in_case(e, work, range_of_attraction(e, work, branch->lambda()));
    if (e.case_attracts()) changes.push_back({"Interface/Work of adhesion on separation", work, "J/m^2"});
    return changes;
  }
  double opening_distance(const Experiment& e, const double* p) const override {
    const MaugisContact contact = contact_of(e.hertz(), p);
    return std::abs(contact.release()) + case_changes(e, p)[1].value;
  }
  void assemble(Mechanics& m, const double* p) const override {
    if (const Hertz* law = m.normal.contact->hertz())
      m.normal.contact = std::make_shared<MaugisContact>(contact_of(*law, p));
    else
      m.normal.contact = std::make_shared<AttractedContact>(*m.normal.contact, p[0]);
  }

 private:
  static double lambda_as_solved(const Experiment& e, const double* p) {
    const double lambda = lambda_of_transition(p[1]);
    return e.by_finite_elements ? resolvable_lambda(e, p[0], lambda) : lambda;
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(adhesion, Adhesion)

// More work to open the contact than it gave on closing, over one range of attraction (Dugdale's stress with
// a pinned edge, pinned_dugdale.h; JKR's limit where the range is short). The contact forms at d = 0 and
// breaks where d has its minimum on the branch of the larger work.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "dem_compare/laws/pinned_dugdale.h"
#include "diagnosis/catalogue/effect.h"
#include "diagnosis/mechanics/attraction_in_case.h"

namespace asperity {
namespace {

class PinnedContact : public NormalContact {
 public:
  PinnedContact(const Hertz& bodies, double closing, double opening, double lambda)
      : law_(std::make_shared<PinnedDugdale>(lambda, closing / opening)),
        force_(M_PI * opening * bodies.radius) {
    const double stiffness = 4.0 / 3 * bodies.reduced_modulus;
    approach_ = std::cbrt(std::pow(force_ / stiffness, 2) / bodies.radius);
  }
  std::unique_ptr<NormalContact> clone() const override { return std::make_unique<PinnedContact>(*this); }
  double release() const override { return approach_ * law_->release(); }
  double parting() const override { return approach_ * law_->parting(); }
  double force(double d) const override {
    const State next = after(state_.apart() ? State{} : state_, d / approach_);
    tried_depth_ = d, tried_ = next;
    return next.apart() ? 0 : force_ * next.force;
  }
  double held_force(double d) const override {
    return force_ * law_->at(std::max(d, parting()) / approach_, state_).force;
  }
  double displacement(double force) const override {
    return approach_ * law_->under(force / force_, state_.apart() ? State{} : state_).approach;
  }
  void accept(double d) override {
    const bool was_tried = d == tried_depth_ && !state_.apart() && !tried_.apart();
    state_ = was_tried ? tried_ : after(state_, d / approach_);
    tried_depth_ = std::numeric_limits<double>::quiet_NaN();
  }

 private:
  using State = DugdaleContact;
  /// A contact whose edge stays where it is for long, or breaks, is looked up in a table of all its states.
  State after(const State& before, double approach) const {
    const double b = before.held_edge;
    const HeldCurve* curve = curve_ && curve_->held_edge() == b ? curve_.get() : nullptr;
    const State next = law_->at(approach, before, tried_, curve);
    if (curve || !(b > 0) || !(approach < before.approach)) return next;
    const bool is_held = next.held_edge == b && !next.apart(), breaks = !(next.held_edge > 0);
    held_ = b == counted_edge_ ? held_ + (is_held ? 1 : 0) : 1;
    counted_edge_ = b;
    constexpr int many = 20;  // a table costs as much as some thirty states
    if (held_ == many || breaks) curve_ = std::make_shared<const HeldCurve>(law_->curve(b));
    return next;
  }
  std::shared_ptr<const PinnedDugdale> law_;
  double force_, approach_;  ///< Maugis' units of the work on opening [N], [m]
  State state_{};
  /// Tried last: what is accepted is mostly that.
  mutable double tried_depth_ = std::numeric_limits<double>::quiet_NaN();
  mutable State tried_{};
  mutable std::shared_ptr<const HeldCurve> curve_;
  mutable int held_ = 0;  ///< states since the edge stays at that of them
  mutable double counted_edge_ = 0;
};

class AdhesionHysteresis : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "adhesion_hysteresis",
        "Hysteresis of adhesion",
        "f = a^3 - lambda [k (a S(c) + c^2 t(c)) + (1 - k) (a S(b) + b^2 t(b))], d = a^2 - 4/3 lambda "
        "[k S(c) + (1 - k) S(b)], S(x) = (x^2 - a^2)^(1/2), t(x) = arccos(a/x), k = w_closing/w_opening, "
        "a(d; w_closing) <= b <= c(d; w_opening), gap h0 at c; in Maugis' units, lambda as of adhesion",
        "Maugis & Barquins 1978; Chen, Helm & Israelachvili 1991; after Maugis 1992",
        "Opening the contact takes more work than closing it gave: on unloading the edge of the contact "
        "stays pinned at first, and the curve returns on another branch than it came. Radii: a of the "
        "contact, b of what has been in contact, c of the attraction, which reaches across a gap of h0.",
        EffectKind::contact,
        {Motion::normal},
        {},
        {"attraction", "normal_law"},
        2,
        false};
    return d;
  }
  bool can_show(const Experiment& e) const override { return e.has_unloading && e.has_trace; }
  int effects_held() const override { return 2; }  // adhesion, and its work that differs
  /// With works alike it is adhesion without hysteresis.
  bool is_itself(const Experiment&, const double* p) const override {
    constexpr double least_ratio = 1.2;
    return p[1] > least_ratio * p[0];
  }
  /// Of the mean of both works, of their range and others.
  SimplerForm simpler_form(const Experiment& e, const double* p) const override {
    SimplerForm form{"adhesion", {}};
    for (const double transition : {p[2], 1.0, 0.95, 0.85, 0.7, 0.5}) {
      const double unit = M_PI * 0.5 * (p[0] + p[1]) * e.radius;
      form.starts.push_back({unit * maugis_branch(lambda_of_transition(transition))->pull_off(), transition});
    }
    return form;
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double work = e.largest_force / (1.5 * M_PI * e.radius);
    EffectParameter closing{"work_closing",
                            "J/m^2",
                            "w gained on closing",
                            1e-7 * work,
                            10 * work,
                            true,
                            {1e-4 * work, 0.01 * work, 0.1 * work},
                            true},
        opening{"work_opening",
                "J/m^2",
                "w spent on opening",
                1e-6 * work,
                30 * work,
                true,
                {0.01 * work, 0.1 * work, 0.5 * work}};
    if (e.case_attracts()) {
      closing.starts.push_back(std::clamp(e.case_work_of_adhesion, closing.low, closing.high));
      opening.starts.push_back(std::clamp(e.case_work_of_separation, opening.low, opening.high));
    }
    return {closing, opening, transition()};
  }
  std::vector<double> values_in_case(const Experiment& e) const override {
    const double closing = e.case_work_of_adhesion, opening = e.case_work_of_separation;
    if (!e.case_attracts() || !(opening > closing)) return {};
    return {closing, opening, transition_of_lambda(lambda_of_range(e, opening, e.case_adhesion_range))};
  }
  EntersBy enters_by(const Experiment&) const override { return EntersBy::finite_elements; }
  std::string why_not_by_finite_elements(const Experiment&) const override { return ""; }
  std::vector<double> values_as_solved(const Experiment& e, const double* p) const override {
    const double lambda = lambda_of_transition(p[2]), solved = lambda_as_solved(e, p);
    return {p[0], p[1], solved < lambda ? transition_of_lambda(solved) : p[2]};
  }
  /// Both works over one range, or over the shortest that a mesh resolves on separation.
  std::vector<CaseChange> case_changes(const Experiment& e, const double* p) const override {
    const double closing = p[0], opening = std::max(p[0], p[1]);
    auto changes = dugdale_in_case(e, opening, range_of_attraction(e, opening, lambda_as_solved(e, p)));
    changes.push_back({"Interface/Work of adhesion on separation", opening, "J/m^2"});
    changes.front().value = closing;
    return changes;
  }
  bool returns_on_another_curve() const override { return true; }
  double opening_distance(const Experiment& e, const double* p) const override {
    return std::abs(contact_of(e.hertz(), p).release()) + case_changes(e, p)[1].value;
  }
  void assemble(Mechanics& m, const double* p) const override {
    m.normal.contact = std::make_shared<PinnedContact>(contact_of(m.geometry, p));
  }

 private:
  static double lambda_as_solved(const Experiment& e, const double* p) {
    const double lambda = lambda_of_transition(p[2]), opening = std::max(p[0], p[1]);
    return e.by_finite_elements ? resolvable_lambda(e, 1.5 * M_PI * opening * e.radius, lambda) : lambda;
  }
  static PinnedContact contact_of(const Hertz& bodies, const double* p) {
    return {bodies, p[0], std::max(p[0], p[1]), lambda_of_transition(p[2])};
  }
  /// Not down to DMT's limit: attraction without end would never let an edge go.
  static EffectParameter transition() {
    EffectParameter p{"transition", "",        "alpha of the opening, from DMT (0) to JKR (1)", 0.05, 1,
                      false,        {0.3, 0.9}};
    p.bounds_are_meant = true;
    return p;
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(adhesion_hysteresis, AdhesionHysteresis)

// More work to open the contact than it gave on closing. For a contact of radius a at displacement d (Maugis
// 1992; JKR's general state)  f = 2 E* (a d - a^3/(3 R)),  the edge advances where the closing work w_c
// allows and retreats where the work of adhesion on separation w_o does; between it stays pinned:  a <- a cut
// to [a_JKR(d; w_c), a_JKR(d; w_o)].
#include <algorithm>
#include <cmath>
#include <limits>

#include "dem_compare/laws/jkr.h"
#include "diagnosis/catalogue/effect.h"
#include "diagnosis/mechanics/attraction_in_case.h"

namespace asperity {
namespace {

class PinnedContact : public NormalContact {
 public:
  PinnedContact(const Hertz& law, double closing, double opening)
      : closing_{law.reduced_modulus, law.radius, closing},
        opening_{law.reduced_modulus, law.radius, opening},
        closes_from_(closing_.smallest_approach()),
        opens_at_(opening_.smallest_approach()) {}
  std::unique_ptr<NormalContact> clone() const override { return std::make_unique<PinnedContact>(*this); }
  double release() const override { return opens_at_; }
  double force(double d) const override {
    const double a = tried_radius_ = radius_at(d);
    tried_depth_ = d;
    return a > 0 ? 2 * opening_.reduced_modulus * (a * d - a * a * a / (3 * opening_.radius)) : 0;
  }
  double displacement(double force) const override {
    if (force <= (radius_ > 0 ? -opening_.pull_off_force() : 0.0))
      return std::numeric_limits<double>::quiet_NaN();
    const double least = force > -closing_.pull_off_force() ? closing_.radius_at_force(force) : 0,
                 a = radius_ <= least ? least : std::min(radius_, opening_.radius_at_force(force));
    return force / (2 * opening_.reduced_modulus * a) + a * a / (3 * opening_.radius);
  }
  void accept(double d) override {
    if (d != tried_depth_) tried_radius_ = radius_at(d);
    radius_ = tried_radius_;
    tried_depth_ = d;  // and the radius stays as it is
  }

 private:
  double radius_at(double d) const {
    if (d < (radius_ > 0 ? opens_at_ : 0)) return 0;
    const double least = d >= closes_from_ ? closing_.radius_at_approach(d) : 0;
    if (radius_ <= least) return least;
    return std::min(radius_, opening_.radius_at_approach(d));
  }
  Jkr closing_, opening_;
  double closes_from_, opens_at_;  ///< displacements that no contact of either work is below [m]
  double radius_ = 0;
  /// Tried last: what is accepted is mostly that.
  mutable double tried_depth_ = std::numeric_limits<double>::quiet_NaN(), tried_radius_ = 0;
};

class AdhesionHysteresis : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "adhesion_hysteresis",
        "Hysteresis of adhesion",
        "f = 2 E* (a d - a^3/(3 R)), a_JKR(d; w_closing) <= a <= a_JKR(d; w_opening)",
        "Johnson, Kendall & Roberts 1971; Maugis & Barquins 1978; Chen, Helm & Israelachvili 1991",
        "Opening the contact takes more work than closing it gave: on unloading the edge of the contact "
        "stays pinned at first, and the "
        "curve returns on another branch than it came.",
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
  /// Johnson, Kendall & Roberts' pull-off force, of the mean of both works, and ranges of attraction from
  /// theirs (none) on.
  SimplerForm simpler_form(const Experiment& e, const double* p) const override {
    const double pull_off = 1.5 * M_PI * 0.5 * (p[0] + p[1]) * e.radius;
    SimplerForm form{"adhesion", {}};
    for (const double transition : {1.0, 0.95, 0.85, 0.7, 0.5}) form.starts.push_back({pull_off, transition});
    return form;
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double work = e.largest_force / (1.5 * M_PI * e.radius);
    return {{"work_closing",
             "J/m^2",
             "w gained on closing",
             1e-7 * work,
             10 * work,
             true,
             {1e-4 * work, 0.01 * work, 0.1 * work},
             true},
            {"work_opening",
             "J/m^2",
             "w spent on opening",
             1e-6 * work,
             30 * work,
             true,
             {0.01 * work, 0.1 * work, 0.5 * work}}};
  }
  EntersBy enters_by(const Experiment&) const override { return EntersBy::finite_elements; }
  std::string why_not_by_finite_elements(const Experiment&) const override { return ""; }
  /// Both works over one range: the shortest that a mesh resolves on separation.
  std::vector<CaseChange> case_changes(const Experiment& e, const double* p) const override {
    const double closing = std::min(p[0], p[1]), opening = std::max(p[0], p[1]);
    constexpr double lambda_of_jkr = 10;
    double lambda = lambda_of_jkr;
    if (e.by_finite_elements) lambda = resolvable_lambda(e, 1.5 * M_PI * opening * e.radius, lambda_of_jkr);
    auto changes = dugdale_in_case(e, opening, range_of_attraction(e, opening, lambda));
    changes.push_back({"Interface/Work of adhesion on separation", opening, "J/m^2"});
    changes.front().value = closing;
    return changes;
  }
  bool returns_on_another_curve() const override { return true; }
  double opening_distance(const Experiment& e, const double* p) const override {
    const Jkr jkr{e.reduced_modulus(), e.radius, std::max(p[0], p[1])};
    return std::abs(jkr.smallest_approach()) + case_changes(e, p)[1].value;
  }
  void assemble(Mechanics& m, const double* p) const override {
    m.normal.contact =
        std::make_shared<PinnedContact>(m.geometry, std::min(p[0], p[1]), std::max(p[0], p[1]));
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(adhesion_hysteresis, AdhesionHysteresis)

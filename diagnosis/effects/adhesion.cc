// Attraction between the surfaces, from DMT (alpha = 0) to JKR (alpha = 1): Maugis' solution (1992,
// maugis_dugdale.h) with
//   lambda = -0.924 ln(1 - alpha)  (after Carpick, Ogletree & Salmeron 1999, eq. (9), who have 1.02 alpha),
// up to 10. The contact forms at d = 0 and breaks where d has its minimum (fixed grips), or a
// spring in series lets it.
// On a law other than Hertz' the attraction is a constant force while the surfaces touch (DMT).
#include <algorithm>
#include <cmath>
#include <memory>

#include "core/attraction_zone.h"
#include "dem_compare/laws/maugis_branch.h"
#include "diagnosis/catalogue/effect.h"
#include "diagnosis/mechanics/contact_on_law.h"

namespace asperity {
namespace {

/// lambda = 10 is JKR: alpha is scaled so that it reaches that at 1 and every alpha has its own lambda.
constexpr double lambda_of_jkr = 10, lambda_of_fit = 0.924;
double lambda_of(double alpha) {
  return -lambda_of_fit * std::log1p(-alpha * -std::expm1(-lambda_of_jkr / lambda_of_fit));
}
double alpha_of(double lambda) {
  return std::expm1(-lambda / lambda_of_fit) / std::expm1(-lambda_of_jkr / lambda_of_fit);
}

/// The branch of the last parameter asked for in this thread: a fit changes it seldom.
std::shared_ptr<const MaugisBranch> branch_of(double alpha) {
  thread_local std::shared_ptr<const MaugisBranch> last;
  const double lambda = lambda_of(alpha);
  if (!last || last->lambda() != lambda) last = std::make_shared<const MaugisBranch>(lambda);
  return last;
}

class MaugisContact : public NormalContact {
 public:
  MaugisContact(const Hertz& law, double pull_off, double alpha) : branch_(branch_of(alpha)) {
    force_ = pull_off / branch_->pull_off();
    const double stiffness = 4.0 / 3 * law.reduced_modulus;
    approach_ = std::cbrt(std::pow(force_ / stiffness, 2) / law.radius);
  }
  std::unique_ptr<NormalContact> clone() const override { return std::make_unique<MaugisContact>(*this); }
  double release() const override { return approach_ * branch_->release(); }
  double force(double d) const override {
    return d < (touching_ ? release() : 0) ? 0 : force_ * branch_->force(d / approach_);
  }
  double displacement(double force) const override {
    if (force <= (touching_ ? -force_ * branch_->pull_off() : 0.0))
      return std::numeric_limits<double>::quiet_NaN();
    return approach_ * branch_->approach(force / force_);
  }
  double parting() const override { return approach_ * branch_->parting(); }
  double held_force(double d) const override {
    const double place = std::max(d, parting()) / approach_;
    return force_ * (place < branch_->release() ? branch_->force_apart(place) : branch_->force(place));
  }
  void accept(double d) override { touching_ = d >= (touching_ ? release() : 0); }

 private:
  std::shared_ptr<const MaugisBranch> branch_;
  double force_, approach_;  ///< Maugis' units [N], [m]
  bool touching_ = false;
};

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

constexpr const char* mesh_entry = "Mesh/Interface spacing";

/// alpha, or where its zone takes more than thirty cells over the radius of the pressed contact, that of the
/// shortest attraction that does not: from there to JKR's the pull-off force changes by a twelfth, and the
/// recording says little of the range. The zone is 3 A0 / (4 lambda^2), A0: Maugis' unit of radius.
double resolvable_alpha(const Experiment& e, double pull_off, double alpha) {
  constexpr double cells_per_radius = 30, of_pi_w_R = 1.6;
  const double f = e.largest_force, h = pull_off;
  const double pressed = f + 2 * h + std::sqrt(4 * h * f + 4 * h * h);  // Johnson, Kendall & Roberts 1971
  const double radius = std::cbrt(0.75 * pressed * e.radius / e.reduced_modulus());
  const double unit = std::cbrt(0.75 * h * e.radius / (of_pi_w_R * e.reduced_modulus()));
  double finest = radius / cells_per_radius;
  if (e.case_spacing > 0) finest = std::min(finest, e.case_spacing);
  return std::min(alpha, alpha_of(std::sqrt(0.75 * unit / (cells_over_attraction_zone * finest))));
}

/// Spacing of the case's mesh, or of one that is finer by a power of the root of two and resolves the zone
/// [m].
double resolving_spacing(const Experiment& e, double work, double range) {
  const double enough = attraction_zone(e.reduced_modulus(), work, work / range) / cells_over_attraction_zone;
  double spacing = e.case_spacing;
  while (spacing > enough) spacing /= M_SQRT2;
  return spacing;
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
    return {{"pull_off_force",
             "N",
             "h",
             1e-5 * f,
             10 * f,
             true,
             {0.001 * f, 0.004 * f, 0.015 * f, 0.06 * f, 0.3 * f}},
            transition};
  }
  EntersBy enters_by(const Experiment&) const override { return EntersBy::finite_elements; }
  std::string why_not_by_finite_elements(const Experiment&) const override { return ""; }
  /// Dugdale's attraction over h0 (Maugis 1992): w = h/(c pi R), sigma0 = w/h0, lambda = 2 sigma0 (R/(pi w
  /// K^2))^(1/3); c of that lambda.
  std::vector<CaseChange> case_changes(const Experiment& e, const double* p) const override {
    const auto branch = branch_of(e.by_finite_elements ? resolvable_alpha(e, p[0], p[1]) : p[1]);
    const double stiffness = 4.0 / 3 * e.reduced_modulus();
    const double work = p[0] / (branch->pull_off() * M_PI * e.radius);
    const double range =
        2 * work / branch->lambda() * std::cbrt(e.radius / (M_PI * work * stiffness * stiffness));
    std::vector<CaseChange> changes{{"Interface/Work of adhesion", work, "J/m^2"},
                                    {"Interface/Adhesion range", range, "m"}};
    const double spacing = resolving_spacing(e, work, range);
    if (e.by_finite_elements && spacing < e.case_spacing) changes.push_back({mesh_entry, spacing, "m"});
    return changes;
  }
  /// Intervals hold attraction that no mesh resolves, too; the mesh is a means and has none.
  std::vector<CorrectedEntry> corrected_entries(const Experiment& e,
                                                const std::vector<DiagnosedParameter>& found) const override {
    Experiment without_mesh = e;
    without_mesh.by_finite_elements = false;
    auto entries = Effect::corrected_entries(without_mesh, found);
    const double at[] = {found[0].value, found[1].value};
    for (const CaseChange& change : case_changes(e, at)) {
      const auto same = std::find_if(entries.begin(), entries.end(), [&](const CorrectedEntry& entry) {
        return entry.entry == change.entry;
      });
      if (same == entries.end())
        entries.push_back({change.entry, change.unit, change.value, change.value, change.value, ""});
      else
        same->value = change.value;
    }
    return entries;
  }
  double opening_distance(const Experiment& e, const double* p) const override {
    const MaugisContact contact(e.hertz(), p[0], p[1]);
    return std::abs(contact.release()) + case_changes(e, p)[1].value;
  }
  void assemble(Mechanics& m, const double* p) const override {
    if (const Hertz* law = m.normal.contact->hertz())
      m.normal.contact = std::make_shared<MaugisContact>(*law, p[0], p[1]);
    else
      m.normal.contact = std::make_shared<AttractedContact>(*m.normal.contact, p[0]);
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(adhesion, Adhesion)

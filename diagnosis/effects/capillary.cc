// A liquid bridge between the bodies: it forms when they touch and pulls with the suction of its curved
// surface until it ruptures. At constant suction (in equilibrium with the vapour: Kelvin), between sphere and
// plane
//   f = f_law(d) - h (1 - g/g_r),  g = max(0, -d) <= g_r = 2 r_K cos(theta),  h = 4 pi R gamma cos(theta).
#include <algorithm>
#include <cmath>

#include "diagnosis/catalogue/effect.h"
#include "diagnosis/mechanics/attraction_in_case.h"
#include "diagnosis/mechanics/contact_on_law.h"

namespace asperity {
namespace {

class BridgedContact : public ContactOnLaw {
 public:
  BridgedContact(const NormalContact& law, double pull, double rupture)
      : ContactOnLaw(law), pull_(pull), rupture_(rupture) {}
  std::unique_ptr<NormalContact> clone() const override { return std::make_unique<BridgedContact>(*this); }
  double release() const override { return -rupture_; }
  double force(double d) const override {
    if (!bridged_at(d)) return 0;
    return law().force(d) - pull_ * (1 - std::max(0.0, -d) / rupture_);
  }
  void accept(double d) override {
    is_bridged_ = bridged_at(d);
    ContactOnLaw::accept(d);
  }

 private:
  bool bridged_at(double d) const { return d >= (is_bridged_ ? -rupture_ : 0); }
  double pull_, rupture_;
  bool is_bridged_ = false;
};

class Capillary : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "capillary",
        "Liquid bridge",
        "f = f_law(d) - h (1 - g/g_r), g = max(0, -d) < g_r, from the first touch on",
        "Butt & Kappl 2009 (normal capillary forces); Israelachvili 2011, ch. 17; Kelvin 1871",
        "Water condenses where the surfaces are near: it pulls with a constant force while they touch and "
        "over a distance of twice the Kelvin radius after they part.",
        EffectKind::contact,
        {Motion::normal},
        {},
        {"attraction"},
        2,
        false,
        0.1};
    return d;
  }
  bool can_show(const Experiment& e) const override { return e.has_unloading && e.has_off_contact; }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double force = e.largest_force, range = e.largest_displacement;
    constexpr double least = 0.3e-9;  // a molecule of water
    return {{"pull_off_force", "N", "h", 1e-5 * force, 3 * force, true, {0.03 * force, 0.3 * force}},
            {"rupture_distance",
             "m",
             "g_r, separation at which the bridge breaks",
             std::max(1e-3 * range, least),
             std::max(10 * range, 2 * least),
             true,
             {std::max(0.03 * range, least), std::max(0.1 * range, 1.5 * least),
              std::max(0.3 * range, 2 * least)}}};
  }
  EntersBy enters_by(const Experiment& e) const override {
    return e.case_attracts() ? EntersBy::reduced_law_only : EntersBy::finite_elements;
  }
  std::string why_not_by_finite_elements(const Experiment& e) const override {
    return e.case_attracts() ? "the case attracts already, by a law that a bridge would add to" : "";
  }
  /// A suction that is constant out to the rupture distance: h = 2 pi R w, as of any attraction whose range
  /// is long (Derjaguin 1934; Maugis & Gauthier-Manuel 1994).
  std::vector<CaseChange> case_changes(const Experiment& e, const double* p) const override {
    return dugdale_in_case(e, p[0] / (2 * M_PI * e.radius), p[1]);
  }
  double opening_distance(const Experiment&, const double* p) const override {
    constexpr double end_of_attraction = 1.3;  // of the case's law of attraction, over its range
    return end_of_attraction * p[1];
  }
  void assemble(Mechanics& m, const double* p) const override {
    m.normal.contact = std::make_shared<BridgedContact>(*m.normal.contact, p[0], p[1]);
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(capillary, Capillary)

// A liquid bridge between the bodies: it forms when they touch and pulls with the suction of its curved
// surface until it ruptures. The suction is constant (in equilibrium with the vapour: Kelvin) out to the gap
// g_r = 2 r_K cos(theta) in which that surface stands, as Maugis' stress (1992; Maugis & Gauthier-Manuel
// 1994): with h = 4 pi R gamma cos(theta) the contact is his of s0 = h/(2 pi R g_r) and w = s0 g_r, and
// surfaces a gap g apart are pulled by f = -h (1 - g/g_r).
// On a law other than Hertz' it pulls by h while they touch (Derjaguin, Muller & Toporov 1975).
#include <algorithm>
#include <cmath>

#include "diagnosis/catalogue/effect.h"
#include "diagnosis/mechanics/attraction_in_case.h"
#include "diagnosis/mechanics/contact_on_law.h"
#include "diagnosis/mechanics/maugis_contact.h"

namespace asperity {
namespace {

/// Maugis' of a bridge on Hertz' contact [-].
double lambda_of(const Hertz& law, double pull, double rupture) {
  constexpr double largest = 10;  // as good as infinite
  const double work = pull / (2 * M_PI * law.radius), stiffness = 4.0 / 3 * law.reduced_modulus;
  return std::min(largest,
                  2 * work / rupture * std::cbrt(law.radius / (M_PI * work * stiffness * stiffness)));
}

/// On Hertz' law.
class BridgedHertz : public NormalContact {
 public:
  BridgedHertz(const Hertz& law, double pull, double rupture)
      : held_(law, pull / 2, lambda_of(law, pull, rupture)) {}
  std::unique_ptr<NormalContact> clone() const override { return std::make_unique<BridgedHertz>(*this); }
  double release() const override { return held_.parting(); }
  double force(double d) const override { return is_bridged_at(d) ? held_.held_force(d) : 0; }
  void accept(double d) override { is_bridged_ = is_bridged_at(d); }

 private:
  bool is_bridged_at(double d) const { return d >= (is_bridged_ ? release() : 0); }
  MaugisContact held_;
  bool is_bridged_ = false;
};

/// On any law.
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
        "f = f_M(d; s_0 = h/(2 pi R g_r), w = s_0 g_r), apart f = -h (1 - g/g_r), g < g_r, from the first "
        "touch on",
        "Maugis & Gauthier-Manuel 1994; Butt & Kappl 2009 (normal capillary forces); Kelvin 1871",
        "Water condenses where the surfaces are near: its suction pulls on them around the contact, and over "
        "a distance of twice the Kelvin radius after they part.",
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
  /// A suction so strong that the contact breaks before surfaces apart are pulled is that of any attraction.
  bool is_itself(const Experiment& e, const double* p) const override {
    constexpr double least_part = 0.25;
    const auto branch = maugis_branch(lambda_of(e.hertz(), p[0], p[1]));
    return branch->release() - branch->parting() > least_part * -branch->parting();
  }
  SimplerForm simpler_form(const Experiment& e, const double* p) const override {
    const double lambda = lambda_of(e.hertz(), p[0], p[1]);
    return {"adhesion", {{p[0] / 2 * maugis_branch(lambda)->pull_off(), transition_of_lambda(lambda)}}};
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
    if (const Hertz* law = m.normal.contact->hertz())
      m.normal.contact = std::make_shared<BridgedHertz>(*law, p[0], p[1]);
    else
      m.normal.contact = std::make_shared<BridgedContact>(*m.normal.contact, p[0], p[1]);
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(capillary, Capillary)

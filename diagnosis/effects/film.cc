// A thin elastic film on one of the bodies (oxide, polymer, contamination): the modulus that a contact feels
// goes from the film's to that of the bodies as the contact grows,
//   f = 4/3 E_eq R^(1/2) d^(3/2),  E_eq(d R/t^2): diagnosis/mechanics/filmed_law.h.
// The film lies on the softer body, on which it can change most, and has that body's Poisson ratio.
#include <algorithm>
#include <cmath>

#include "diagnosis/catalogue/effect.h"
#include "diagnosis/mechanics/filmed_law.h"
#include "half_space/film_on_body.h"

namespace asperity {
namespace {

class CoatedContact : public NormalContact {
 public:
  CoatedContact(const Hertz& law, FilmedLaw::Curve curve, double thickness)
      : law_(law), curve_(std::move(curve)), thickness_(thickness) {}
  std::unique_ptr<NormalContact> clone() const override { return std::make_unique<CoatedContact>(*this); }
  double force(double d) const override {
    if (d <= 0) return 0;
    return curve_.modulus(d * law_.radius / (thickness_ * thickness_)) * law_.force(d);
  }

 private:
  Hertz law_;
  FilmedLaw::Curve curve_;
  double thickness_;
};

/// The softer body of the pair, and the other.
struct Coated {
  const char* section;
  ElasticBody body, other;
};
Coated coated_of(const Experiment& e) {
  return modulus_alone(e.particle) < modulus_alone(e.substrate)
             ? Coated{"Particle", e.particle, e.substrate}
             : Coated{"Substrate", e.substrate, e.particle};
}

class Film : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "film",
        "Thin elastic film",
        "f = 4/3 E_eq R^(1/2) d^(3/2), E_eq(d R/t^2) from E_f at 0 to E*",
        "Yu, Sanday & Rath 1990, J. Mech. Phys. Solids 38, 745; Perriot & Barthel 2004",
        "A layer of another stiffness lies on the surface: a small contact feels the layer, a large one the "
        "body below. It is taken to lie on the softer body, with that body's Poisson ratio. Of a thin soft "
        "one the data show the thickness over the modulus far better than either.",
        EffectKind::contact,
        {Motion::normal},
        {},
        {"normal_law", "layer"},  // one curve does not tell a film from the layer of asperities upon it
        1};
    return d;
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double radius = std::sqrt(e.radius * e.largest_displacement);
    // The other body keeps its own modulus.
    constexpr double largest = 100, nearly_rigid = 0.99, stiffer = 3, most_radii = 10, of_sphere = 0.45;
    const double high =
        std::min(largest, nearly_rigid * modulus_alone(coated_of(e).other) / e.reduced_modulus());
    // A case takes films up to half the particle's radius: what is thicker is the body.
    const double thickest =
        e.by_finite_elements ? std::min(most_radii * radius, of_sphere * e.radius) : most_radii * radius;
    return {{"modulus_ratio",
             "",
             "reduced modulus with the film alone over that of the bodies",
             0.01,
             high,
             true,
             {0.1, 0.4, std::min(stiffer, std::sqrt(high))}},
            {"thickness", "m", "t", 1e-3 * radius, thickest, true, {0.05 * radius, 0.5 * radius}}};
  }
  /// Asperities give way as a film does, and where the case has none the data are not asked for them.
  std::string not_recorded(const Experiment& e) const override {
    return e.by_finite_elements && e.case_is_smooth
               ? "a scan of the surfaces, given to the case as Topography: asperities give way as a film does"
               : "";
  }
  /// Of the bodies' own modulus it is none.
  bool is_itself(const Experiment&, const double* p) const override {
    constexpr double least_contrast = 1.1;
    return p[0] < 1 / least_contrast || p[0] > least_contrast;
  }
  EntersBy enters_by(const Experiment&) const override { return EntersBy::finite_elements; }
  std::string why_not_by_finite_elements(const Experiment&) const override { return ""; }
  /// The film on the softer body, with that body's Poisson ratio: 1/E_f = 1/(ratio E*) - 1/E_other.
  std::vector<CaseChange> case_changes(const Experiment& e, const double* p) const override {
    const Coated coated = coated_of(e);
    const double nu = coated.body.poisson_ratio;
    constexpr double as_good_as_rigid = 1e-3;
    const double of_other = modulus_alone(coated.other),
                 of_film = 1 / std::max(1 / (p[0] * e.reduced_modulus()) - 1 / of_other,
                                        as_good_as_rigid / of_other);
    const std::string film = std::string(coated.section) + "/Film ";
    return {{film + "thickness", p[1], "m"},
            {film + "Young modulus", of_film * (1 - nu * nu), "Pa"},
            {film + "Poisson ratio", nu, ""}};
  }
  void assemble(Mechanics& m, const double* p) const override {
    const Coated coated = coated_of(m.experiment);
    m.normal.contact =
        std::make_shared<CoatedContact>(m.geometry, filmed_law(coated.body, coated.other)->curve(p[0]), p[1]);
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(film, Film)

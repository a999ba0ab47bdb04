// A thin elastic film on one of the bodies (oxide, polymer, contamination): the modulus that a contact of
// radius a feels goes from the film's to that of the bodies as the contact grows (Perriot & Barthel
// 2004):
//   f = 4/3 E_eq(a) R^(1/2) d^(3/2),  a = (R d)^(1/2),  E_eq: core/coated_half_space.h.
// The radius is that of a homogeneous body: between 1 and 2^(1/2) too small on a film much thinner than a.
#include <algorithm>
#include <cmath>

#include "core/coated_half_space.h"
#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class CoatedContact : public NormalContact {
 public:
  CoatedContact(const Hertz& law, double modulus_ratio, double thickness)
      : law_(law), coated_{modulus_ratio * law.reduced_modulus, law.reduced_modulus, thickness} {}
  std::unique_ptr<NormalContact> clone() const override { return std::make_unique<CoatedContact>(*this); }
  double force(double d) const override {
    if (d <= 0) return 0;
    const double radius = std::sqrt(law_.radius * d);
    return 4.0 / 3 * coated_.modulus(radius) * radius * d;
  }

 private:
  Hertz law_;
  CoatedHalfSpace coated_;
};

/// The softer body of the pair, on which a film can change most, and the other.
struct Coated {
  const char* section;
  ElasticBody body;
  double of_other;  ///< reduced modulus of the other body alone [Pa]
};
Coated coated_of(const Experiment& e) {
  const auto alone = [](const ElasticBody& b) {
    return b.youngs_modulus / (1 - b.poisson_ratio * b.poisson_ratio);
  };
  const double particle = alone(e.particle), substrate = alone(e.substrate);
  return particle < substrate ? Coated{"Particle", e.particle, substrate}
                              : Coated{"Substrate", e.substrate, particle};
}

class Film : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "film",
        "Thin elastic film",
        "f = 4/3 E_eq R^(1/2) d^(3/2), E_eq = E_f + (E* - E_f)/[1 + (t x_0/a)^1.27], a^2 = R d",
        "Perriot & Barthel 2004, J. Mater. Res. 19, 600; Gao, Chiu & Lee 1992",
        "A layer of another stiffness lies on the surface: a small contact feels the layer, a large one the "
        "body below. By this law, and not by finite elements, its modulus and thickness may be off by a "
        "factor of two, beyond their intervals.",
        EffectKind::contact,
        {Motion::normal},
        {},
        {"normal_law", "layer"},  // one curve does not tell a film from the layer of asperities upon it
        1,
        true,
        0.15};
    return d;
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double radius = std::sqrt(e.radius * e.largest_displacement);
    // In a case the film lies on one body, and the other keeps its own modulus.
    constexpr double largest = 100, nearly_rigid = 0.99, stiffer = 3, most_radii = 10, of_sphere = 0.45;
    const double high =
        e.by_finite_elements ? nearly_rigid * coated_of(e).of_other / e.reduced_modulus() : largest;
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
    const double of_film = 1 / std::max(1 / (p[0] * e.reduced_modulus()) - 1 / coated.of_other,
                                        as_good_as_rigid / coated.of_other);
    const std::string film = std::string(coated.section) + "/Film ";
    return {{film + "thickness", p[1], "m"},
            {film + "Young modulus", of_film * (1 - nu * nu), "Pa"},
            {film + "Poisson ratio", nu, ""}};
  }
  void assemble(Mechanics& m, const double* p) const override {
    m.normal.contact = std::make_shared<CoatedContact>(m.geometry, p[0], p[1]);
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(film, Film)

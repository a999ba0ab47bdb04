// A thin elastic film on one of the bodies (oxide, polymer, contamination): the modulus that a contact of
// radius a feels goes from the film's to that of the bodies as the contact grows (Perriot & Barthel
// 2004):
//   f = 4/3 E_eq(a) R^(1/2) d^(3/2),  a = (R d)^(1/2),  E_eq = E_f + (E* - E_f)/[1 + (t x_0/a)^1.27],
//   log10 x_0 = -0.093 + 0.792 log10(E*/E_f) + 0.05 log10(E*/E_f)^2.
// The radius is that of a homogeneous body: between 1 and 2^(1/2) too small on a film much thinner than a.
#include <cmath>

#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class CoatedContact : public NormalContact {
 public:
  CoatedContact(const Hertz& law, double modulus_ratio, double thickness)
      : law_(law), film_(modulus_ratio * law.reduced_modulus) {
    const double contrast = -std::log10(modulus_ratio);
    reach_ = thickness * std::pow(10.0, -0.093 + 0.792 * contrast + 0.05 * contrast * contrast);
  }
  std::unique_ptr<NormalContact> clone() const override { return std::make_unique<CoatedContact>(*this); }
  double force(double d) const override {
    if (d <= 0) return 0;
    const double radius = std::sqrt(law_.radius * d);
    const double modulus = film_ + (law_.reduced_modulus - film_) / (1 + std::pow(reach_ / radius, exponent));
    return 4.0 / 3 * modulus * radius * d;
  }

 private:
  static constexpr double exponent = 1.27;
  Hertz law_;
  double film_, reach_;  ///< E_f [Pa], t x_0 [m]
};

class Film : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "film",
        "Thin elastic film",
        "f = 4/3 E_eq R^(1/2) d^(3/2), E_eq = E_f + (E* - E_f)/[1 + (t x_0/a)^1.27], a^2 = R d",
        "Perriot & Barthel 2004, J. Mater. Res. 19, 600; Gao, Chiu & Lee 1992",
        "A layer of another stiffness lies on the surface: a small contact feels the layer, a large one the "
        "body below.",
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
    return {{"modulus_ratio",
             "",
             "reduced modulus with the film alone over that of the bodies",
             0.01,
             100,
             true,
             {0.1, 0.4, 3}},
            {"thickness", "m", "t", 1e-3 * radius, 10 * radius, true, {0.05 * radius, 0.5 * radius}}};
  }
  /// Of the bodies' own modulus it is none.
  bool is_itself(const double* p) const override {
    constexpr double least_contrast = 1.1;
    return p[0] < 1 / least_contrast || p[0] > least_contrast;
  }
  void assemble(Mechanics& m, const double* p) const override {
    m.normal.contact = std::make_shared<CoatedContact>(m.geometry, p[0], p[1]);
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(film, Film)

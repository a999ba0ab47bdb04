// Charges or different contact potentials attract over a long range, on the way in as on the way out. Sphere
// and plane at the gap g (Hudlet, Saint Jean, Guthmann & Berger 1998):
//   f = f_law(d) - pi eps_0 U^2 R^2/[z (z + R)],  z = g + z_0,  g = max(0, -d);
// z_0: thickness of what insulates, which bounds the force in contact.
#include <algorithm>
#include <cmath>

#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

constexpr double vacuum_permittivity = 8.8541878128e-12;  // [F/m]

class Electrostatic : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "electrostatic",
        "Electrostatic attraction",
        "f = f_law(d) - pi eps_0 U^2 R^2/[z (z + R)], z = z_0 + max(0, -d)",
        "Hudlet, Saint Jean, Guthmann & Berger 1998; Butt, Cappella & Kappl 2005",
        "Charges or different work functions attract the bodies over a distance that is long compared with "
        "that of adhesion; approach and retraction feel the same.",
        EffectKind::contact,
        {Motion::normal},
        {},
        {"far_attraction"},
        4};
    return d;
  }
  bool can_show(const Experiment& e) const override { return e.has_off_contact; }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double range = e.largest_displacement;
    const auto voltage_of = [&](double force, double distance) {
      return std::sqrt(force * distance * (distance + e.radius) / (M_PI * vacuum_permittivity)) / e.radius;
    };
    const double typical = voltage_of(0.03 * e.largest_force, 0.2 * range);
    return {{"voltage",
             "V",
             "U, difference of the potentials",
             1e-4 * typical,
             1e4 * typical,
             true,
             {0.3 * typical, typical, 3 * typical}},
            {"distance",
             "m",
             "z_0, between the charges of touching bodies",
             1e-3 * range,
             100 * range,
             true,
             {0.1 * range, range}}};
  }
  /// Its stress is far too small to deform the bodies.
  EntersBy enters_by(const Experiment&) const override { return EntersBy::beside; }
  std::string why_not_by_finite_elements(const Experiment&) const override { return ""; }
  void assemble(Mechanics& m, const double* p) const override {
    const double radius = m.geometry.radius, distance = p[1];
    const double strength = M_PI * vacuum_permittivity * std::pow(p[0] * radius, 2);  // [N m^2]
    m.normal.beside.emplace_back([=](double d) {
      const double z = std::max(0.0, -d) + distance;
      return -strength / (z * (z + radius));
    });
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(electrostatic, Electrostatic)

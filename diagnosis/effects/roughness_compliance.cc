// A layer of asperities in series with the bulk, whose stiffness grows with the load it bears, k = f/l:
//   d = d_Hertz(f_n) + l ln(1 + f_n/f_0),   f_0 = onset x 4/3 E* R^(1/2) l^(3/2)
// (exponential pressure against gap: Persson 2007, eq. (12); Greenwood & Williamson 1966 with exponential
// heights). f_0 is where the first asperities bear; the layer's length l is of the order of the RMS
// roughness.
#include <cmath>

#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class RoughnessCompliance : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "roughness_compliance",
        "Soft layer of asperities",
        "d = d_Hertz(f_n) + l ln(1 + f_n/f_0), f_0 = onset 4/3 E* R^(1/2) l^(3/2)",
        "Greenwood & Williamson 1966; Persson 2007, eq. (12); Akarapu, Sharp & Robbins 2011",
        "Asperities are pressed flat before the bulk bears: the contact is soft at low load and approaches "
        "the smooth one at high load.",
        EffectKind::contact,
        {Motion::normal}};
    return d;
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double range = e.largest_displacement;
    return {{"roughness_length",
             "m",
             "l, over which the asperity layer's force grows e-fold",
             1e-4 * range,
             range,
             true,
             {0.01 * range, 0.1 * range}},
            {"onset",
             "",
             "force of first touch over that at which Hertz' approach is l",
             1e-3,
             1e3,
             true,
             {0.03, 1}}};
  }
  std::string why_not_by_finite_elements(const Experiment&) const override {
    return "a recording gives the length of its layer, and a case takes a scan or a spectrum with its seeds, "
           "which "
           "that length does not fix; give the case the surface's topography";
  }
  void assemble(Mechanics& m, const double* p) const override {
    const double length = p[0], first = p[1] * m.geometry.force(length);
    m.normal.series.push_back(
        [length, first](double force) { return force > 0 ? length * std::log1p(force / first) : 0.0; });
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(roughness_compliance, RoughnessCompliance)

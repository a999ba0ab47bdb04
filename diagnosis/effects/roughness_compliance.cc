// A layer of asperities in series with the bulk, whose stiffness grows with the load it bears, k = f/l:
//   d = d_Hertz(f_n) + l ln(1 + f_n/f_0),   f_0 = onset x 4/3 E* R^(1/2) l^(3/2)
// (exponential pressure against gap: Persson 2007, eq. (12); Greenwood & Williamson 1966 with exponential
// heights). f_0 is where the first asperities bear; the layer's length l is of the order of the RMS
// roughness.
#include <algorithm>
#include <cmath>

#include "core/printed.h"
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
  EntersBy enters_by(const Experiment&) const override { return EntersBy::in_series; }
  /// A layer fixes no topography: its length was 0.2 to 0.6 of the RMS height on the rough spheres of other
  /// codes (docs/diagnosis.md). Waves are a sixth to two fifths of Hertz' contact radius, or what the mesh
  /// resolves.
  std::vector<CorrectedEntry> corrected_entries(const Experiment& e,
                                                const std::vector<DiagnosedParameter>& found) const override {
    if (!e.case_is_smooth) return {};
    constexpr double least_part = 0.2, part = 0.35, largest_part = 0.6;
    const DiagnosedParameter& length = found.front();
    const double rms = length.value / part, radius = e.hertz().contact_radius(e.largest_force),
                 shortest = std::max(radius / 6, 4 * e.case_spacing),
                 longest = std::max(0.4 * radius, 2 * shortest);
    return {{"Substrate/Topography", "m", rms, length.low / largest_part, length.high / least_part,
             printed("generated(rms=%.4g nm, hurst=0.8, rolloff=%.4g nm, cutoff=%.4g nm, seed=1)", 1e9 * rms,
                     1e9 * longest, 1e9 * shortest)}};
  }
  std::string why_not_by_finite_elements(const Experiment&) const override { return ""; }
  void assemble(Mechanics& m, const double* p) const override {
    const double length = p[0], first = p[1] * m.geometry.force(length);
    m.normal.series.push_back(
        [length, first](double force) { return force > 0 ? length * std::log1p(force / first) : 0.0; });
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(roughness_compliance, RoughnessCompliance)

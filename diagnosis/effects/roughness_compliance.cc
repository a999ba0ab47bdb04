// A layer of asperities on a sphere, whose pressure falls with the gap as exp(-g/l) (Persson 2007, eq. (12);
// Greenwood & Williamson 1966 with exponential heights):
//   d = d_Hertz(f) + l ln(1 + (f/f_0)/(1 + 0.914 d_Hertz(f)/l)),   f_0 = onset x 4/3 E* R^(1/2) l^(3/2)
// Light loads spread over a spot of the layer's own, pi R l wide, and each e-fold of the force takes l; under
// heavy ones the pressure follows Hertz', grows as f^(1/3), and each takes l/3. Fitted to solutions on rings
// of the sphere that carries the layer (in the spirit of Greenwood & Tripp 1967), within 0.011 l for f from
// 0.002 to 510 times 4/3 E* R^(1/2) l^(3/2). f_0 is where the first asperities bear.
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
        "d = d_Hertz(f_n) + l ln(1 + (f_n/f_0)/(1 + 0.914 d_Hertz/l)), f_0 = onset 4/3 E* R^(1/2) l^(3/2)",
        "Greenwood & Tripp 1967 (a layer on a sphere); Persson 2007, eq. (12) (its pressure); 0.914 from "
        "solutions on rings",
        "Asperities are pressed flat before the bulk bears: the contact is soft at low load and approaches "
        "the smooth one at high load.",
        EffectKind::contact,
        {Motion::normal},
        {},
        {"layer"}};
    return d;
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double range = e.largest_displacement;
    std::vector<EffectParameter> list{
        {"roughness_length",
         "m",
         "l, over which the layer's pressure grows e-fold: some 0.2 to 0.5 of the RMS height",
         1e-4 * range,
         range,
         true,
         {0.01 * range, 0.1 * range}},
        {"onset",
         "",
         "force of first touch over that at which Hertz' approach is l",
         least_onset,
         largest_onset,
         true,
         {0.03, 1},
         true}};
    if (is_beside_smooth_case(e)) {
      // First asperities are no stiffer than the sphere at the depth l: f_0/l <= 2 E* (R l)^(1/2).
      list.back().high = 1.5;
      list.back().logarithmic = false;
    }
    if (!has_own_zero(e)) return list;
    constexpr double largest = 0.02, usual = 2e-3;
    list.push_back(
        {"zero_force",
         "N",
         "force at which the displacement was set to zero; no instrument resolves the first asperity",
         0,
         largest * e.largest_force,
         false,
         {0, usual * e.largest_force},
         true});
    if (!e.by_finite_elements) list.back().absent = 0;
    return list;
  }
  /// Where the displacement is counted from a force of its own, first touch may lie as far below as it will.
  bool is_itself(const Experiment& e, const double* p) const override {
    if (is_beside_smooth_case(e)) return true;
    constexpr double inside = 1.01;
    const bool is_seen_later = has_own_zero(e) && p[2] > 0;
    return p[1] < largest_onset / inside && (p[1] > inside * least_onset || is_seen_later);
  }
  bool is_one_curve(const Experiment& e) const override { return is_beside_smooth_case(e); }
  EntersBy enters_by(const Experiment&) const override { return EntersBy::in_series; }
  /// A layer fixes no topography: with a zero of its own its length was 0.27 to 1.07 of the RMS height on the
  /// 21 of 24 rough half-spaces whose zero was seen (docs/diagnosis.md). Waves are a sixth to two fifths of
  /// Hertz' contact radius, or what the mesh resolves.
  std::vector<CorrectedEntry> corrected_entries(const Experiment& e,
                                                const std::vector<DiagnosedParameter>& found) const override {
    if (!e.case_is_smooth || !why_no_entry(e, found).empty()) return {};
    constexpr double least_part = 0.25, part = 0.55, largest_part = 1.1;
    const DiagnosedParameter& length = found.front();
    const double rms = length.value / part, radius = e.hertz().contact_radius(e.largest_force),
                 shortest = std::max(radius / 6, 4 * e.case_spacing),
                 longest = std::max(0.4 * radius, 2 * shortest);
    return {{"Substrate/Topography", "m", rms, length.low / largest_part, length.high / least_part,
             printed("generated(rms=%.4g nm, hurst=0.8, rolloff=%.4g nm, cutoff=%.4g nm, seed=1)", 1e9 * rms,
                     1e9 * longest, 1e9 * shortest)}};
  }
  std::string why_no_entry(const Experiment& e, const std::vector<DiagnosedParameter>& found) const override {
    constexpr double seen = 1e-4;  // of the largest force
    if (!has_own_zero(e) || found.size() < 3 || found[2].value > seen * e.largest_force) return "";
    return "the recorded spot is smooth where it is touched first (zero_force is none): the layer's length "
           "says nothing of a height there, and corrected.prm has no topography for it";
  }
  std::string why_not_by_finite_elements(const Experiment&) const override { return ""; }
  void assemble(Mechanics& m, const double* p) const override {
    const double length = p[0], first = p[1] * m.geometry.force(length);
    const Hertz smooth = m.geometry;
    const auto layer = [length, first, smooth](double force) {
      constexpr double concentrated = 0.914;
      return force > 0
                 ? length * std::log1p(force / first / (1 + concentrated * smooth.approach(force) / length))
                 : 0.0;
    };
    m.normal.series.push_back(layer);
    if (!has_own_zero(m.experiment) || p[2] <= 0) return;
    const double unseen = smooth.approach(p[2]) + layer(p[2]);
    m.normal.shifts.push_back([unseen](const Sample&) { return -unseen; });
  }

 private:
  static constexpr double least_onset = 1e-3, largest_onset = 1e3;
  static bool is_beside_smooth_case(const Experiment& e) { return e.by_finite_elements && e.case_is_smooth; }
  /// A rough case knows its own.
  static bool has_own_zero(const Experiment& e) { return !e.by_finite_elements || e.case_is_smooth; }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(roughness_compliance, RoughnessCompliance)

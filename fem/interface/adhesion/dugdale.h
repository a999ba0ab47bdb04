// Dugdale's attraction: a constant stress s = w/h0 out to the gap h0, for which Maugis solved the sphere
// (Maugis 1992, J. Colloid Interface Sci. 150:243; Dugdale 1960). w: work of adhesion [J/m^2], h0: range [m].
// Its end is a ramp of the same work, between 0.75 and 1.25 h0 by default: a jump has no tangent,
// and steep ramps need fine meshes.
#pragma once

#include <algorithm>

#include "fem/interface/adhesion_law.h"

namespace asperity::fem {

class Dugdale : public AdhesionLaw {
 public:
  /// Of the range [-].
  static constexpr double usual_half_ramp = 0.25;

  /// half_ramp: half the length of the ramp over the range.
  /// work [J/m^2], range h0 [m].
  Dugdale(double work, double range, double half_ramp = usual_half_ramp)
      : work_(work), range_(range), half_ramp_(half_ramp) {}

  Attraction at(double gap) const override {
    const double full = work_ / range_, first = (1 - half_ramp_) * range_, last = (1 + half_ramp_) * range_;
    if (gap >= last) return {0, 0, 0};
    if (gap <= first) return {full, 0, work_ - full * gap};
    const double left = (last - gap) / (last - first);
    return {full * left, -full / (last - first), 0.5 * full * left * (last - gap)};
  }
  double range() const override { return (1 + half_ramp_) * range_; }

 private:
  double work_, range_, half_ramp_;
};

inline const Registered<AdhesionLawDeclaration> dugdale_law{
    {{"dugdale",
      "s(g) = w/h0 for g < h0",
      "Dugdale (1960), Maugis (1992)",
      "between JKR's and DMT's limits; the mesh must resolve the ring over which the gap grows to h0",
      {adhesion_range("h0")}},
     "constant w/h0 out to h0",
     [](double work, const LawValues& values) -> std::unique_ptr<AdhesionLaw> {
       return std::make_unique<Dugdale>(work, values.at("Adhesion range"));
     }}};

}  // namespace asperity::fem

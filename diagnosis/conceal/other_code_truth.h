// The normal contact as other codes have it: axisymmetric finite elements that yield, and boundary elements
// with rough surfaces. SI units.
#pragma once

#include <cstdint>
#include <memory>

#include "core/hertz.h"
#include "diagnosis/conceal/normal_truth.h"

namespace asperity::hidden {

/// A yielding sphere by tables of axisymmetric finite elements (elastic, perfectly plastic, without friction;
/// nu 0.17): loading to 110 approaches of first yield, unloading from up to 50 (beyond, as from 50).
class TabledYielding : public NormalTruth {
 public:
  /// E* [Pa], R [m], Y [Pa].
  TabledYielding(double reduced_modulus, double radius, double yield_stress);
  double force(double approach, double) const override;
  void take(double approach, double) override { largest_ = approach > largest_ ? approach : largest_; }
  /// Approach at first yield [m].
  double critical_approach() const { return critical_; }
  /// Y [Pa] of a sphere whose first yield is at an approach [m].
  static double yield_stress_at(double critical_approach, double reduced_modulus, double radius);

 private:
  double loading_force(double approach) const;
  double critical_, critical_force_, largest_ = 0;
};

/// A self-affine surface under a smooth sphere: what a generator makes of it.
struct RoughSurface {
  double rms = 0, rolloff = 0, cutoff = 0;  ///< [m]
  std::uint64_t seed = 1;
};

/// The elastic contact of a smooth sphere with that surface by half-spaces (half_space/), solved at twenty
/// loads up to a little more than `largest_force` [N]; approach from first touch, at 2e-3 of that force.
/// Throws InputError, WorkError as half_space::contact_of_case does.
std::unique_ptr<NormalTruth> rough_half_spaces(const ElasticBody& sphere, const ElasticBody& plane,
                                               double radius, const RoughSurface& surface,
                                               double largest_force);

/// A smooth sphere with an elastic film on it, likewise (Burmister 1945, half_space/compliance.h).
/// modulus_ratio: of the reduced moduli with the film alone and of the bodies, below that of the plane alone
/// [-]; thickness [m]. The film has the sphere's Poisson ratio.
std::unique_ptr<NormalTruth> coated_half_spaces(const ElasticBody& sphere, const ElasticBody& plane,
                                                double radius, double modulus_ratio, double thickness,
                                                double largest_force);

}  // namespace asperity::hidden

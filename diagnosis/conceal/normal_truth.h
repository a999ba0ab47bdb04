// The contact under normal load as the concealed data have it: one interface, a formulation each. SI units.
#pragma once

#include <memory>
#include <vector>

#include "dem_compare/laws/maugis_dugdale.h"
#include "diagnosis/conceal/sphere.h"

namespace asperity::hidden {

class NormalTruth {
 public:
  virtual ~NormalTruth() = default;
  /// Force at an approach, one step of `time` after the last one that was taken.
  virtual double force(double approach, double time) const = 0;
  virtual void take(double approach, double time) = 0;
};

/// An elastic sphere.
class ElasticTruth : public NormalTruth {
 public:
  explicit ElasticTruth(Sphere sphere) : sphere_(sphere) {}
  double force(double approach, double) const override { return sphere_.force(approach); }
  void take(double, double) override {}

 private:
  Sphere sphere_;
};

/// Between DMT and JKR (Maugis 1992).
class AdhesiveTruth : public NormalTruth {
 public:
  explicit AdhesiveTruth(MaugisDugdale law) : law_(law) {}
  double force(double approach, double) const override { return law_.advance(state_, approach).force; }
  void take(double approach, double) override { state_ = law_.advance(state_, approach); }

 private:
  MaugisDugdale law_;
  NormalState state_;
};

/// Closing along Maugis' curve of one work of adhesion, opening along that of a larger one; from the turning
/// point to it the edge is pinned and the contact is a flat punch of stiffness 2 E* a. One loading and
/// unloading.
class HystereticTruth : public NormalTruth {
 public:
  HystereticTruth(MaugisDugdale closing, MaugisDugdale opening) : closing_(closing), opening_(opening) {}
  double force(double approach, double) const override;
  void take(double approach, double) override;

 private:
  MaugisDugdale closing_, opening_;
  NormalState state_, opening_state_;
  double turn_ = 0;  ///< largest approach so far
};

/// Elastic-plastic sphere after Kogut & Etsion (2002, J. Appl. Mech. 69:657): with w = delta/delta_c,
///   F/F_c = w^(3/2), then 1.03 w^1.425 to w = 6, then 1.40 w^1.263 to w = 110;  delta_c = (pi K H/(2 E*))^2
///   R, K = 0.454 + 0.41 nu, H = 2.8 Y.  Unloading with residual approach and exponent of Etsion, Kligerman &
///   Kadin (2005, Int. J. Solids Struct. 42:3716).
class PlasticTruth : public NormalTruth {
 public:
  /// E* [Pa], R [m], nu [-], Y [Pa].
  PlasticTruth(double reduced_modulus, double radius, double poissons_ratio, double yield_stress);
  double force(double approach, double) const override;
  void take(double approach, double) override { largest_ = approach > largest_ ? approach : largest_; }
  /// Force [N] on the first loading to an approach [m].
  double loading_force(double approach) const;
  /// Approach at first yield [m].
  double critical_approach() const { return critical_; }
  /// Force at first yield [N].
  double critical_force() const { return critical_force_; }

 private:
  double critical_, critical_force_, largest_ = 0;
};

/// Kelvin element in series with the elastic contact, pushed as far as a share of its approach: delta =
/// delta_e(F) + q, tau dq/dt = phi delta_e - q, whether the load is held or not.
class CreepingTruth : public NormalTruth {
 public:
  /// share phi [-], time_constant tau [s].
  CreepingTruth(Sphere sphere, double share, double time_constant)
      : sphere_(sphere), share_(share), time_(time_constant) {}
  double force(double approach, double time) const override { return sphere_.force(elastic(approach, time)); }
  void take(double approach, double time) override { delayed_ = approach - elastic(approach, time); }

 private:
  double elastic(double approach, double time) const;
  Sphere sphere_;
  double share_, time_, delayed_ = 0;
};

/// Sphere on a layer of asperities whose pressure decays with the gap over this length (rough_layer.h).
std::unique_ptr<NormalTruth> rough_truth(const Sphere& sphere, double roughness_length,
                                         double largest_approach);

}  // namespace asperity::hidden

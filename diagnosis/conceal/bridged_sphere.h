// A liquid bridge around a contact: its suction acts on a ring between the edge of the contact and the gap at
// which its surface stands (Maugis 1992 for a constant stress; Maugis & Gauthier-Manuel 1994), and on the
// disc inside of that gap once the bodies no longer touch, which it draws out by 4/pi s c/E* at its edge
// (Johnson 1985, eq. 3.29). It forms at first touch and ruptures where no disc is in equilibrium. SI units.
#pragma once

#include <algorithm>
#include <cmath>

#include "diagnosis/conceal/normal_truth.h"

namespace asperity::hidden {

class BridgedSphere : public NormalTruth {
 public:
  /// pull: 2 pi R times suction times rupture distance [N]; rupture: distance [m].
  BridgedSphere(Sphere sphere, double pull, double rupture)
      : sphere_(sphere),
        rupture_(rupture),
        suction_(pull / (2 * pi * sphere.radius * rupture)),
        law_{sphere.reduced_modulus, sphere.radius, suction_ * rupture, suction_} {}
  double force(double approach, double) const override {
    if (!bridged_at(approach)) return 0;
    const NormalState state = law_.advance(state_, approach);
    return state.contact_radius > 0 ? state.force : -suction_ * pi * std::pow(disc(-approach), 2);
  }
  void take(double approach, double) override {
    is_bridged_ = bridged_at(approach);
    state_ = law_.advance(state_, approach);
  }

 private:
  double drawn_out() const { return 4 / pi * suction_ / sphere_.reduced_modulus; }  // over the radius
  /// Of spheres that do not touch: g + c^2/(2 R) - drawn out = rupture [m].
  double disc(double gap) const {
    const double out = drawn_out() * sphere_.radius;
    return out + std::sqrt(std::max(0.0, out * out + 2 * sphere_.radius * (rupture_ - gap)));
  }
  bool bridged_at(double approach) const {
    const double last = rupture_ + 0.5 * sphere_.radius * std::pow(drawn_out(), 2);
    return approach >= (is_bridged_ ? -last : 0);
  }

  Sphere sphere_;
  double rupture_, suction_;  ///< [m], [Pa]
  MaugisDugdale law_;
  NormalState state_;
  bool is_bridged_ = false;
};

}  // namespace asperity::hidden

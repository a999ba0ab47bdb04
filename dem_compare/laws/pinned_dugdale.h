// Adhesion that takes more work on separation than on approach, w_o > w_c, over one range of attraction h0: a
// constant stress w_c/h0 attracts surfaces on approach, and w_o/h0 those that have been in contact until
// their gap leaves h0 (after Maugis 1992; fem/interface/adhesion_law.h solves the same law by finite
// elements). Contact of radius a, surfaces that have been in contact out to b, attraction out to c, a <= b <=
// c: the problem is linear but for its edges, so that the stresses w_c/h0 within c and (w_o - w_c)/h0 within
// b add up. In Maugis' units of w_o (maugis_dugdale.h), k: w_c/w_o, S(x) = (x^2 - a^2)^(1/2), t(x) =
// arccos(a/x),
//   delta = a^2 - (4/3) lambda [k S(c) + (1 - k) S(b)]
//   f = a^3 - lambda [k (a S(c) + c^2 t(c)) + (1 - k) (a S(b) + b^2 t(b))]
//   2/lambda = a S(c) + (c^2 - 2 a^2) t(c)
//              + (8/3) lambda [k (S(c) t(c) - c + a) + (1 - k) (S(b) t(c) - I)]      (gap h0 at c)
//   I = int_a^b ((b^2 - x^2)/(c^2 - x^2))^(1/2) dx, by elliptic integrals of the modulus b/c.
// The edge b grows with a, on Maugis' branch of w_c; stays where it is while the contact peels within it; and
// is left behind once c has come down to it, on the branch of w_o. In JKR's limit a = b = c: the contact is a
// flat punch between both branches. A cycle loses w_o - w_c on the area that b sweeps.
#pragma once

#include "dem_compare/laws/held_dugdale.h"
#include "dem_compare/laws/maugis_branch.h"

namespace asperity {

class PinnedDugdale {
 public:
  /// lambda: Maugis' parameter of w_o, above 0 [-]; ratio: w_c/w_o, above 0 and at most 1 [-].
  PinnedDugdale(double lambda, double ratio);

  using Contact = DugdaleContact;
  /// At an approach after another state, of which b is 0 where the surfaces were free: the contact forms at
  /// an approach of 0. All but the approach is 0 where they have parted.
  Contact at(double approach, const Contact& before) const { return at(approach, before, before, nullptr); }
  /// The same, sooner where a state after the same one is known at an approach nearby, and at once by the
  /// table of b; null: there is none.
  Contact at(double approach, const Contact& before, const Contact& near, const HeldCurve* curve) const;
  /// Under a force [-] after another state; its radius is not a number where none is found that is in
  /// contact.
  Contact under(double force, const Contact& before) const;

  /// All states with b held [-], for many of them.
  HeldCurve curve(double held_edge) const { return {opening_.lambda(), ratio_, held_edge}; }

  /// Largest tension of w_o under a dead load, over pi w_o R [-].
  double pull_off() const { return opening_.pull_off(); }
  /// The same of w_c, of a contact that was not pressed before [-].
  double pull_off_unpressed() const { return ratio_ * closing_.pull_off(); }
  /// Approach at which a contact that was pressed breaks [-]; not positive.
  double release() const { return opening_.release(); }
  /// Approach at which its surfaces part [-]; not positive.
  double parting() const { return opening_.parting(); }

 private:
  /// On the branch of w_c, over w_o's units.
  Contact grown(const MaugisBranch::Contact& in_own_units) const;
  /// On the branch of w_o.
  Contact peeled(const MaugisBranch::Contact& contact) const;
  /// On the branch of w_o, or with b held, where the surfaces have come closer or apart from a state.
  Contact opened(double approach, const Contact& before, const Contact& near, const HeldCurve* curve) const;

  double ratio_, approach_of_closing_, radius_of_closing_;
  MaugisBranch closing_, opening_;
};

}  // namespace asperity

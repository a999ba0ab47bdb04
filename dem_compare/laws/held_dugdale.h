// States of the contact of pinned_dugdale.h with b, the edge of what has been in contact, held: one for each
// approach, from where the contact begins to peel (a = b) to where the edge is left behind (c = b) or nothing
// touches any more (a = 0).
#pragma once

#include <vector>

namespace asperity {

/// In Maugis' units of w_o [-]; apart: a is 0, and the surfaces still attract each other.
struct DugdaleContact {
  double approach = 0, force = 0, radius = 0, held_edge = 0, attraction_edge = 0;
  bool apart() const { return !(radius > 0); }
};

/// Unknown are s = (b^2 - a^2)^(1/2), by which all is smooth where the contact begins to peel, and c.
class HeldDugdale {
 public:
  /// lambda and ratio as of PinnedDugdale, and b [-].
  HeldDugdale(double lambda, double ratio, double held_edge) : l_(lambda), k_(ratio), b_(held_edge) {}

  /// At an approach or under a force [-], from a state nearby; false where there is none with a > 0.
  bool solve(double target, bool is_force, const DugdaleContact& near, DugdaleContact& found) const;
  /// The same by search over all of the contact, at an approach [-].
  bool search(double approach, DugdaleContact& found) const;
  /// Surfaces that no longer touch, at an approach [-].
  DugdaleContact apart(double approach) const;
  /// Whether the surfaces that a state apart is of do not overlap.
  bool is_apart(const DugdaleContact& contact) const;

 private:
  friend class HeldCurve;
  /// Approach, force, and pi times the gap at c over h0, with their derivatives by s and c.
  struct Terms {
    double approach, approach_s, approach_c, force, force_s, force_c, gap, gap_s, gap_c;
  };
  Terms terms(double s, double c) const;
  double radius(double s) const;
  /// Edge of attraction of a contact that has peeled to s.
  double edge(double s) const;
  /// The same from an edge nearby.
  double edge(double s, double near) const;
  /// s of the last state.
  double last() const;

  double l_, k_, b_;
};

/// All states at once, for many of them at one b: a table of some thirty, with cubics between them, within
/// 1e-5 pi w_o R of the law.
class HeldCurve {
 public:
  /// As of HeldDugdale [-].
  HeldCurve(double lambda, double ratio, double held_edge);

  /// [-].
  double held_edge() const { return b_; }
  /// Whether the edge stays where it is at an approach [-].
  bool holds(double approach) const;
  /// Whether c has come down to b before an approach [-]: the edge is left behind then, or where the contact
  /// is too small to be stable it breaks.
  bool is_beyond(double approach) const;
  DugdaleContact at(double approach) const;

 private:
  struct Node {
    double approach, force, slope, radius, edge;
  };
  double b_;
  bool ends_loose_ = false;
  std::vector<Node> nodes_;  ///< as the approach falls
};

}  // namespace asperity

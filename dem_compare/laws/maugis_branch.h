// All stable states of an adhesive contact of one Maugis parameter (maugis_dugdale.h, in its units): with the
// edge of the attraction at m times the contact radius, u = (m^2 - 1)^(1/2), t = arctan u,
//   Q a^2 + L a = 1,  Q = (lambda/2) [u + (m^2 - 2) t],  L = (4/3) lambda^2 (u t - m + 1)
// gives the radius in closed form, and with it force and approach; u runs from 0, under large loads, to where
// the contact breaks. Many states of one contact cost one table and a search each: at an approach they are
// cubics of its distance's root to where the contact breaks, in which force and radii are smooth there.
//
// Below lambda = 0.938 the contact shrinks to nothing before it breaks, and surfaces that no longer touch
// attract each other over a disc of radius c: f = -(pi lambda/2) c^2, delta = c^2/2 - (8 lambda/(3 pi)) c -
// 2/(pi lambda), down to where d(delta)/dc = 0 (Maugis 1992).
#pragma once

#include <cstddef>
#include <vector>

namespace asperity {

class MaugisBranch {
 public:
  /// lambda: Maugis' parameter [-]; 0 is DMT, and 10 is JKR within a hundredth of the largest tension.
  explicit MaugisBranch(double lambda);

  /// [-].
  double lambda() const { return lambda_; }
  /// Largest tension under a dead load, over pi w R [-].
  double pull_off() const { return pull_off_; }
  /// Approach at which the contact breaks under fixed displacement, in Maugis' unit; not positive.
  double release() const { return release_; }
  /// Approach at which the surfaces part, in Maugis' unit: release(), or beyond it where they still attract
  /// each other once they no longer touch.
  double parting() const { return parting_; }
  /// Over pi w R [-], at an approach from parting() to release().
  double force_apart(double approach) const;
  /// A contact in Maugis' units [-]: its radius a and the edge m a of the attraction around it.
  struct Contact {
    double approach, force, radius, edge;
  };
  /// At an approach above release() [-]; lambda above 0.
  Contact contact(double approach) const;
  /// Under a force above -pull_off() [-]; lambda above 0.
  Contact contact_under(double force) const;
  /// Edge of the attraction of surfaces apart, at an approach from parting() to release() [-]; lambda above
  /// 0.
  double edge_apart(double approach) const;
  /// Over pi w R [-], at an approach above release().
  double force(double approach) const;
  /// In Maugis' unit; under a force above -pull_off(), over pi w R.
  double approach(double force) const;

 private:
  /// A state at ln u, and how it changes with that.
  struct State {
    double place, force, approach, force_slope, approach_slope, radius, edge, radius_slope, edge_slope;
  };
  State at(double place) const;
  /// A state by the root of its approach above release(), with slopes by that root.
  struct Node {
    double force, radius, edge, force_slope, radius_slope, edge_slope;
  };
  /// Between two of them.
  struct Cubic {
    const Node &low, &high;
    double width, part;
    double of(double Node::*value, double Node::*slope) const;
  };
  /// jumps: the contact breaks while it has a radius.
  void list_nodes(bool jumps);
  Cubic cubic_at(double approach) const;
  /// State in which a value, whose slope is told beside it, falls to its target, up to a state of the table.
  State where(double State::*value, double State::*slope, double target, std::size_t last) const;

  double lambda_, pull_off_ = 0, release_ = 0, parting_ = 0;
  std::vector<State> states_;  ///< from the largest loads on, as the approach falls
  std::size_t tensest_ = 0;    ///< the one of least force
  std::vector<double> roots_;  ///< of the nodes, growing [-]
  std::vector<Node> nodes_;
};

}  // namespace asperity

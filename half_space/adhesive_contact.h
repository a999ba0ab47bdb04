// Normal contact of half-spaces whose surfaces attract each other across the gap.
//
// Attraction a(g) falls with the gap g, so that its work is a concave function of the gap, below its tangent:
// with the attraction held as it is, the contact of equilibrium has less energy than before, and attraction
// follows its gap until it no longer changes (majorisation and minimisation: Hunter & Lange 2004, Am. Stat.
// 58, 30). Each of these contacts is one without adhesion, with the gap less what the attraction pulls
// together (bounded_gradients.h). More attraction closes gaps and no gap opens by it, so that the iteration
// never turns back: begun from open surfaces it ends at the equilibrium with the largest gaps, which is met
// on approach, begun from closed ones at that with the smallest, which is met on separation. Contacts that
// jump do so here.
#pragma once

#include <functional>
#include <vector>

#include "half_space/normal_contact.h"

namespace asperity::half_space {

/// Attraction at a gap of 0 or more [m]: [Pa], not negative, and never more at a larger gap.
using AttractionLaw = std::function<double(double gap)>;

/// Of surfaces that have not touched (closing) and that have (opening).
struct Attraction {
  AttractionLaw closing, opening;
  double range = 0;  ///< gap beyond which it is gone, or next to nothing [m]
  double work = 0;   ///< of separation [J/m^2]; for sizes of grids
};

/// A contact in equilibrium with its attraction.
struct AdhesiveSolution {
  NormalContactSolution contact;  ///< pressures of what touches, without the attraction; gaps; approach
  Field attraction;               ///< [Pa]
  std::vector<char> has_touched;  ///< of each cell: attracts by the opening law
  double force = 0;               ///< of contact less attraction; below 0: it must be pulled [N]
  double attracting = 0;          ///< sum of the attraction [N]
  int updates = 0;                ///< of the attraction
};

/// The largest tension on separation.
struct PullOff {
  double force = 0;     ///< [N]
  double approach = 0;  ///< where it is reached [m]
  int states = 0;       ///< equilibria that were solved
};

/// Hears how far a separation has come: approach [m] and force [N].
using OnSeparation = std::function<void(double approach, double force)>;

class AdhesiveContact {
 public:
  /// contact: kept by the caller. Throws InputError without laws or a range.
  AdhesiveContact(const NormalContact& contact, Attraction attraction);

  /// On approach, at a normal force of 0 or more [N]; tolerance: change that is left, of all attraction [-].
  /// Throws as NormalContact does.
  AdhesiveSolution at_force(double force, const NormalContactOptions& options = {},
                            double tolerance = 1e-4) const;
  /// On approach, at an approach [m].
  AdhesiveSolution at_approach(double approach, const NormalContactOptions& options = {},
                               double tolerance = 1e-4) const;
  /// On separation: from `closer`, a state of a larger approach, out to `approach` [m]. Throws InputError
  /// where that is not farther out.
  AdhesiveSolution separated(const AdhesiveSolution& closer, double approach,
                             const NormalContactOptions& options = {}, double tolerance = 1e-4) const;

  /// Force over approach at the beginning of separation [N/m], attraction and contact as they follow.
  double stiffness(const AdhesiveSolution& pressed, const NormalContactOptions& options = {}) const;
  /// Separated step by step from `pressed`, which is not changed; to 0.1 % of the force. `on_state` hears of
  /// each state.
  PullOff pull_off(const AdhesiveSolution& pressed, const NormalContactOptions& options = {},
                   const OnSeparation& on_state = nullptr) const;

 private:
  AdhesiveSolution without_attraction() const;
  void settle(AdhesiveSolution& solution, bool by_force, double value, const NormalContactOptions& options,
              double tolerance) const;
  double update_attraction(AdhesiveSolution& solution) const;

  const NormalContact& contact_;
  Attraction attraction_;
};

}  // namespace asperity::half_space

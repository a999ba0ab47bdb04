// The simulation that a recording is set against, where it is more than reduced laws: a case that can be
// changed and solved again. app/ hands one in; the diagnosis knows nothing of how it solves. SI units.
#pragma once

#include <string>
#include <vector>

#include "core/hertz.h"

namespace asperity {

/// An entry of the case, "Substrate/Yield stress", with another value [SI].
struct CaseChange {
  std::string entry;
  double value = 0;
  std::string unit;
};

/// How the contact is driven: from nothing to the largest force and, where it unloads, back.
struct LoadingProtocol {
  double largest_force = 0;  ///< [N]
  bool unloads = false;
};

/// What one solved case says: approach and force of each accepted step, loading first.
struct SolvedResponse {
  std::vector<double> displacement;  ///< of far points, counted from first touch [m]
  std::vector<double> force;         ///< [N]
  std::size_t peak = 0;              ///< last step of loading
  double displacement_error = 0;     ///< standard deviation of the approach at the largest load, as stated:
                                     ///< of mesh and load steps [m]
  std::string source;                ///< where it can be looked up
};

/// The bodies of the case.
struct SimulatedBodies {
  ElasticBody particle, substrate;
  double radius = 0;  ///< [m]
  bool particle_yields = false, substrate_yields = false;
};

/// A simulation that is solved anew for each set of changes.
class ForwardModel {
 public:
  virtual ~ForwardModel() = default;
  /// Of the case as it is.
  virtual SimulatedBodies bodies() const = 0;
  /// Solves the case with these changes under each of the protocols; what was solved before is reused.
  /// Throws WorkError where a case cannot be solved.
  virtual std::vector<SolvedResponse> solve(const std::vector<CaseChange>& changes,
                                            const std::vector<LoadingProtocol>& protocols) = 0;
};

}  // namespace asperity

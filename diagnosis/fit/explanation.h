// The simulation together with a set of effects: its free parameters and what it says of the recording.
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "diagnosis/catalogue/effect.h"

namespace asperity {

/// A parameter that a fit searches for; values in its unit.
struct FreeParameter {
  std::string name, unit;
  int effect = -1;  ///< index into the explanation's effects; -1: of the simulation itself
  double low = 0, high = 0;
  bool logarithmic = false;
  double scale = 1;  ///< of a linear parameter
  std::vector<double> starts;
  bool bounds_are_meant = true;                                 ///< see EffectParameter
  double no_effect = std::numeric_limits<double>::quiet_NaN();  ///< likewise
  double absent = std::numeric_limits<double>::quiet_NaN();     ///< likewise
  double off_by = std::numeric_limits<double>::quiet_NaN();     ///< likewise [-]

  /// Whether a fit ended at a bound that is only the search's own; value in `unit`.
  bool is_stopped_at(double value) const;
  /// Between the value and the coordinate of the search, of order one.
  /// value in `unit`.
  double coordinate(double value) const;
  double value(double coordinate) const;
};

class Explanation {
 public:
  Explanation(const Experiment& experiment, const SimulationChoice& choice,
              std::vector<const Effect*> effects,
              std::shared_ptr<const BranchCorrection> correction = nullptr);

  /// Of an effect that the case has already and the set does not change, with its values there.
  struct AsInCase {
    const Effect* effect;
    std::vector<double> values;
  };

  const std::vector<const Effect*>& effects() const { return effects_; }
  /// In the order of assembly.
  const std::vector<AsInCase>& as_in_case() const { return as_in_case_; }
  const Experiment& experiment() const { return experiment_; }
  /// What finite elements say beyond the reduced laws; null where the laws are the simulation.
  const std::shared_ptr<const BranchCorrection>& correction() const { return correction_; }
  const std::vector<FreeParameter>& parameters() const { return parameters_; }
  /// The mechanics with values of parameters() in their order.
  Mechanics mechanics(const std::vector<double>& values) const;
  /// The same explanation with another correction.
  std::shared_ptr<const Explanation> with(std::shared_ptr<const BranchCorrection> correction) const;
  /// The same of a case whose bodies do not relax; null where none does, or the set says how.
  std::shared_ptr<const Explanation> without_relaxation_of_case() const;
  bool is_smooth() const;    ///< in its parameters
  std::string name() const;  ///< "a + b", "the simulation alone"
  /// Whether these effects can stand together.
  static bool compatible(const std::vector<const Effect*>& effects);

 private:
  Experiment experiment_;
  SimulationChoice choice_;
  std::vector<const Effect*> effects_;  ///< in the order of assembly
  std::vector<AsInCase> as_in_case_;
  std::vector<FreeParameter> parameters_;
  std::shared_ptr<const BranchCorrection> correction_;
};

/// What is free in the simulation before any physics is added: as given, else the coefficient of the mode.
SimulationChoice completed(const SimulationChoice& choice, const Experiment& experiment);

}  // namespace asperity

// From an engine's trace to the numbers of the experiment, each beside what the law says in closed form.
#pragma once

#include <string>
#include <vector>

#include "engines/experiment.h"
#include "engines/trace.h"

namespace asperity {

/// One number of an experiment.
struct EngineMeasurement {
  std::string name;     ///< "slope after reversal"
  std::string unit;     ///< SI
  double measured = 0;  ///< [unit]
  double law = 0;       ///< closed form [unit]

  /// Measured over law [-].
  double ratio() const { return measured / law; }
};

/// Throws WorkError if the trace is not that of the plan.
std::vector<EngineMeasurement> measure(const EngineExperiment& experiment, const MotionPlan& plan,
                                       const EngineTrace& trace);

/// The measurement of that name; throws WorkError.
const EngineMeasurement& named(const std::vector<EngineMeasurement>& measurements, const std::string& name);

}  // namespace asperity

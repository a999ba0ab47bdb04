// before.csv and after.csv of a diagnosis: the recording's rows with what the simulation gives for each.
#pragma once

#include <string>

#include "diagnosis/outcome/diagnosis.h"
#include "diagnosis/recording/recording.h"

namespace asperity {

/// Which simulation: as it was, or with what was left out.
enum class SimulatedState { before, after };

/// CSV in SI units, tables one below the other: `table`, the channels that were recorded, the segment where
/// one was recorded, and simulated_ with the name of the response. Cells are empty where a table has no such
/// column or a row drives no simulation.
std::string simulated_csv(const Recording& recording, const Diagnosis& diagnosis, SimulatedState state);

}  // namespace asperity

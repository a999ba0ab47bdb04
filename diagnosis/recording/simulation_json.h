// The simulation that recording.json names: reduced laws and what is free in them, or a case of finite
// elements.
#pragma once

#include <string>

#include "core/json_entries.h"
#include "diagnosis/recording/recording.h"

namespace asperity {

/// Throws InputError naming file and entry.
SimulationChoice simulation_of(const Json& json, const std::string& file);
/// The entry "simulation" of recording.json.
Json simulation_json(const SimulationChoice& choice);

}  // namespace asperity

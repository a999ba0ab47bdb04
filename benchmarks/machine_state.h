// What a measured time depends on besides the program: the machine, and what else it was doing.
#pragma once

#include <nlohmann/json.hpp>

namespace asperity {

/// Processor, cores, memory, load averages (1, 5, 15 min) and UTC time now.
nlohmann::json machine_state();

}  // namespace asperity

// Numbers with a standard deviation in JSON files; what is not finite is written as null.
#pragma once

#include <nlohmann/json.hpp>

#include "dem_compare/numbers/uncertain.h"

namespace asperity {

inline void to_json(nlohmann::ordered_json& json, const Uncertain& number) {
  json = {{"value", number.value}, {"sd", number.sd}};
}

}  // namespace asperity

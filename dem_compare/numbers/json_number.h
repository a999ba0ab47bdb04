// A number in a result file: JSON has no NaN, so what is not known is null.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

namespace asperity {

inline nlohmann::ordered_json number_or_null(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

}  // namespace asperity

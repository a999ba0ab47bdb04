// The middle of some values (the upper of two); 0 of none.
#pragma once

#include <algorithm>
#include <vector>

namespace asperity {

/// In the unit of the values.
inline double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<long>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace asperity

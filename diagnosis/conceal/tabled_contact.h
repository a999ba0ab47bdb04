// An elastic contact from pairs of approach and force.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "diagnosis/conceal/normal_truth.h"

namespace asperity::hidden {

class TabledContact : public NormalTruth {
 public:
  /// Rising approaches [m] and their forces [N], of 0 or more.
  TabledContact(std::vector<double> approach, std::vector<double> force)
      : approach_(std::move(approach)), force_(std::move(force)) {}

  /// None below the first approach; F^(2/3) straight between two, as it is by Hertz, and beyond the last.
  double force(double approach, double) const override {
    const auto next = std::upper_bound(approach_.begin(), approach_.end(), approach);
    if (next == approach_.begin()) return 0;
    const std::size_t i =
        std::min<std::size_t>(static_cast<std::size_t>(next - approach_.begin()), approach_.size() - 1);
    const double t = (approach - approach_[i - 1]) / (approach_[i] - approach_[i - 1]);
    return std::pow(
        std::max(0.0, std::pow(force_[i - 1], 2.0 / 3) * (1 - t) + std::pow(force_[i], 2.0 / 3) * t), 1.5);
  }
  void take(double, double) override {}

 private:
  std::vector<double> approach_, force_;
};

}  // namespace asperity::hidden

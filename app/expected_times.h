// How long the cases of a study will take, by what each was expected to take and what those solved so far
// took.
#pragma once

#include <algorithm>
#include <vector>

namespace asperity {

class ExpectedTimes {
 public:
  /// Of each case on one core, all in one unit [s] or [-].
  explicit ExpectedTimes(std::vector<double> expected = {}) : expected_(std::move(expected)) {}

  /// A case was solved in so many seconds [s].
  void was_solved(std::size_t index, double seconds) {
    taken_ += seconds;
    expected_of_taken_ += expected_[index];
  }
  /// Whether anything is known.
  bool are_known() const { return expected_of_taken_ > 0; }
  /// Of a case that has run for so many seconds; at least none [s].
  double left_of(std::size_t index, double running) const {
    return std::max(0.0, taken_ / expected_of_taken_ * expected_[index] - running);
  }

 private:
  std::vector<double> expected_;
  double taken_ = 0, expected_of_taken_ = 0;
};

}  // namespace asperity

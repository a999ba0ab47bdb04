// Where in its period a recorded force of sliding is, read off the recording: where events begin no law says,
// and a recording does.
#pragma once

#include <functional>
#include <vector>

#include "diagnosis/recording/samples.h"

namespace asperity {

/// Of the segments of all runs once the contact slides everywhere, without the mean of each.
class SlidingTrace {
 public:
  /// Part of a segment's path after which the contact slides everywhere [-].
  static constexpr double settled = 0.3;

  explicit SlidingTrace(const Samples& samples);

  /// Part of a period that has passed at each sample, by its index [-]: path over the period [m], and the
  /// phase of the first harmonic of a saw-tooth in a window of three periods about the sample.
  std::vector<double> phases(double period) const;
  /// How many phases of different windows those are [-]: numbers taken from the recording.
  double windows(double period) const;
  /// Over the part of a period that has passed, 0 to 1.
  using Shape = std::function<double(double phase)>;
  /// Log likelihood of what is recorded as a wave of this period [m] and shape, its amplitude and the noise
  /// as fits best, up to what all shapes share [-].
  double log_likelihood(double period, const Shape& shape) const;

 private:
  struct Point {
    std::size_t index;
    double path, force;  ///< since the reversal [m], along the motion [N]
    bool slides;
  };
  using Part = std::vector<Point>;
  std::vector<Part> parts_;
  std::size_t count_ = 0;  ///< indices of all samples are below
};

}  // namespace asperity

// Displacement against force between points that were solved. SI units.
#pragma once

#include <boost/math/interpolators/cubic_hermite.hpp>
#include <memory>
#include <utility>
#include <vector>

namespace asperity {

/// Smooth in f^(2/3), as the approach is by Hertz, between four points or more (a piecewise cubic that does
/// not swing where slopes change, Akima 1970), and straight between fewer. Beyond its ends it stays as it is
/// there.
class ForceCurve {
 public:
  ForceCurve() = default;
  /// A point at a force [N], with a displacement [m]; of several at one force the first counts.
  void add(double force, double displacement) { points_.push_back({scaled(force), displacement}); }
  /// To be called once, after the last point.
  void finish();
  /// Displacement [m] under a force [N]; 0 without points.
  double at(double force) const;
  /// Of curves through points at the same forces, finished, each times a factor [-] that is not 0.
  static ForceCurve sum(const std::vector<ForceCurve>& curves, const std::vector<double>& factors);

 private:
  using Smooth = boost::math::interpolators::cubic_hermite<std::vector<double>>;

  static double scaled(double force);
  std::vector<std::pair<double, double>> points_;
  std::vector<double> x_, slopes_;  ///< of smooth_
  std::shared_ptr<const Smooth> smooth_;
};

}  // namespace asperity

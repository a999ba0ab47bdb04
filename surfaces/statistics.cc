#include "surfaces/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "core/error.h"
#include "surfaces/autocorrelation.h"

namespace asperity {
namespace {

/// Pixel values with a test whether they are known, and neighbours around the edge of periodic maps.
class Pixels {
 public:
  explicit Pixels(const Topography& map) : map_(map) {}
  /// False beyond the edge of a map that is not periodic and at missing points.
  bool get(int ix, int iy, double& height) const {
    if (map_.periodic) {
      ix = (ix + map_.nx) % map_.nx;
      iy = (iy + map_.ny) % map_.ny;
    } else if (ix < 0 || iy < 0 || ix >= map_.nx || iy >= map_.ny) {
      return false;
    }
    const std::size_t index = static_cast<std::size_t>(iy) * map_.nx + ix;
    if (!map_.missing.empty() && map_.missing[index]) return false;
    height = map_.heights[index];
    return true;
  }

 private:
  const Topography& map_;
};

struct Mean {
  double sum = 0;
  std::size_t count = 0;
  void add(double value) { sum += value, ++count; }
  double value() const { return count ? sum / count : std::numeric_limits<double>::quiet_NaN(); }
};

void add_slope_and_curvature(const Topography& map, HeightStatistics& statistics) {
  const Pixels pixels(map);
  const double dx = map.dx(), dy = map.dy();
  Mean slope_x, slope_y, curvature;
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix) {
      double here, left, right, below, above;
      if (!pixels.get(ix, iy, here)) continue;
      const bool has_right = pixels.get(ix + 1, iy, right), has_above = pixels.get(ix, iy + 1, above);
      if (has_right) slope_x.add((right - here) * (right - here) / (dx * dx));
      if (has_above) slope_y.add((above - here) * (above - here) / (dy * dy));
      if (has_right && has_above && pixels.get(ix - 1, iy, left) && pixels.get(ix, iy - 1, below)) {
        const double mean =
            0.5 * ((right - 2 * here + left) / (dx * dx) + (above - 2 * here + below) / (dy * dy));
        curvature.add(mean * mean);
      }
    }
  statistics.rms_slope = std::sqrt(slope_x.value() + slope_y.value());
  statistics.rms_curvature = std::sqrt(curvature.value());
}

}  // namespace

HeightMoments height_moments(const Topography& map) {
  Mean mean;
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  const auto for_each_known = [&](auto visit) {
    for (std::size_t i = 0; i < map.heights.size(); ++i)
      if (map.missing.empty() || !map.missing[i]) visit(map.heights[i]);
  };
  for_each_known([&](double h) {
    mean.add(h);
    lowest = std::min(lowest, h), highest = std::max(highest, h);
  });
  if (mean.count == 0) throw InputError("the topography '" + map.source + "' has no known points");
  const double level = mean.value();
  HeightMoments moments;
  Mean absolute, square, cube, fourth;
  for_each_known([&](double h) {
    const double z = h - level, z2 = z * z;
    absolute.add(std::abs(z)), square.add(z2), cube.add(z2 * z), fourth.add(z2 * z2);
  });
  moments.Sq = std::sqrt(square.value());
  moments.Sa = absolute.value();
  moments.Sz = highest - lowest;
  moments.Ssk = cube.value() / std::pow(moments.Sq, 3);
  moments.Sku = fourth.value() / std::pow(moments.Sq, 4);
  return moments;
}

HeightStatistics height_statistics(const Topography& map) {
  return height_statistics(map, autocorrelation(map));
}

HeightStatistics height_statistics(const Topography& map, const Autocorrelation& correlation) {
  HeightStatistics statistics;
  static_cast<HeightMoments&>(statistics) = height_moments(map);
  add_slope_and_curvature(map, statistics);
  statistics.correlation_length = correlation.length();
  return statistics;
}

GaussianTest gaussian_test(const Topography& map) { return gaussian_test(map, autocorrelation(map)); }

GaussianTest gaussian_test(const Topography& map, const Autocorrelation& correlation) {
  constexpr double significance = 0.01;  // of the test
  constexpr double fewest_samples = 20;  // below, moments have not even roughly their limiting distribution
  const HeightMoments moments = height_moments(map);
  GaussianTest test;
  const double points = static_cast<double>(map.heights.size() - map.missing_count());
  test.skewness_error = std::sqrt(6 * std::max(correlation.mean_power(3), 1 / points));
  test.kurtosis_error = std::sqrt(24 * std::max(correlation.mean_power(4), 1 / points));
  test.independent_samples = 1 / std::max(correlation.mean_power(2), 1 / points);
  const double chi_squared =
      std::pow(moments.Ssk / test.skewness_error, 2) + std::pow((moments.Sku - 3) / test.kurtosis_error, 2);
  test.p_value = std::exp(-chi_squared / 2);

  char text[256];
  if (!(test.independent_samples >= fewest_samples)) {  // also NaN, of a flat map
    test.verdict = GaussianTest::Verdict::too_few_samples;
    std::snprintf(text, sizeof text,
                  "cannot be judged: only about %.0f independent heights (a larger scan is needed)",
                  std::isfinite(test.independent_samples) ? test.independent_samples : 0.0);
  } else {
    const bool rejected = test.p_value < significance;
    test.verdict = rejected ? GaussianTest::Verdict::not_gaussian : GaussianTest::Verdict::consistent;
    std::snprintf(text, sizeof text,
                  "%s: skewness %.2f ± %.2f, kurtosis %.2f ± %.2f (p = %.2g, about %.0f independent heights)",
                  rejected ? "not Gaussian" : "consistent with Gaussian", moments.Ssk, test.skewness_error,
                  moments.Sku, test.kurtosis_error, test.p_value, test.independent_samples);
  }
  test.sentence = text;
  return test;
}

}  // namespace asperity

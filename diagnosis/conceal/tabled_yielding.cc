// Loading: F/F_c over w/w_c; unloading: F = F_max ((w - w_res)/(w_max - w_res))^m with residual approach and
// exponent of its own solution; from tests/data/references/02_elastoplastic_table_ownFE.csv and
// 02_elastoplastic_table_unloading.csv (nu 0.17), mesh and code of neither solver of this program.
#include <array>
#include <boost/math/special_functions/fpclassify.hpp>
#include <cmath>
#include <vector>

// Of Boost 1.74 it calls isnan without declaring it.
#include <boost/math/interpolators/pchip.hpp>

#include "diagnosis/conceal/other_code_truth.h"

namespace asperity::hidden {
namespace {

/// p0/Y at first yield, nu 0.17 (01_hertz_table_yield_vs_nu.csv).
constexpr double first_yield = 1.4663501;

struct Loading {
  double approach, force;  // over those of first yield
};
constexpr std::array<Loading, 16> loading{{{1, 1.0004},
                                           {1.5, 1.8259},
                                           {1.9, 2.5762},
                                           {2, 2.7736},
                                           {3, 4.9359},
                                           {4, 7.369},
                                           {5, 10.014},
                                           {6, 12.831},
                                           {8, 18.896},
                                           {10, 25.417},
                                           {15, 43.156},
                                           {20, 62.491},
                                           {30, 104.59},
                                           {50, 197.85},
                                           {80, 352.46},
                                           {110, 517.14}}};

struct Unloading {
  double from, residual, exponent;  // approach over that of first yield, residual over the largest approach
};
constexpr std::array<Unloading, 6> unloading{{{1, 0, 1.5},
                                              {2.0148, 0.080603, 1.4511},
                                              {5.0317, 0.24904, 1.4218},
                                              {10.054, 0.38047, 1.3994},
                                              {20.09, 0.49881, 1.3758},
                                              {50.168, 0.62839, 1.3578}}};

/// Monotone cubic (Fritsch & Carlson 1980) over the logarithm of approaches.
using Curve = boost::math::interpolators::pchip<std::vector<double>>;

template <class Rows, class Place, class Value>
Curve curve(const Rows& rows, const Place& place, const Value& value) {
  std::vector<double> x, y;
  for (const auto& row : rows) x.push_back(std::log(place(row))), y.push_back(value(row));
  return Curve(std::move(x), std::move(y));
}

double loading_ratio(double ratio) {
  static const Curve log_force = curve(
      loading, [](const Loading& r) { return r.approach; },
      [](const Loading& r) { return std::log(r.force); });
  return std::exp(log_force(std::log(std::min(ratio, loading.back().approach))));
}

}  // namespace

TabledYielding::TabledYielding(double reduced_modulus, double radius, double yield_stress)
    : critical_(std::pow(pi * first_yield * yield_stress / (2 * reduced_modulus), 2) * radius),
      critical_force_(4.0 / 3 * reduced_modulus * std::sqrt(radius) * std::pow(critical_, 1.5)) {}

double TabledYielding::yield_stress_at(double critical_approach, double reduced_modulus, double radius) {
  return std::sqrt(critical_approach / radius) * 2 * reduced_modulus / (pi * first_yield);
}

double TabledYielding::loading_force(double approach) const {
  if (approach <= 0) return 0;
  const double ratio = approach / critical_;
  return critical_force_ * (ratio < 1 ? std::pow(ratio, 1.5) : loading_ratio(ratio));
}

double TabledYielding::force(double approach, double) const {
  if (approach >= largest_ || largest_ <= critical_) return loading_force(approach);
  static const auto from = [](const Unloading& r) { return r.from; };
  static const Curve residual = curve(unloading, from, [](const Unloading&r) { return r.residual; }),
                     exponent = curve(unloading, from, [](const Unloading&r) { return r.exponent; });
  const double place = std::log(std::min(largest_ / critical_, unloading.back().from));
  const double left = residual(place) * largest_;
  if (approach <= left) return 0;
  return loading_force(largest_) * std::pow((approach - left) / (largest_ - left), exponent(place));
}

}  // namespace asperity::hidden

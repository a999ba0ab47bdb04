#include "core/relaxing_modulus.h"

#include <cmath>

namespace asperity {
namespace {

double shear_modulus(const ElasticBody& body) { return body.youngs_modulus / (2 * (1 + body.poisson_ratio)); }
double bulk_modulus(const ElasticBody& body) {
  return body.youngs_modulus / (3 * (1 - 2 * body.poisson_ratio));
}

/// A Kelvin element in series: what it adds to the compliance in the end, and its rate of retardation.
struct Retardation {
  double compliance, rate;  ///< [1/Pa], [1/s]
};

/// G of a body whose plane-strain modulus is M and whose bulk modulus is K, from 1/M = 1/(4 G) + 3/(4 (3 K +
/// G)).
double shear_of(double indented, double bulk) {
  const double half = 1.5 * bulk - 0.5 * indented;
  return 0.75 * bulk * indented / (half + std::sqrt(half * half + 0.75 * bulk * indented));
}

}  // namespace

RelaxingModulus relaxing_modulus(const ElasticBody& relaxing, const RelaxingPart& shear,
                                 const ElasticBody& other) {
  if (!(shear.share > 0)) return {};
  const double G = shear_modulus(relaxing), K = bulk_modulus(relaxing), left = 1 - shear.share;
  const double fast = 1 / reduced_modulus(relaxing, other);
  const double of_both = (3 * K + left * G) / (3 * K + G);
  const Retardation of_shear{(1 / left - 1) / (4 * G), left / shear.time},
      of_sum{0.75 * (1 / of_both - 1) / (3 * K + G), of_both / shear.time};
  // 1/E* = 0 at s = -q.
  const double p = of_shear.rate, q = of_sum.rate, a = of_shear.compliance * p / fast,
               b = of_sum.compliance * q / fast;
  const double half = 0.5 * (p + q + a + b), product = p * q + a * q + b * p;
  const double root = std::sqrt(half * half - product);
  RelaxingModulus modulus;
  for (const double rate : {half - root, half + root})
    modulus.push_back({1 / (rate * (a / std::pow(p - rate, 2) + b / std::pow(q - rate, 2))), 1 / rate});
  return modulus;
}

RelaxingPart as_one_part(const RelaxingModulus& modulus) {
  RelaxingPart one;
  double lag = 0;
  for (const RelaxingPart& part : modulus) {
    one.share += part.share;
    lag += part.share * part.time;
  }
  one.time = one.share > 0 ? lag / one.share : 0;
  return one;
}

RelaxingPart relaxing_shear(const ElasticBody& relaxing, const RelaxingPart& pair, const ElasticBody& other) {
  const double G = shear_modulus(relaxing), K = bulk_modulus(relaxing);
  const double fast = reduced_modulus(relaxing, other), slow = (1 - pair.share) * fast;
  const double of_other = 1 / modulus_alone(other);
  const double indented = 1 / (1 / slow - of_other), left = shear_of(indented, K);
  // Slow loading: E* = slow + share tau fast d/dt, the body's M = indented + dM/dG (G - left) tau d/dt.
  const double slope = indented * indented * (1 / (4 * left * left) + 0.75 / std::pow(3 * K + left, 2));
  const double lag = pair.share * pair.time * fast * std::pow(indented / slow, 2) / (slope * (G - left));
  return {1 - left / G, lag};
}

}  // namespace asperity

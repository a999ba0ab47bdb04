// The modulus of two bodies one of which relaxes.
#include <gtest/gtest.h>

#include <cmath>

#include "core/relaxing_modulus.h"

namespace asperity {
namespace {

/// s times the Laplace transform of E*(t) by the correspondence principle: elastic bodies, of which one has
/// the shear modulus G [1 - g/(1 + tau s)] and its own bulk modulus [Pa].
double transformed(const ElasticBody& relaxing, const RelaxingPart& shear, const ElasticBody& other,
                   double s) {
  const double bulk = relaxing.youngs_modulus / (3 * (1 - 2 * relaxing.poisson_ratio)),
               left = relaxing.youngs_modulus / (2 * (1 + relaxing.poisson_ratio)) *
                      (1 - shear.share / (1 + shear.time * s)),
               youngs = 9 * bulk * left / (3 * bulk + left);
  return reduced_modulus({youngs, youngs / (2 * left) - 1}, other);
}

TEST(RelaxingModulus_analytic, of_a_pair_is_that_of_the_correspondence_principle) {
  const ElasticBody plate{179e9, 0.25};
  for (const double poisson : {0.0, 0.2, 0.34, 0.499})
    for (const double share : {0.01, 0.5, 0.95})
      for (const ElasticBody& other : {plate, ElasticBody{1e9, 0.4}}) {
        const ElasticBody polymer{3e9, poisson};
        const RelaxingPart shear{share, 8};
        const RelaxingModulus modulus = relaxing_modulus(polymer, shear, other);
        ASSERT_EQ(modulus.size(), 2u);
        for (const double s : {1e-6, 0.02, 0.3, 5.0}) {
          double by_parts = 1;
          for (const RelaxingPart& part : modulus) by_parts -= part.share / (1 + part.time * s);
          EXPECT_NEAR(by_parts * reduced_modulus(polymer, other) / transformed(polymer, shear, other, s), 1,
                      1e-9)
              << poisson << " " << share << " " << s;
        }
      }
}

TEST(RelaxingModulus_analytic, of_one_part_is_its_end_and_its_lag_and_comes_back_as_the_body) {
  const ElasticBody polymer{3e9, 0.34}, plate{179e9, 0.25};
  const RelaxingPart shear{0.6, 2};
  const RelaxingPart pair = as_one_part(relaxing_modulus(polymer, shear, plate));
  const double fast = reduced_modulus(polymer, plate), small = 1e-5;
  EXPECT_NEAR(pair.share, 1 - transformed(polymer, shear, plate, 0) / fast, 1e-12);
  const double lag =
      (transformed(polymer, shear, plate, small) - transformed(polymer, shear, plate, 0)) / small;
  EXPECT_NEAR(pair.share * pair.time * fast / lag, 1, 1e-4);
  const RelaxingPart body = relaxing_shear(polymer, pair, plate);
  EXPECT_NEAR(body.share, shear.share, 1e-9);
  EXPECT_NEAR(body.time / shear.time, 1, 1e-9);
  EXPECT_TRUE(relaxing_modulus(polymer, {}, plate).empty());
}

}  // namespace
}  // namespace asperity

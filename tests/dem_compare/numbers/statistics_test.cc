#include "dem_compare/numbers/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.h"

namespace asperity {
namespace {

TEST(Scatter_analytic, mean_standard_deviation_and_standard_error_of_known_numbers) {
  const Scatter scatter = scatter_of({2, 4, 4, 4, 5, 5, 7, 9});
  EXPECT_EQ(scatter.count, 8);
  EXPECT_DOUBLE_EQ(scatter.mean, 5);
  EXPECT_DOUBLE_EQ(scatter.sd, std::sqrt(32.0 / 7));
  EXPECT_DOUBLE_EQ(scatter.standard_error, std::sqrt(32.0 / 7 / 8));
}

TEST(Scatter_analytic, a_single_realisation_has_a_mean_but_no_scatter_and_unknown_values_are_left_out) {
  const Scatter scatter = scatter_of({3, std::numeric_limits<double>::quiet_NaN()});
  EXPECT_EQ(scatter.count, 1);
  EXPECT_EQ(scatter.mean, 3);
  EXPECT_TRUE(std::isnan(scatter.sd));
}

TEST(MeshError_analytic, three_spacings_give_limit_and_order) {
  const auto value = [](double h) { return 2.0 + 0.3 * std::pow(h, 1.7); };
  const MeshError error = mesh_error({0.4, 0.1, 0.25}, {value(0.4), value(0.1), value(0.25)});
  EXPECT_FALSE(error.order_is_assumed);
  EXPECT_NEAR(error.order, 1.7, 1e-9);
  EXPECT_NEAR(error.extrapolated, 2, 1e-12);
  EXPECT_NEAR(error.relative_error, 0.3 * std::pow(0.1, 1.7) / value(0.1), 1e-12);
}

TEST(MeshError_analytic, two_spacings_are_extrapolated_with_the_assumed_order) {
  const MeshError error = mesh_error({10e-9, 5e-9}, {1.04, 1.02});
  EXPECT_TRUE(error.order_is_assumed);
  EXPECT_NEAR(error.extrapolated, 1.0, 1e-12);
  EXPECT_NEAR(error.relative_error, 0.02 / 1.02, 1e-12);
}

TEST(MeshError_analytic, an_order_above_that_of_the_elements_is_not_believed) {
  const auto value = [](double h) { return 1.0 + 0.1 * std::pow(h, 6); };
  const MeshError error = mesh_error({1, 1.5, 2}, {value(1), value(1.5), value(2)});
  EXPECT_TRUE(error.order_is_assumed);
  EXPECT_EQ(error.order, 2);
  EXPECT_GT(std::abs(error.relative_error), 0.5);  // at order 6 it would be 0.09
}

TEST(MeshError_analytic, values_that_do_not_converge_monotonically_fall_back_on_the_assumed_order) {
  EXPECT_TRUE(mesh_error({1, 2, 4}, {1.0, 1.1, 1.0}).order_is_assumed);
}

TEST(MeshError_behaviour, one_spacing_is_refused) { EXPECT_THROW(mesh_error({1e-9}, {1}), InputError); }

}  // namespace
}  // namespace asperity

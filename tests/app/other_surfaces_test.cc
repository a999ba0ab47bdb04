// A case on other seeds, by half-spaces.
#include "app/other_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace asperity {
namespace {

CaseInput case_on(const TopographySpec& surface) {
  CaseInput input;
  input.file = "case.prm";
  input.particle.youngs_modulus = 71e9, input.particle.poisson_ratio = 0.17;
  input.substrate.youngs_modulus = 179e9, input.substrate.poisson_ratio = 0.25;
  input.substrate.topography = surface;
  input.radius = 8.5e-6;
  input.experiment.normal_load = 1e-4;
  return input;
}

double spread_at_largest(const OtherSurfaces& surfaces) {
  double sum = 0;
  for (const auto& change : surfaces.changes) sum += std::pow(change.displacement.back(), 2);
  return std::sqrt(sum / static_cast<double>(surfaces.changes.size()));
}

TEST(OtherSurfacesOfCase_behaviour, smooth_bodies_and_scans_have_none) {
  EXPECT_TRUE(other_surfaces_of(case_on("smooth"), 1e-4).changes.empty());
  EXPECT_TRUE(other_surfaces_of(case_on("wafer.gwy"), 1e-4).changes.empty());
}

TEST(OtherSurfacesOfCase_behaviour, other_seeds_differ_by_more_on_rougher_surfaces) {
  const OtherSurfaces fine = other_surfaces_of(
                          case_on("generated(rms=0.3 nm, hurst=0.8, rolloff=200 nm, cutoff=80 nm, seed=3)"),
                          1e-4),
                      coarse = other_surfaces_of(
                          case_on("generated(rms=1.2 nm, hurst=0.8, rolloff=200 nm, cutoff=80 nm, seed=3)"),
                          1e-4);
  ASSERT_EQ(coarse.changes.size(), 32u);
  std::set<double> seen;
  for (const auto& change : coarse.changes) {
    EXPECT_TRUE(seen.insert(change.displacement.back()).second);  // each seed another surface
    ASSERT_EQ(change.force.size(), 12u);
    EXPECT_EQ(change.displacement.front(), 0);  // from where an instrument sees the contact
    EXPECT_NEAR(change.force.front(), 2e-7, 1e-12);
    EXPECT_NEAR(change.force.back(), 1e-4, 1e-12);
    EXPECT_NE(change.displacement.back(), 0);
  }
  EXPECT_GT(spread_at_largest(coarse), 2 * spread_at_largest(fine));
  EXPECT_LT(spread_at_largest(coarse), 1.2e-9);  // less than the heights themselves
  EXPECT_GT(coarse.unseen, 0);
  EXPECT_LT(coarse.unseen, 2.4e-9);
}

}  // namespace
}  // namespace asperity

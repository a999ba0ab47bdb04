// Half-spaces that attract each other against Maugis' solution, rigid bodies, and what must hold of any law.
#include "half_space/adhesive_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/error.h"
#include "dem_compare/laws/maugis_branch.h"
#include "dem_compare/laws/maugis_dugdale.h"
#include "half_space/contact_shape.h"
#include "surfaces/generate.h"
#include "tests/support/verification.h"

namespace asperity::half_space {
namespace {

using test::Verified;

constexpr double reduced = 52.868e9, radius = 8.5e-6, load = 10e-6;
constexpr double infinitely_hard = std::numeric_limits<double>::infinity();

NormalContact paraboloid_of(int n, double half_width, double modulus = reduced) {
  const Grid grid = square_grid(half_width, n);
  Field gap(grid.cells());
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      gap[j * n + i] = (grid.x(i) * grid.x(i) + grid.y(j) * grid.y(j)) / (2 * radius);
  return NormalContact(grid, Boundary::free, modulus, std::move(gap));
}

/// Dugdale's stress work/range, its end a ramp of half the range about it.
Attraction dugdale(double work, double range) {
  const auto law = [=](double gap) {
    return work / range * std::clamp((1.25 * range - gap) / (0.5 * range), 0.0, 1.0);
  };
  return {law, law, 1.25 * range};
}

Attraction exponential(double closing, double opening, double range) {
  const auto law = [=](double work) {
    return [=](double gap) { return work / range * std::exp(-gap / range); };
  };
  return {law(closing), law(opening), 5 * range};
}

struct MaugisErrors {
  double lambda, approach, stiffness, pull_off;
};

MaugisErrors maugis_errors(int n, double work, double range) {
  const MaugisDugdale maugis{reduced, radius, work, work / range};
  const NormalContact contact = paraboloid_of(n, 500e-9);
  const AdhesiveContact adhesive(contact, dugdale(work, range));
  const AdhesiveSolution pressed = adhesive.at_force(load);
  EXPECT_NEAR(pressed.force / load, 1, 1e-9);
  const double approach = maugis.approach(load);
  return {maugis.lambda(), pressed.contact.approach / approach - 1,
          adhesive.stiffness(pressed) / maugis.advance({}, approach).stiffness - 1,
          adhesive.pull_off(pressed).force / maugis.pull_off_force() - 1};
}

TEST(AdhesiveHalfSpace_analytic, approach_stiffness_and_pull_off_are_those_of_Maugis) {
  struct Case {
    int n;
    double range;
    const char* lambda;
    double most;
  };
  for (const Case& c :
       {Case{128, 3e-9, "0.12", 2e-3}, Case{128, 1e-9, "0.35", 3e-3}, Case{256, 0.3e-9, "1.2", 5e-3}}) {
    const MaugisErrors errors = maugis_errors(c.n, 0.1, c.range);
    EXPECT_NEAR(errors.lambda, std::stod(c.lambda), 0.03);
    const std::string where =
        std::string("lambda ") + c.lambda + ", " + std::to_string(c.n) + " cells over 1 um: ";
    const auto verified = [&](const char* what) {
      return Verified{"Half-space", "attraction across the gap, " + where + what, "Maugis (1992)"};
    };
    EXPECT_TRUE(verified("approach under 10 uN").below(errors.approach, 2e-3));
    EXPECT_TRUE(verified("stiffness under 10 uN").below(errors.stiffness, 0.01));
    EXPECT_TRUE(verified("pull-off force").below(errors.pull_off, c.most));
  }
}

TEST(MaugisBranch_other_code, surfaces_that_no_longer_touch_attract_as_half_spaces_do) {
  const double work = 0.1, range = 1.3e-9, K = 4.0 / 3 * reduced;
  const MaugisBranch branch(MaugisDugdale{reduced, radius, work, work / range}.lambda());
  const double unit = std::cbrt(M_PI * M_PI * work * work * radius / (K * K)), force = M_PI * work * radius;
  const auto sharp = [=](double gap) {
    return work / range * std::clamp((1.02 * range - gap) / (0.04 * range), 0.0, 1.0);
  };
  const NormalContact contact = paraboloid_of(256, 250e-9);
  const AdhesiveContact adhesive(contact, {sharp, sharp, 1.02 * range});
  AdhesiveSolution solution = adhesive.at_force(1e-6);
  for (const double share : {0.1, 0.5, 0.85}) {
    const double place = branch.release() + share * (branch.parting() - branch.release());
    solution = adhesive.separated(solution, unit * place);
    EXPECT_EQ(solution.contact.force, 0) << share;
    const Verified verified{"Reduced laws",
                            "Maugis after the last touch, lambda 0.27, a part of " +
                                std::to_string(share).substr(0, 4) + " on to parting: force",
                            "half-spaces"};
    EXPECT_TRUE(verified.within(solution.force / force, branch.force_apart(place), 0.03)) << share;
  }
}

TEST(AdhesiveHalfSpace_analytic, rigid_rough_bodies_are_held_by_what_attracts_at_first_touch) {
  constexpr double rigid = 1e17, work = 0.05, range = 1e-9;
  const Attraction attraction = exponential(work, work, range);
  GenerateOptions options;
  options.nx = options.ny = 128;
  options.lx = options.ly = 1e-6;
  options.rms = 1e-9;
  options.seed = 4;
  const Topography rough =
      generate_periodic([](double q) { return std::pow(1 + std::pow(q / 6e7, 2), -2.0); }, options);
  const Grid grid = square_grid(0.5e-6, 128);
  Field gap(grid.cells());
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      gap[j * grid.nx + i] = (grid.x(i) * grid.x(i) + grid.y(j) * grid.y(j)) / (2 * radius) - rough.at(i, j);
  const double touch = *std::min_element(gap.begin(), gap.end());
  double expected = 0;
  for (const double g : gap) expected += attraction.opening(g - touch) * grid.cell_area();
  const NormalContact contact(grid, Boundary::free, rigid, gap);
  const AdhesiveContact adhesive(contact, attraction);
  EXPECT_TRUE((Verified{"Half-space", "attraction across the gap, rigid rough bodies: pull-off force",
                        "sum of the attraction at first touch"}
                   .within(adhesive.pull_off(adhesive.at_force(load)).force, expected, 2e-3)));
}

TEST(AdhesiveHalfSpace_analytic, gaps_do_not_overlap_and_attraction_is_that_of_its_gap) {
  const NormalContact contact = paraboloid_of(128, 500e-9);
  const Attraction attraction = exponential(0.05, 0.05, 1e-9);
  const AdhesiveContact adhesive(contact, attraction);
  const AdhesiveSolution pressed = adhesive.at_force(load);
  double most = 0;
  for (std::size_t k = 0; k < pressed.attraction.size(); ++k) {
    const double gap = pressed.contact.gap[k];
    EXPECT_GT(gap, -1e-3 * pressed.contact.approach);
    most = std::max(most, std::abs(pressed.attraction[k] - attraction.opening(std::max(0.0, gap))));
  }
  EXPECT_LT(most, 1e-3 * attraction.opening(0));
  EXPECT_GT(contact_shape(contact.grid(), pressed.contact.pressure, infinitely_hard).area,
            contact_shape(contact.grid(), contact.at_force(load).pressure, infinitely_hard).area);
}

TEST(AdhesiveHalfSpace_behaviour, separation_depends_on_where_it_is_and_not_on_its_steps) {
  const NormalContact contact = paraboloid_of(128, 500e-9);
  const AdhesiveContact adhesive(contact, dugdale(0.1, 0.5e-9));
  const AdhesiveSolution pressed = adhesive.at_force(load);
  const AdhesiveSolution at_once = adhesive.separated(pressed, 0);
  AdhesiveSolution in_steps = pressed;
  for (double share = 0.75; share > -0.1; share -= 0.25)
    in_steps = adhesive.separated(in_steps, share * pressed.contact.approach);
  EXPECT_LT(at_once.force, 0);
  EXPECT_NEAR(in_steps.force / at_once.force, 1, 2e-3);
  int heard = 0;
  double least = 0;
  const PullOff found = adhesive.pull_off(pressed, {}, [&](double, double force) {
    ++heard;
    least = std::min(least, force);
  });
  EXPECT_EQ(heard, found.states);
  EXPECT_DOUBLE_EQ(least, -found.force);
  EXPECT_NEAR(found.force / adhesive.pull_off(adhesive.at_force(3 * load)).force, 1, 2e-3);
}

TEST(AdhesiveHalfSpace_behaviour, of_a_short_range_approach_and_separation_differ) {
  const NormalContact contact = paraboloid_of(256, 300e-9);
  const AdhesiveContact adhesive(contact, dugdale(0.1, 0.15e-9));
  const AdhesiveSolution pressed = adhesive.at_force(load);
  constexpr double apart = -0.2e-9;  // beyond the range of undeformed surfaces
  EXPECT_EQ(adhesive.at_approach(apart).force, 0);
  EXPECT_LT(adhesive.separated(pressed, apart).force, -1e-6);
}

TEST(AdhesiveHalfSpace_behaviour, a_larger_work_of_separation_holds_what_has_touched) {
  const NormalContact contact = paraboloid_of(128, 500e-9);
  const auto pull_off = [&](double closing, double opening) {
    const AdhesiveContact adhesive(contact, exponential(closing, opening, 0.5e-9));
    return adhesive.pull_off(adhesive.at_force(load)).force;
  };
  const double less = pull_off(0.02, 0.02), more = pull_off(0.08, 0.08), held = pull_off(0.02, 0.08);
  EXPECT_GT(held, 2 * less);
  EXPECT_LT(held, more);
}

TEST(AdhesiveHalfSpace_behaviour, needs_a_law_a_range_and_a_separation) {
  const NormalContact contact = paraboloid_of(64, 500e-9);
  EXPECT_THROW(AdhesiveContact(contact, {}), InputError);
  EXPECT_THROW(AdhesiveContact(contact, exponential(1, 1, 0)), InputError);
  const AdhesiveContact adhesive(contact, exponential(0.05, 0.05, 1e-9));
  EXPECT_THROW(adhesive.at_force(-1e-6), InputError);
  const AdhesiveSolution held = adhesive.at_force(0);
  EXPECT_NEAR(held.force, 0, 1e-9);
  EXPECT_GT(held.attracting, 1e-6);
  EXPECT_THROW(adhesive.separated(held, held.contact.approach + 1e-9), InputError);
}

}  // namespace
}  // namespace asperity::half_space

// Elasto-plastic normal laws from load and unload: the laws give their own numbers back; of finite elements
// of another program, how far each law is off, and that `derive` says so.
#include <gtest/gtest.h>

#include <cmath>

#include "dem_compare/derive/elastoplastic_fit.h"
#include "tests/dem_compare/derive/found.h"
#include "tests/support/tabulated_yielding.h"
#include "tests/support/verification.h"

namespace asperity {
namespace {

using test::TabulatedYielding;
using test::Verified;
using P = ContactParameters;

constexpr double radius = 8.5e-6, nm = 1e-9;

/// A law driven to `deepest` in ten steps and back to `end` in ten.
LoadUnload driven(const NormalLaw& law, double deepest, double end, double offset = 0) {
  LoadUnload curve;
  constexpr int steps = 10;
  curve.loading = steps;
  for (int i = 1; i <= steps; ++i) curve.approach.push_back(offset + deepest * i / steps);
  for (int i = 1; i <= steps; ++i) curve.approach.push_back(offset + deepest + (end - deepest) * i / steps);
  curve.force = forces_along(law, curve, offset);
  return curve;
}

TEST(Elastoplastic_analytic, thornton_ning_gives_its_own_parameters_back) {
  const Hertz bodies{50e9, radius};
  for (const double work : {0.0, 0.5})
    for (const double offset : {0.0, 3 * nm}) {
      SCOPED_TRACE(testing::Message() << work << " J/m^2, offset " << offset);
      const ThorntonNing truth{45e9, radius, 1e9, work};
      const ThorntonNing::Flattened left = truth.flattened(40 * nm);
      const double pull = 0.95 * 1.5 * M_PI * work * left.law.radius;
      const LoadUnload curve =
          driven(truth, 40 * nm, left.imprint + (work > 0 ? left.law.approach(-pull) : 2 * nm), offset);
      const auto fit = fit_thornton_ning(curve, bodies, offset > 0);
      ASSERT_TRUE(fit);
      EXPECT_NEAR(fit->law.reduced_modulus / truth.reduced_modulus, 1, 1e-5);
      EXPECT_NEAR(fit->law.yield_pressure / truth.yield_pressure, 1, 1e-5);
      EXPECT_NEAR(fit->offset, offset, 1e-4 * nm);
      EXPECT_NEAR(fit->law.work_of_adhesion, work, 1e-3 * work);
      EXPECT_LT(fit->quality.misfit, 1e-6);
    }
}

TEST(Elastoplastic_analytic, luding_gives_its_own_parameters_back) {
  const Luding truth{20e3, 50e3, 8e3, 40 * nm, radius};
  for (const double offset : {0.0, 3 * nm}) {
    const auto fit = fit_luding(driven(truth, 40 * nm, 20 * nm, offset), radius, offset > 0);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->law.loading_stiffness / 20e3, 1, 1e-6);
    EXPECT_NEAR(fit->law.unloading_stiffness / 50e3, 1, 1e-6);
    EXPECT_NEAR(fit->law.full_approach / (40 * nm), 1, 1e-6);
  }
  // The strongest pull, where the unloading line meets -k_c delta, tells k_c.
  const double there = 30e3 * 40 * nm / 58e3;
  LoadUnload pulled = driven(truth, 40 * nm, there);
  EXPECT_NEAR(fit_luding(pulled, radius, false)->law.adhesion_stiffness / 8e3, 1, 1e-6);
}

TEST(Elastoplastic_behaviour, what_the_curve_does_not_tell_is_not_told) {
  const Hertz bodies{50e9, radius};
  const LoadUnload elastic = driven(ThorntonNing{50e9, radius, 1e12, 0}, 10 * nm, 1 * nm);
  EXPECT_FALSE(fit_thornton_ning(elastic, bodies, false)) << "no yield: any p_y will do";
  LoadUnload short_one = driven(ThorntonNing{50e9, radius, 1e9, 0}, 40 * nm, 20 * nm);
  short_one.approach.resize(12), short_one.force.resize(12);
  EXPECT_FALSE(fit_thornton_ning(short_one, bodies, false)) << "two steps of unloading";
  EXPECT_FALSE(fit_luding(short_one, radius, false));
}

/// The tables' sphere of row `row`, sampled as `solve` would.
LoadUnload tabulated(const TabulatedYielding& truth, std::size_t row) {
  LoadUnload curve;
  constexpr int steps = 10;
  curve.loading = steps;
  for (int i = 1; i <= steps; ++i) {
    const double d = truth.peak(row) * i / steps;
    curve.approach.push_back(d), curve.force.push_back(truth.loading(d));
  }
  for (int i = 1; i < steps; ++i) {
    const double d = truth.peak(row) + (truth.left(row) - truth.peak(row)) * i / steps;
    curve.approach.push_back(d), curve.force.push_back(truth.unloading(d, row));
  }
  return curve;
}

TEST(Elastoplastic_other_code, laws_follow_axisymmetric_finite_elements) {
  const double yield = 1e9;
  const TabulatedYielding truth(yield);
  const char* const deep[] = {"2", "5", "10", "20", "50"};
  const char* const source = "finite elements of another program (axisymmetric)";
  double yield_pressure = 0;
  for (std::size_t row = 1; row < 5; ++row) {
    SCOPED_TRACE(deep[row]);
    const LoadUnload curve = tabulated(truth, row);
    const std::string to = std::string(", up to ") + deep[row] + " approaches of first yield";
    const auto law = fit_thornton_ning(curve, truth.bodies(), false);
    ASSERT_TRUE(law);
    // The law's contact does not harden: its mean p_y grows towards the hardness and beyond, with an E* that
    // is too large.
    EXPECT_GT(law->law.yield_pressure, std::max(1.6 * yield, yield_pressure));
    yield_pressure = law->law.yield_pressure;
    EXPECT_TRUE((Verified{"Reduced laws", "Thornton & Ning fitted: force" + to, source}.below(
        100 * law->quality.misfit, 5, " % of the largest")));
    EXPECT_NEAR(law->quality.solved.imprint, truth.left(row), 0.01 * truth.peak(row));
    EXPECT_NEAR(law->quality.law.imprint / truth.left(row), 1, 0.25);
    EXPECT_NEAR(law->quality.law.dissipated / law->quality.solved.dissipated, 1, 0.15);
    const auto luding = fit_luding(curve, radius, false);
    ASSERT_TRUE(luding);
    EXPECT_TRUE((Verified{"Reduced laws", "Luding fitted: force" + to, source}.below(
        100 * luding->quality.misfit, 10, " % of the largest")));
    EXPECT_GT(luding->quality.misfit, law->quality.misfit);
    EXPECT_NEAR(luding->quality.law.imprint / truth.left(row), 1, 0.25);
  }
}

/// A case of the table's sphere as `solve` writes it.
SolvedCase solved_case(const TabulatedYielding& truth, std::size_t row) {
  const LoadUnload curve = tabulated(truth, row);
  SolvedCase solved;
  solved.folder = "row_" + std::to_string(row);
  solved.entries = CaseEntries(std::map<std::string, std::string>{{"Particle/Radius", "8.5 um"},
                                                                  {"Particle/Young modulus", "71 GPa"},
                                                                  {"Particle/Poisson ratio", "0.17"},
                                                                  {"Particle/Yield stress", "1 GPa"},
                                                                  {"Substrate/Young modulus", "1000000 GPa"},
                                                                  {"Substrate/Poisson ratio", "0.3"},
                                                                  {"Experiment/Type", "normal"}});
  solved.result = case_result_of({{"format", CaseResult::format},
                                  {"experiment", "normal"},
                                  {"mesh", {{"interface_spacing", 1e-8}}},
                                  {"versions", {{"asperity", "0.1.0"}}}},
                                 "made");
  for (std::size_t i = 0; i < curve.force.size(); ++i) {
    for (const auto& column : history_columns())
      if (column.always) (solved.history.*column.values).push_back(0);
    solved.history.normal_displacement.back() = curve.approach[i];
    solved.history.normal_force.back() = curve.force[i];
    solved.history.plastic_volume.back() = 1e-20;
  }
  return solved;
}

TEST(Elastoplastic_other_code, derive_fits_the_largest_load_and_says_how_good_it_is_at_smaller_ones) {
  const TabulatedYielding truth(1e9);
  ParameterSet set;
  for (const std::size_t row : {2, 3}) set.cases.push_back(solved_case(truth, row));
  const Derivation derivation = derive_parameters(reduced_set(set));
  const P& p = derivation.parameters;
  ASSERT_TRUE(p.yield_pressure && p.unloading_modulus && p.luding_k1 && p.luding_kp && p.luding_delta_p);
  EXPECT_FALSE(p.luding_kc) << "nothing pulled";
  const double load = truth.loading(truth.peak(3));
  EXPECT_NEAR(p.yield_pressure->at_load, load, 1e-9 * load);
  EXPECT_GT(p.yield_pressure->value, 1.6e9);
  EXPECT_LT(p.yield_pressure->value, 4e9);
  EXPECT_NEAR(p.unloading_modulus->value / truth.bodies().reduced_modulus, 1.2, 0.1)
      << "the law's unloading is too soft";
  const auto* fact = test::found<ElastoplasticFact>(derivation.law_of(Motion::normal));
  ASSERT_TRUE(fact);
  ASSERT_EQ(fact->errors.size(), 2u);
  EXPECT_NEAR(fact->errors[1].load, truth.loading(truth.peak(2)), 1e-9 * load);
  EXPECT_LT(std::abs(fact->errors[0].imprint), 0.15);
  EXPECT_GT(fact->errors[1].misfit, 0.3 * fact->errors[0].misfit);
  EXPECT_LT(fact->good_from, load);
  EXPECT_EQ(p.derivation["normal"]["thornton_ning"].size(), 2u);
}

TEST(Elastoplastic_behaviour, derive_asks_for_an_unloading_where_none_was_solved) {
  const TabulatedYielding truth(1e9);
  ParameterSet set;
  SolvedCase loaded = solved_case(truth, 2);
  for (const auto& column : history_columns())
    if (column.always) (loaded.history.*column.values).resize(10);
  set.cases.push_back(loaded);
  const Derivation derivation = derive_parameters(reduced_set(set));
  EXPECT_FALSE(derivation.parameters.yield_pressure);
  EXPECT_TRUE(test::asked(derivation.law_of(Motion::normal), OpenQuestion::About::elastoplastic));
}

}  // namespace
}  // namespace asperity

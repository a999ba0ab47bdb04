// Histories made from the reduced laws with known numbers and correlated noise: `derive` must give the
// numbers back.
#include "dem_compare/derive/derivation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/error.h"
#include "core/shear_moduli.h"
#include "dem_compare/laws/lubkin_torsion.h"
#include "dem_compare/laws/maugis_dugdale.h"
#include "engines/engine_input.h"
#include "tests/dem_compare/derive/found.h"
#include "tests/dem_compare/derive/made_case.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/verification.h"

namespace asperity {
namespace {

using test::glass;
using test::make_case;
using test::silicon;
using test::standard;
using test::TemporaryFolder;
using test::Truth;
using About = OpenQuestion::About;

const Hertz& hertz = standard;

ParameterSet make_set(const Truth& truth, const std::vector<double>& loads, int realisations,
                      std::mt19937& random) {
  ParameterSet set;
  for (const double load : loads)
    for (int seed = 1; seed <= realisations; ++seed)
      for (const char* type : {"sliding", "torsion"})
        set.cases.push_back(make_case(truth, type, load, seed, random));
  return set;
}

const std::vector<double> wide{1e-4, 3e-4, 1e-3, 3e-3};

TEST(Derivation_analytic, gives_back_the_laws_that_histories_were_made_from) {
  std::mt19937 random(1);
  Truth exact;
  exact.noise = 0;
  const ContactParameters p = derive_parameters(reduced_set(make_set(exact, wide, 1, random))).parameters;
  EXPECT_NEAR(p.reduced_modulus->value / hertz.reduced_modulus, 1, 1e-6);
  EXPECT_NEAR(p.sliding_friction->value, exact.mu, 1e-6);
  EXPECT_NEAR(p.sliding_offset->value / exact.offset, 1, 1e-3);
  EXPECT_EQ(p.torsion_friction->length_scale, LengthScale::contact_radius);
  EXPECT_NEAR(p.torsion_friction->value, exact.torsion_coefficient, 1e-5);
  EXPECT_NEAR(p.torsion_offset->value / exact.torsion_offset, 1, 1e-3);
  EXPECT_NEAR(p.sliding_friction->load_range->low, 1e-4, 1e-12);
  EXPECT_NEAR(p.sliding_friction->load_range->high, 3e-3, 1e-12);
  EXPECT_FALSE(p.rolling_friction);
  EXPECT_FALSE(p.pull_off_force);
}

TEST(Derivation_analytic, states_uncertainties_that_cover_the_truth_two_times_in_three) {
  std::mt19937 random(2);
  constexpr int repetitions = 60;
  int mu = 0, offset = 0, torsion = 0;
  Truth truth;
  truth.noise = 0.06;  // a mean then is worse known than to the thousandth that any case is good for
  for (int i = 0; i < repetitions; ++i) {
    const ContactParameters p = derive_parameters(reduced_set(make_set(truth, wide, 2, random))).parameters;
    mu += std::abs(p.sliding_friction->value - truth.mu) < p.sliding_friction->sd;
    offset += std::abs(p.sliding_offset->value - truth.offset) < p.sliding_offset->sd;
    torsion += std::abs(p.torsion_friction->value - truth.torsion_coefficient) < p.torsion_friction->sd;
  }
  // 60 draws of a share of 0.683 scatter by 0.060.
  constexpr double share = 0.683, three_sigma = 0.18;
  const auto verified = [](const std::string& what) {
    return test::Verified{"Reduced laws",
                          "derive: " + what + " within one stated sd of the truth, share of 60 draws",
                          "Gauss: 0.683"};
  };
  EXPECT_TRUE(
      verified("mu of sliding").between(mu / double(repetitions), share - three_sigma, share + three_sigma));
  EXPECT_TRUE(verified("h of sliding")
                  .between(offset / double(repetitions), share - three_sigma, share + three_sigma));
  EXPECT_TRUE(verified("mu of torsion")
                  .between(torsion / double(repetitions), share - three_sigma, share + three_sigma));
}

TEST(Derivation_analytic, finds_the_length_of_torsion_from_noisy_histories) {
  std::mt19937 random(2);
  int missed = 0;
  for (int i = 0; i < 40; ++i) {
    Truth truth;
    truth.torsion_with_contact = i % 2 == 0;
    if (!truth.torsion_with_contact) truth.torsion_coefficient = 0.0056;
    const ContactParameters p = derive_parameters(reduced_set(make_set(truth, wide, 2, random))).parameters;
    const double log_odds = p.derivation["torsion"]["length"]["log_odds_a_over_r"];
    EXPECT_EQ(p.torsion_friction->length_scale,
              truth.torsion_with_contact ? LengthScale::contact_radius : LengthScale::particle_radius);
    missed += !((truth.torsion_with_contact ? log_odds : -log_odds) > std::log(20));
  }
  const test::Verified verified{
      "Reduced laws", "derive: lambda = a or r, loads 0.1 to 3 mN, not told with odds above 20, of 40 draws",
      "what made them"};
  EXPECT_TRUE(verified.below(missed, 0));
}

TEST(Derivation_analytic, lets_a_second_radius_tell_the_length_that_its_loads_cannot) {
  std::mt19937 random(11);
  Truth truth;
  truth.torsion_with_contact = false;
  truth.torsion_coefficient = 0.0056;
  truth.torsion_offset = 0;
  std::vector<ParameterSet> sets(2);
  std::vector<Derivation> derivations;
  for (int i = 0; i < 2; ++i) {
    const Hertz sphere{standard.reduced_modulus, i == 0 ? 8.5e-6 : 2.5e-6};
    for (const double load : {0.9e-3, 1e-3})
      for (int seed = 1; seed <= 2; ++seed)
        sets[i].cases.push_back(make_case(truth, "torsion", load, seed, random, sphere));
    sets[i].inputs = {{"Particle/Radius", std::to_string(sphere.radius)}};
    derivations.push_back(derive_parameters(reduced_set(sets[i])));
    EXPECT_EQ(derivations[i].parameters.torsion_friction->length_scale, LengthScale::contact_radius);
  }
  ASSERT_EQ(compare_radii(sets, derivations).size(), 1u);
  for (const auto& derivation : derivations) {
    const EffectiveQuantity& friction = *derivation.parameters.torsion_friction;
    EXPECT_EQ(friction.length_scale, LengthScale::particle_radius);
    EXPECT_NEAR(friction.value, 0.0056, 3 * friction.sd);
    EXPECT_TRUE(derivation.parameters.derivation["torsion"].contains("over_radii"));
  }
}

TEST(Derivation_behaviour, passes_over_cells_that_are_not_known) {
  std::mt19937 random(10);
  Truth exact;
  exact.noise = 0;
  ParameterSet set = make_set(exact, wide, 1, random);
  set.cases.front().history.lateral_force[50] = std::nan("");
  EXPECT_NEAR(derive_parameters(reduced_set(set)).parameters.sliding_friction->value, exact.mu, 1e-6);
}

TEST(Derivation_analytic, treats_rolling_as_torsion) {
  std::mt19937 random(8);
  Truth truth;
  truth.noise = 0;
  ParameterSet set;
  for (const double load : wide) set.cases.push_back(make_case(truth, "rolling", load, 1, random));
  const ContactParameters p = derive_parameters(reduced_set(set)).parameters;
  EXPECT_EQ(p.rolling_friction->length_scale, LengthScale::contact_radius);
  EXPECT_NEAR(p.rolling_friction->value, truth.torsion_coefficient, 1e-5);
  EXPECT_NEAR(p.rolling_offset->value / truth.torsion_offset, 1, 1e-3);
  EXPECT_FALSE(p.torsion_friction);
  EXPECT_FALSE(p.sliding_friction);
  EXPECT_NEAR(p.reduced_shear_modulus->value / reduced_shear_modulus(glass, silicon), 1, 1e-12);
}

TEST(Derivation_analytic, finds_pull_off_where_an_adhesive_contact_is_drawn_apart) {
  std::mt19937 random(9);
  ParameterSet set;
  set.cases.push_back(make_case({}, "normal", 1e-3, 1, random));
  History& history = set.cases.front().history;
  for (const double force : {5e-4, 1e-4, -3e-6, -2e-6}) {
    for (const auto& column : history_columns())
      if (column.always) (history.*column.values).push_back(0);
    history.normal_force.back() = force;
    history.normal_displacement.back() = hertz.approach(std::max(force, 0.0));
  }
  const ContactParameters p = derive_parameters(reduced_set(set)).parameters;
  ASSERT_TRUE(p.pull_off_force);
  EXPECT_DOUBLE_EQ(p.pull_off_force->value, 3e-6);
}

/// Attraction of long range presses like load (Derjaguin, Muller & Toporov 1975): E* is the materials'.
TEST(Derivation_analytic, counts_attraction_beyond_the_contact_as_load) {
  std::mt19937 random(9);
  ParameterSet set;
  set.cases.push_back(make_case({}, "sliding", 1e-3, 1, random));
  SolvedCase& solved = set.cases.front();
  constexpr double attraction = 4e-4;
  auto entries = solved.entries.all();
  entries["Interface/Attraction force"] = "400 uN";
  solved.entries = CaseEntries(entries);
  for (std::size_t i = 0; i < solved.history.size(); ++i)
    solved.history.normal_displacement[i] = hertz.approach(solved.history.normal_force[i] + attraction);
  const Derivation derivation = derive_parameters(reduced_set(set));
  EXPECT_NEAR(derivation.parameters.reduced_modulus->value / hertz.reduced_modulus, 1, 1e-6);
  EXPECT_NEAR(derivation.parameters.reduced_modulus->load_range->high, 1e-3, 1e-12);
  EXPECT_TRUE(test::origin(derivation, &ContactParameters::reduced_modulus, Origin::From::with_attraction));
  ASSERT_TRUE(derivation.parameters.pull_off_force);
  EXPECT_NEAR(derivation.parameters.pull_off_force->value, attraction, 1e-15);
  EXPECT_TRUE(test::origin(derivation, &ContactParameters::pull_off_force, Origin::From::attraction));
}

/// Between the limits of Derjaguin and of Johnson a constant attraction stands for Maugis' (1992) law: E* of
/// its loading is the materials' within 3 %, where a fit of the load alone is 12 % off or more.
TEST(Derivation_other_code, takes_adhesion_out_of_the_modulus_of_a_smooth_contact) {
  std::mt19937 random(9);
  for (const double range : {0.3e-9, 1e-9, 4e-9}) {
    ParameterSet set;
    set.cases.push_back(make_case({}, "normal", 1e-4, 1, random));
    SolvedCase& solved = set.cases.front();
    auto entries = solved.entries.all();
    entries["Interface/Work of adhesion"] = "360 mJ/m^2";
    entries["Substrate/Topography"] = "smooth";
    solved.entries = CaseEntries(entries);
    const MaugisDugdale law{hertz.reduced_modulus, hertz.radius, 0.36, 0.36 / range};
    History& history = solved.history;
    for (std::size_t i = 0; i < history.size(); ++i)
      history.normal_displacement[i] = law.approach(history.normal_force[i]);
    const double adhesive = derive_parameters(reduced_set(set)).parameters.reduced_modulus->value;
    entries["Interface/Work of adhesion"] = "0 J/m^2";
    solved.entries = CaseEntries(entries);
    const double load_alone = derive_parameters(reduced_set(set)).parameters.reduced_modulus->value;
    EXPECT_NEAR(adhesive / hertz.reduced_modulus, 1, 0.03) << range;
    EXPECT_GT(std::abs(load_alone / hertz.reduced_modulus - 1), 0.12) << range;
  }
}

/// What is written is what the fit says: no more, no less is known of it.
TEST(Derivation_analytic, writes_the_standard_deviations_of_its_fits) {
  std::mt19937 random(12);
  Truth truth;
  truth.noise = 0.05;
  const Derivation derivation = derive_parameters(reduced_set(make_set(truth, wide, 2, random)));
  const ContactParameters& p = derivation.parameters;
  const ResistanceLaw sliding = fit_resistance(derivation.law_of(Motion::sliding).points, LengthScale::none);
  EXPECT_DOUBLE_EQ(p.sliding_friction->sd, std::sqrt(sliding.covariance(0, 0)));
  EXPECT_DOUBLE_EQ(p.sliding_offset->sd, std::sqrt(sliding.covariance(1, 1)));
  const ResistanceLaw torsion =
      fit_resistance(derivation.law_of(Motion::torsion).points, LengthScale::contact_radius);
  EXPECT_DOUBLE_EQ(p.torsion_friction->sd, std::sqrt(torsion.covariance(0, 0)));
  EXPECT_DOUBLE_EQ(p.torsion_offset->sd, std::sqrt(torsion.covariance(1, 1)));
}

/// Two realisations whose E* differ by a factor: the mean is known to half their difference.
TEST(Derivation_analytic, knows_the_modulus_of_two_realisations_to_half_their_difference) {
  std::mt19937 random(13);
  Truth exact;
  exact.noise = 0;
  ParameterSet set;
  const double factors[] = {0.9, 1.1};
  for (int i = 0; i < 2; ++i) {
    set.cases.push_back(make_case(exact, "sliding", 1e-3, i + 1, random));
    for (double& approach : set.cases.back().history.normal_displacement)
      approach *= std::pow(factors[i], -2.0 / 3);
  }
  const EffectiveQuantity modulus = *derive_parameters(reduced_set(set)).parameters.reduced_modulus;
  EXPECT_NEAR(modulus.value / hertz.reduced_modulus, 1, 1e-6);
  EXPECT_NEAR(modulus.sd / hertz.reduced_modulus, 0.1, 1e-5);
}

/// Of the mean of two realisations: half of both errors' root of squares.
TEST(Derivation_analytic, tells_the_mean_of_realisations_with_its_own_error) {
  std::mt19937 random(15);
  const Derivation derivation = derive_parameters(reduced_set(make_set({}, {1e-3}, 2, random)));
  const auto& cases = derivation.parameters.derivation["sliding"]["resistance"];
  ASSERT_EQ(cases.size(), 2u);
  double mean = 0, squares = 0, fluctuation = 0;
  for (const auto& item : cases) {
    mean += item["mean"].get<double>() / 2;
    fluctuation += item["fluctuation"].get<double>() / item["mean"].get<double>() / 2;
    squares += std::pow(item["standard_error"].get<double>(), 2);
  }
  const auto* fact = test::found<MeanResistanceFact>(derivation.law_of(Motion::sliding));
  ASSERT_TRUE(fact);
  EXPECT_EQ(fact->cases, 2);
  EXPECT_DOUBLE_EQ(fact->load, 1e-3);
  EXPECT_DOUBLE_EQ(fact->mean.value, mean);
  EXPECT_DOUBLE_EQ(fact->mean.sd, std::sqrt(squares) / 2);
  EXPECT_DOUBLE_EQ(fact->fluctuation, fluctuation);
}

TEST(Derivation_behaviour, says_that_a_way_is_shorter_than_two_diameters) {
  std::mt19937 random(16);
  Truth exact;
  exact.noise = 0;
  ParameterSet set;
  set.cases.push_back(make_case(exact, "sliding", 1e-3, 1, random));
  const History& history = set.cases.front().history;
  const auto asks = [&] {
    return test::asked(derive_parameters(reduced_set(set)).law_of(Motion::sliding), About::long_paths) !=
           nullptr;
  };
  const double a = hertz.contact_radius(1e-3);
  double way = 0;  // of the steady parts there and back
  for (const double x : history.lateral_displacement) way = std::max(way, x);
  const bool is_short = 2 * way < 4 * a;
  EXPECT_EQ(asks(), is_short);
  for (double& x : set.cases.front().history.lateral_displacement) x *= 6 * a / way;
  EXPECT_FALSE(asks());
  for (double& x : set.cases.front().history.lateral_displacement) x *= 0.1;
  EXPECT_TRUE(asks());
}

/// A spring of Mindlin's stiffness that yields: k = 8 G* a tells G*.
TEST(Derivation_analytic, finds_the_shear_modulus_from_the_slope_after_the_reversal) {
  std::mt19937 random(17);
  Truth exact;
  exact.noise = 0;
  ParameterSet set;
  set.cases.push_back(make_case(exact, "sliding", 1e-3, 1, random));
  SolvedCase& solved = set.cases.front();
  const double k = 8 * reduced_shear_modulus(glass, silicon) * hertz.contact_radius(1e-3);
  solved.result->effective = {{"lateral_stiffness", {k, 0.1 * k, "N/m"}}};
  const ContactParameters p = derive_parameters(reduced_set(set)).parameters;
  EXPECT_NEAR(p.lateral_stiffness->value / k, 1, 1e-9);
  EXPECT_NEAR(p.lateral_stiffness->sd / k, 0.1, 1e-9);
  EXPECT_NEAR(p.reduced_shear_modulus->value / reduced_shear_modulus(glass, silicon), 1, 1e-5);
  EXPECT_NEAR(p.reduced_shear_modulus->sd / p.reduced_shear_modulus->value, 0.1, 1e-9);
}

/// Errors of the fits, of as many as there are: two alike are known better by a factor of 2^(1/2).
TEST(Derivation_analytic, knows_a_modulus_as_well_as_its_fits) {
  std::mt19937 random(18);
  ParameterSet one, two;
  for (int seed = 1; seed <= 2; ++seed) two.cases.push_back(make_case({}, "sliding", 1e-3, seed, random));
  for (auto& solved : two.cases)
    for (std::size_t i = 0; i < 8; ++i) solved.history.normal_displacement[i] *= i % 2 ? 1.01 : 0.99;
  one.cases = {two.cases[0]};
  const EffectiveQuantity alone = *derive_parameters(reduced_set(one)).parameters.reduced_modulus;
  const EffectiveQuantity both = *derive_parameters(reduced_set(two)).parameters.reduced_modulus;
  EXPECT_GT(alone.sd / alone.value, 1e-3);
  EXPECT_LT(alone.sd / alone.value, 3e-2);
  EXPECT_NEAR(both.value / alone.value, 1, 1e-12);
  EXPECT_NEAR(both.sd / alone.sd, std::sqrt(0.5), 1e-9);
}

TEST(Derivation_behaviour, takes_a_stiffness_from_a_probe_or_from_a_reversal_and_misses_both) {
  std::mt19937 random(19);
  Truth exact;
  exact.noise = 0;
  const SolvedCase reversed = make_case(exact, "sliding", 1e-3, 1, random);
  SolvedCase forward = reversed;
  for (const auto& column : history_columns())
    if (column.always) (forward.history.*column.values).resize(8 + 100);
  SolvedCase probed = forward;
  probed.result->effective = {{"lateral_stiffness", {5e4, 5e3, "N/m"}}};
  const auto derived = [](const SolvedCase& solved) {
    ParameterSet set;
    set.cases = {solved};
    return derive_parameters(reduced_set(set));
  };
  EXPECT_NEAR(derived(probed).parameters.lateral_stiffness->value, 5e4, 1e-6);
  const auto source = [&](const SolvedCase& solved) {
    return test::found<StiffnessFact>(derived(solved).law_of(Motion::sliding))->source;
  };
  EXPECT_EQ(source(probed), StiffnessSource::probe);
  EXPECT_EQ(source(reversed), StiffnessSource::reversal);
  EXPECT_FALSE(derived(forward).parameters.lateral_stiffness);
  const Derivation open = derived(forward);
  EXPECT_TRUE(test::asked(open.law_of(Motion::sliding), About::stiffness));
  EXPECT_FALSE(test::asked(open.law_of(Motion::sliding), About::rolling_stiffness));
}

TEST(Derivation_behaviour, passes_over_a_stiffness_that_is_no_number) {
  std::mt19937 random(20);
  ParameterSet set;
  set.cases.push_back(make_case({}, "sliding", 1e-3, 1, random));
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  auto& effective = set.cases.front().result->effective;
  effective = {{"normal_stiffness", {unknown, 5, "N/m"}}};
  EXPECT_FALSE(derive_parameters(reduced_set(set)).parameters.normal_stiffness);
  effective = {{"normal_stiffness", {3e4, unknown, "N/m"}}};
  EXPECT_NEAR(derive_parameters(reduced_set(set)).parameters.normal_stiffness->value, 3e4, 1e-6);
  EXPECT_TRUE(std::isnan(derive_parameters(reduced_set(set)).parameters.normal_stiffness->sd));
  effective = {{"normal_stiffness", {3e4, 300, "N/m"}}};
  EXPECT_NEAR(derive_parameters(reduced_set(set)).parameters.normal_stiffness->sd, 300, 1e-9);
}

TEST(Derivation_behaviour, says_which_local_friction_went_in) {
  std::mt19937 random(21);
  ParameterSet set = make_set({}, {1e-3}, 1, random);
  set.inputs = {{"Interface/Friction coefficient", "0.2"}, {"Particle/Radius", "8.5 um"}};
  const auto* origin = test::origin(derive_parameters(reduced_set(set)), &ContactParameters::sliding_friction,
                                    Origin::From::local_friction);
  ASSERT_TRUE(origin);
  EXPECT_EQ(origin->text, "0.2");
}

TEST(Derivation_behaviour, says_that_material_yielded) {
  std::mt19937 random(14);
  ParameterSet set = make_set({}, wide, 1, random);
  EXPECT_FALSE(test::found<YieldFact>(derive_parameters(reduced_set(set)).law_of(Motion::normal)));
  auto& volume = set.cases.back().history.plastic_volume;
  for (std::size_t i = 5; i < volume.size(); ++i) volume[i] = 2e-20;
  const Derivation derivation = derive_parameters(reduced_set(set));
  const auto* fact = test::found<YieldFact>(derivation.law_of(Motion::normal));
  ASSERT_TRUE(fact);
  EXPECT_EQ(fact->yielded, 1u);
  EXPECT_EQ(fact->cases, 8u);
  EXPECT_DOUBLE_EQ(fact->from, 2.25e-3);
  EXPECT_DOUBLE_EQ(fact->largest, 2e-20);
  EXPECT_TRUE(test::origin(derivation, &ContactParameters::reduced_modulus, Origin::From::yielded));
  EXPECT_EQ(derivation.parameters.derivation["normal"]["yielded"]["cases"], 1);
}

TEST(Derivation_behaviour, says_that_bodies_relax) {
  std::mt19937 random(14);
  ParameterSet set = make_set({}, wide, 1, random);
  EXPECT_FALSE(test::found<RelaxationFact>(derive_parameters(reduced_set(set)).law_of(Motion::normal)));
  auto entries = set.cases.back().entries.all();
  entries["Substrate/Relaxing share"] = "0.3";
  set.cases.back().entries = CaseEntries(entries);
  const Derivation derivation = derive_parameters(reduced_set(set));
  const auto* fact = test::found<RelaxationFact>(derivation.law_of(Motion::normal));
  ASSERT_TRUE(fact);
  EXPECT_EQ(fact->relaxed, 1u);
  EXPECT_EQ(fact->cases, 8u);
}

TEST(Derivation_behaviour, says_what_one_load_cannot_tell) {
  std::mt19937 random(3);
  const Derivation derivation = derive_parameters(reduced_set(make_set({}, {1e-3}, 2, random)));
  EXPECT_EQ(derivation.parameters.sliding_offset->value, 0);
  EXPECT_TRUE(std::isnan(derivation.parameters.sliding_offset->sd));
  EXPECT_TRUE(test::asked(derivation.law_of(Motion::sliding), About::offset));
  EXPECT_TRUE(test::asked(derivation.law_of(Motion::torsion), About::length));
  EXPECT_TRUE(test::asked(derivation.law_of(Motion::rolling), About::experiment));
  EXPECT_TRUE(test::found<ScatterFact>(derivation.law_of(Motion::sliding)));
}

TEST(Derivation_behaviour, is_read_back_as_it_was_written) {
  std::mt19937 random(4);
  const TemporaryFolder folder;
  ContactParameters written = derive_parameters(reduced_set(make_set({}, wide, 1, random))).parameters;
  written.sliding_friction->provenance = "of \"eight\" cases";
  write_contact_parameters(written, folder.path / "parameters.json");
  const ContactParameters read = read_contact_parameters(folder.path / "parameters.json");
  for (const auto& entry : quantity_entries()) {
    const auto &before = written.*entry.member, &after = read.*entry.member;
    ASSERT_EQ(before.has_value(), after.has_value()) << entry.key;
    if (!before) continue;
    EXPECT_EQ(before->value, after->value) << entry.key;
    EXPECT_EQ(before->provenance, after->provenance) << entry.key;
  }
  EXPECT_EQ(read.derivation["cases"].size(), 8u);
  EXPECT_EQ(read.torsion_limit(1e-3), written.torsion_limit(1e-3));
  EXPECT_NE(engine_input("lammps", read, {}).find("tangential mindlin_rescale/force"), std::string::npos);
}
}  // namespace
}  // namespace asperity

// Which sets of effects are fitted, and which experiment would tell two explanations apart, where both can be
// done by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <utility>

#include "diagnosis/choose/judged_sets.h"
#include "diagnosis/choose/search.h"
#include "diagnosis/choose/tell_apart.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

using test::nm;
using test::uN;

constexpr double noise = 1e-7;

/// White noise of this deviation, and what the simulation alone leaves.
FitProblem with_noise(FitProblem problem, double deviation) {
  problem.noise.sd.assign(problem.samples.list.size(), deviation);
  problem.noise.shared.assign(1, {});
  problem.thin = problem.samples;
  problem.baseline_residual =
      FitProblem::residual(problem.samples, fit_explanation(problem, {}).simulate(problem.samples));
  return problem;
}

/// Rows of rolling under one load; the sensor's zero is off by `offset`.
FitProblem rows_of_rolling(double offset) {
  FitProblem problem;
  problem.experiment = test::experiment(Motion::rolling);
  problem.experiment.largest_response = 2e-6;
  problem.experiment.has_series = true;
  constexpr double load = 1e-3, friction = 6e-4;
  problem.choice.parameters["rolling_friction"] = {friction, false};
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 40; ++i) {
    problem.samples.list.push_back(test::row(problem.experiment, load * (1 + i % 4)).list[0]);
    problem.samples.list.back().response = friction * load * (1 + i % 4) + offset + noise * normal(random);
  }
  test::close_run(problem.samples, true);
  return with_noise(std::move(problem), noise);
}

/// Pressed 60 nm deep and let go, with the noise of the force.
FitProblem pressed(const std::function<double(double)>& force) {
  FitProblem problem;
  problem.experiment = test::experiment(Motion::normal);
  problem.choice = completed({}, problem.experiment);
  problem.samples = test::approach_and_back(1 * nm, 60 * nm, 60);
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  constexpr double noise_of_force = 2e-6;
  for (Sample& s : problem.samples.list)
    s.response = force(s.normal_displacement) + noise_of_force * normal(random);
  return with_noise(std::move(problem), noise_of_force);
}

std::size_t largest_set(const SearchResult& found) {
  std::size_t most = 0;
  for (const Candidate& candidate : found.candidates)
    most = std::max(most, candidate.fit.explanation->effects().size());
  return most;
}

SearchResult searched(const FitProblem& problem, const IsNoise& is_noise) {
  return search_effects(problem, fit_explanation(problem, {}), is_noise, {});
}

TEST(SearchEffects_behaviour, stops_where_noise_is_left_and_goes_on_to_three_where_it_is_not) {
  const IsNoise always = [](const ModelFit&) { return true; }, never = [](const ModelFit&) { return false; };
  EXPECT_EQ(largest_set(searched(rows_of_rolling(0), always)), 1u)
      << "noise of which no effect takes anything away";
  EXPECT_EQ(largest_set(searched(rows_of_rolling(5 * noise), always)), 2u)
      << "an effect shows in what would pass for noise";
  EXPECT_EQ(largest_set(searched(rows_of_rolling(5 * noise), never)), 3u);
}

/// Of a set's law errors at a part of what they state, done anew.
double cost_at(const FitProblem& problem, const SearchResult& found, const Candidate& of, double part) {
  const Misfit misfit = misfit_of(problem, of.fit, found.alone.fit);
  return LawErrors(problem.samples)
      .cost(problem.samples, problem.noise, misfit.residual, laws_off_by(part, misfit.errors))
      .sum();
}

TEST(SearchEffects_analytic, scores_by_schwarz_with_a_prior_for_each_effect) {
  const FitProblem problem = rows_of_rolling(5 * noise);
  const SearchResult found = searched(problem, [](const ModelFit&) { return true; });
  const Candidate& best = found.candidates.front();
  EXPECT_EQ(best.fit.explanation->name(), "lateral_zero_offset");
  double least = found.alone.cost;
  for (const Candidate& candidate : found.candidates)
    for (const double cost : candidate.costs) least = std::min(least, cost);
  EXPECT_NEAR(found.overdispersion, std::max(1.0, least / static_cast<double>(found.alone.fit.count)), 1e-12);
  const double prior = -0.5 * std::log(problem.samples.list.size()) - std::log(found.admissible);
  EXPECT_NEAR(best.score_as_stated, -0.5 * best.cost / found.overdispersion + prior, 1e-9);
  EXPECT_NEAR(found.alone.score, -0.5 * found.alone.cost / found.overdispersion, 1e-9);
  // Laws may be off by any part of what they state.
  double sum = 0, squares = 0;
  for (const double part : {1.0, 0.25, 0.0625, 0.015625}) {
    const double likely = std::exp(-0.5 * cost_at(problem, found, best, part) / found.overdispersion);
    sum += likely, squares += likely * part * part;
  }
  EXPECT_NEAR(best.score, std::log(sum / 4) + prior, 1e-9);
  EXPECT_NEAR(best.fit.part_of_bound, std::sqrt(squares / sum), 1e-9);
}

/// The yield stress of a body that yields, and how it varies: two effects in the prior, and one parameter for
/// each.
TEST(SearchEffects_analytic, an_effect_that_holds_another_counts_as_both) {
  const FitProblem problem =
      pressed([](double d) { return test::experiment(Motion::normal).hertz().force(d); });
  const SearchResult found = searched(problem, [](const ModelFit&) { return false; });
  const double count = static_cast<double>(problem.samples.list.size()), one = std::log(found.admissible);
  int seen = 0;
  for (const Candidate& candidate : found.candidates) {
    const std::string name = candidate.fit.explanation->name();
    const double effects = name == "bulk_plasticity" ? 1 : name == "indentation_size" ? 2 : 0;
    if (effects == 0) continue;
    ++seen;
    EXPECT_NEAR(candidate.score_as_stated,
                -0.5 * candidate.cost / found.overdispersion - std::log(count) - effects * one, 1e-9)
        << name;
  }
  EXPECT_EQ(seen, 2);
}

/// Quantiles of chi-square at 0.999 (Abramowitz & Stegun 1964, table 26.8): 51.179 of 24, 86.661 of 50.
TEST(LargestOfNoise_analytic, is_what_few_samples_scatter_or_a_deviation_known_to_a_fifth) {
  EXPECT_NEAR(largest_of_noise(24), 51.179 / 24, 1e-4);
  EXPECT_NEAR(largest_of_noise(50), 86.661 / 50, 1e-4);
  EXPECT_EQ(largest_of_noise(1000), 1.5);
}

/// What a second effect lets the first state less is no gain of it.
TEST(JudgedSets_behaviour, a_member_earns_nothing_by_what_the_others_state_less) {
  const Hertz hertz = test::experiment(Motion::normal).hertz();
  const FitProblem problem =
      pressed([&](double d) { return 0.7 * hertz.force(std::max(0.0, d - 1.5 * nm)); });
  SearchResult found = searched(problem, [](const ModelFit&) { return false; });
  const Scanner scanner(problem.samples, problem.experiment, problem.noise, 1);
  const Blocks blocks = blocks_of(problem.samples);
  const HeldOut alone = predict_held_out(problem, finished(problem, found.alone.fit), blocks);
  const auto candidate = [&](const std::string& name) -> Candidate& {
    return *std::find_if(found.candidates.begin(), found.candidates.end(),
                         [&](const Candidate& c) { return c.fit.explanation->name() == name; });
  };
  const std::string both = "effective_radius + contact_point_offset";
  const auto is_named = [&] {
    const JudgedSets judged = judged_sets(problem, found, scanner, blocks, alone);
    return std::any_of(judged.list.begin(), judged.list.end(),
                       [&](const JudgedSet& set) { return set.candidate->fit.explanation->name() == both; });
  };
  EXPECT_TRUE(is_named());
  // Each of its two members must be clearly better than none: eight each in log evidence.
  const double of_alone = found.alone.score;
  found.alone.score = candidate(both).score - 15.9;
  EXPECT_FALSE(is_named());
  found.alone.score = candidate(both).score - 16.1;
  EXPECT_TRUE(is_named());
  found.alone.score = of_alone;
  Candidate &radius = candidate("effective_radius"), &pair = candidate(both);
  const Candidate& offset = candidate("contact_point_offset");
  pair.score_as_stated = std::max(radius.score_as_stated, offset.score_as_stated) + 10;
  pair.room = std::max(radius.room, offset.room);
  EXPECT_TRUE(is_named());
  pair.room = radius.room - 20 * found.overdispersion;  // ten in log evidence
  radius.fit.part_of_bound = 0.1;
  EXPECT_FALSE(is_named());
  radius.fit.part_of_bound = 0.9;  // it needs what it states
  EXPECT_TRUE(is_named());
}

/// An explanation with given parameters, in the order of Explanation::parameters().
ModelFit with_values(const FitProblem& problem, const char* effect, std::vector<double> values) {
  ModelFit fit;
  std::vector<const Effect*> effects;
  if (effect) effects.push_back(&effect_of(effect));
  fit.explanation = std::make_shared<Explanation>(problem.experiment, problem.choice, effects);
  fit.values = std::move(values);
  return fit;
}

/// Finite elements that agree with Hertz and state that they may be off by so much.
class OffByItsMesh : public BranchCorrection {
 public:
  explicit OffByItsMesh(double error) : error_(error) {}
  double error() const override { return error_; }

 private:
  double error_;
};

/// A contact, and a rival with other log evidence and another zero [m], which predicts worse.
struct Rival {
  double score, offset, as_stated = -10, mesh_error = 0;
};
bool is_as_good(const Rival& rival) {
  const Hertz hertz = test::experiment(Motion::normal).hertz();
  const FitProblem problem = pressed([&](double d) { return hertz.force(d); });
  Candidate first, second;
  first.score = first.score_as_stated = 0;
  second.score = rival.score, second.score_as_stated = rival.as_stated;
  JudgedSet chosen{&first, with_values(problem, "contact_point_offset", {0}), {}},
      other{&second, with_values(problem, "contact_point_offset", {rival.offset}), {}};
  if (rival.mesh_error > 0)
    chosen.fit.explanation = chosen.fit.explanation->with(std::make_shared<OffByItsMesh>(rival.mesh_error));
  chosen.held_out.cost = 1, other.held_out.cost = 1.2;
  return rivalry(problem, chosen, other).is_as_good;
}

TEST(JudgedSets_analytic, what_data_cannot_tell_is_as_good_within_odds_of_a_hundred) {
  // Two deviations of 2 uN over 120 samples of 1 to 60 nm: 0.0023 nm times a stiffness of some 100 kN/m.
  EXPECT_TRUE(is_as_good({-3, 1e-4 * nm}));
  EXPECT_FALSE(is_as_good({-5, 1e-4 * nm})) << "the odds are more than a hundred";
  EXPECT_FALSE(is_as_good({-3, 0.1 * nm})) << "these data tell";
  EXPECT_FALSE(is_as_good({-2, 0.1 * nm})) << "it predicts worse";
  EXPECT_TRUE(is_as_good({-8, 0.1 * nm, 1})) << "ahead if all laws were off by what they state";
}

TEST(JudgedSets_analytic, one_of_more_parameters_that_imitates_is_not_as_good) {
  const Hertz hertz = test::experiment(Motion::normal).hertz();
  const FitProblem problem = pressed([&](double d) { return hertz.force(d); });
  Candidate first, second;
  first.score = first.score_as_stated = 0, second.score = -3, second.score_as_stated = -10;
  JudgedSet chosen{&first, with_values(problem, "contact_point_offset", {0}), {}},
      imitates{&second, with_values(problem, "film", {1, 10 * nm}), {}};
  chosen.held_out.cost = 1, imitates.held_out.cost = 1.2;
  EXPECT_FALSE(rivalry(problem, chosen, imitates).is_as_good);
}

/// A film for a layer of asperities was named with odds of thirty to one.
TEST(JudgedSets_analytic, a_film_and_asperities_are_as_good_within_odds_of_a_hundred) {
  const Hertz hertz = test::experiment(Motion::normal).hertz();
  const FitProblem problem = pressed([&](double d) { return hertz.force(d); });
  Candidate first, second;
  first.score = first.score_as_stated = 0, second.score = -3, second.score_as_stated = -10;
  JudgedSet film{&first, with_values(problem, "film", {0.3, 100 * nm}), {}},
      asperities{&second, with_values(problem, "roughness_compliance", {1 * nm, 0.1, 0}), {}},
      offset{&second, with_values(problem, "contact_point_offset", {5 * nm}), {}};
  film.held_out.cost = asperities.held_out.cost = offset.held_out.cost = 1;
  EXPECT_TRUE(rivalry(problem, film, asperities).is_as_good);
  EXPECT_FALSE(rivalry(problem, film, offset).is_as_good);
  second.score = -5;
  EXPECT_FALSE(rivalry(problem, film, asperities).is_as_good);
}

TEST(JudgedSets_analytic, a_solution_off_by_more_than_noise_does_not_predict_better_by_noise) {
  // 0.01 nm are 1 uN at most, half of the noise; 0.3 nm are fifteen deviations.
  EXPECT_FALSE(is_as_good({-2, 0.1 * nm, -10, 0.01 * nm}));
  EXPECT_TRUE(is_as_good({-2, 0.1 * nm, -10, 0.3 * nm}));
}

std::string between(const std::string& experiment, const char* there, const char* here) {
  return experiment + ": there the two differ by up to " + there +
         " times the noise of a sample, in these data by " + here;
}

FitProblem one_row(Motion mode, double load, const char* coefficient, double value) {
  FitProblem problem;
  problem.experiment = test::experiment(mode);
  problem.choice.parameters[coefficient] = {value, false};
  problem.samples = test::row(problem.experiment, load);
  problem.thin = problem.samples;
  problem.noise.sd = {noise};
  problem.noise.shared.assign(1, {});
  return problem;
}

TEST(TellApart_analytic, a_series_is_measured_where_two_laws_that_agree_part_most) {
  // Torsion: a zero that is off by what 1 % of friction is at this load. At ten times the largest load, 30
  // mN, they part by 29 times that.
  FitProblem problem = one_row(Motion::torsion, 3e-3, "torsion_friction", 0.01);
  problem.choice.torsion = "constant";
  ModelFit offset = with_values(problem, "lateral_zero_offset", {3e-6});
  FitProblem more = problem;
  more.choice.parameters["torsion_friction"] = {0.011, false};
  const ModelFit friction = with_values(more, nullptr, {});
  EXPECT_EQ(experiment_that_tells_apart(problem, offset, friction),
            between("measure at a higher load of 30 mN (largest so far 3 mN)", "270", "0.0"));
  // The other way round: at a tenth of the smallest load, 10 uN, a hundredth of the friction is left, but all
  // of the offset.
  problem.experiment.largest_force = 1e-4;
  EXPECT_EQ(experiment_that_tells_apart(problem, offset, friction),
            between("measure at a lower load of 10 uN (smallest so far 100 uN)", "30", "0.0"));
}

TEST(TellApart_analytic, a_series_is_measured_at_another_speed_where_that_counts) {
  FitProblem problem = one_row(Motion::rolling, 1e-3, "rolling_friction", 6e-4);
  problem.experiment.largest_force = 1e-4;
  const ModelFit alone = with_values(problem, nullptr, {}),
                 faster = with_values(problem, "velocity_dependence", {1e-3});
  // mu changes by b ln(v/v0), v0 of 1 and 10 um/s their geometric mean: 4.605 uN at a hundred times v0, 1.151
  // uN at 10 um/s.
  EXPECT_EQ(experiment_that_tells_apart(problem, alone, faster),
            between("measure at 320 um/s", "46", "11.5"));
}

TEST(TellApart_analytic, says_so_where_nothing_within_reach_would_tell) {
  const FitProblem problem = one_row(Motion::rolling, 1e-3, "rolling_friction", 6e-4);
  const ModelFit alone = with_values(problem, nullptr, {}),
                 hardly = with_values(problem, "lateral_zero_offset", {0.5 * noise});
  const std::string said = experiment_that_tells_apart(problem, alone, hardly);
  EXPECT_EQ(said.find("no change of load, path, speed, radius or roughness within reach separates the two by "
                      "more than 0.5 times"),
            0u)
      << said;
}

/// Loading over 100 s; a drift by `rate` against none.
FitProblem loading() {
  FitProblem problem;
  problem.experiment = test::experiment(Motion::normal);
  Experiment& e = problem.experiment;
  e.has_trace = e.has_time = true;
  e.largest_displacement = 20 * nm, e.largest_force = e.hertz().force(20 * nm);
  problem.samples = test::approach_and_back(0, 20 * nm, 50);
  problem.thin = problem.samples;
  problem.noise.sd.assign(problem.samples.list.size(), uN);
  problem.noise.shared.assign(1, {});
  return problem;
}

TEST(TellApart_analytic, a_drift_shows_where_the_contact_is_held_for_longer) {
  const FitProblem problem = loading();
  const double rate = 1e-3 * nm;
  const ModelFit alone = with_values(problem, nullptr, {}),
                 drift = with_values(problem, "thermal_drift", {rate});
  // A hold of 10 hold durations, 60 s at least, comes after 50 s; ten times more slowly the largest load is
  // reached after 500 s, and back at d the drift of up to 1000 s shows. There d + rate t differs most from d
  // in force where F(d) - F(d - rate t) is largest.
  const std::string said = experiment_that_tells_apart(problem, alone, drift);
  const Hertz& hertz = problem.experiment.hertz();
  double most = 0, here = 0;
  for (int i = 0; i <= 60; ++i) {
    const double d = 20 * nm * (1 - i / 60.0),
                 t = 1000.0 * (60 + 1 + i) / 120;  // the turn is recorded on both ways
    most = std::max(most, hertz.force(d) - hertz.force(std::max(0.0, d - rate * t)));
  }
  for (const Sample& s : problem.samples.list)
    here = std::max(here, hertz.force(s.normal_displacement) -
                              hertz.force(std::max(0.0, s.normal_displacement - rate * s.time)));
  char there[32], in_these[32];
  std::snprintf(there, sizeof there, "%.0f", most / uN);
  std::snprintf(in_these, sizeof in_these, "%.1f", here / uN);
  EXPECT_EQ(said, between("load and unload ten times more slowly", there, in_these));
}

TEST(TellApart_analytic, a_small_radius_shows_under_large_loads) {
  const FitProblem problem = loading();
  const ModelFit alone = with_values(problem, nullptr, {});
  const ModelFit blunter = with_values(problem, "effective_radius", {1.1});
  const double most = problem.experiment.hertz().force(60 * nm) * (std::sqrt(1.1) - 1) / uN;
  char there[32], here[32];
  std::snprintf(there, sizeof there, "%.0f", most);
  std::snprintf(here, sizeof here, "%.1f", most / std::pow(3, 1.5));
  EXPECT_EQ(experiment_that_tells_apart(problem, alone, blunter),
            between("load and unload to 60 nm, beyond what was recorded", there, here));
}

/// Loops of 100 nm at one load and 3.2 um/s.
FitProblem loops() {
  FitProblem problem;
  problem.experiment = test::experiment(Motion::sliding);
  problem.experiment.has_trace = true;
  problem.choice.parameters["sliding_friction"] = {0.2, false};
  problem.samples = test::lateral_path(1e-3, {0, 1e-7, 0}, 60);
  problem.thin = problem.samples;
  problem.noise.sd.assign(problem.samples.list.size(), uN);
  problem.noise.shared.assign(1, {});
  return problem;
}

TEST(TellApart_analytic, a_speed_shows_at_another_speed) {
  const FitProblem problem = loops();
  EXPECT_DOUBLE_EQ(std::sqrt(problem.experiment.slowest * problem.experiment.fastest), std::sqrt(1e-11));
  const Effect& effect = effect_of("velocity_dependence");
  std::vector<double> values;
  for (const auto& parameter : effect.parameters(problem.experiment))
    values.push_back(parameter.starts.back());
  const ModelFit alone = with_values(problem, nullptr, {}),
                 faster = with_values(problem, "velocity_dependence", values);
  const std::string said = experiment_that_tells_apart(problem, alone, faster);
  // mu changes by b ln(v/v0), b a twentieth of 1/3: at 1 mN 4.605 b mN at a hundred times v0, 1.151 b mN as
  // recorded.
  EXPECT_EQ(said, between("record loops at 320 um/s", "77", "19.2"));
}

}  // namespace
}  // namespace asperity

// What a second effect is worth beside a layer, and how far behind a set is no rival.
#include "diagnosis/choose/members.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "diagnosis/catalogue/effect.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

using test::nm;
using test::uN;

/// A layer of asperities on a sphere whose radius is another, pressed 60 nm deep and let go.
FitProblem layer_on_a_larger_sphere(double noise, double radius_ratio) {
  FitProblem problem;
  problem.experiment = test::experiment(Motion::normal);
  problem.choice = completed({}, problem.experiment);
  problem.samples = test::approach_and_back(1 * nm, 60 * nm, 60);
  const std::vector<double> force =
      simulate(test::with(problem.experiment,
                          {{"roughness_compliance", {1 * nm, 0.5, 0}}, {"effective_radius", {radius_ratio}}}),
               problem.samples);
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; i < force.size(); ++i)
    problem.samples.list[i].response = force[i] + noise * normal(random);
  problem.noise.sd.assign(force.size(), noise);
  problem.noise.shared.assign(1, {});
  problem.thin = problem.samples;
  problem.baseline_residual =
      FitProblem::residual(problem.samples, fit_explanation(problem, {}).simulate(problem.samples));
  return problem;
}

/// Found in blind recordings of rough spheres: with its law mended by a second effect the layer fits, and
/// alone it fell behind two effects of the instrument.
TEST(Members_behaviour, a_layer_has_the_score_of_a_set_that_mends_its_law) {
  const FitProblem problem = layer_on_a_larger_sphere(5 * uN, 1.1);
  SearchResult found =
      search_effects(problem, fit_explanation(problem, {}), [](const ModelFit&) { return false; }, {});
  const Scanner scanner(problem.samples, problem.experiment, problem.noise, 1);
  const std::string both = found.candidates.front().fit.explanation->name();
  const double score = found.candidates.front().score;
  EXPECT_EQ(both, "effective_radius + roughness_compliance");
  const Members members = members_of(problem, found, scanner, found.candidates.front());
  EXPECT_FALSE(members.count) << "real layers follow their law to some per cent";
  ASSERT_NE(members.mended, nullptr);
  EXPECT_EQ(members.mended->fit.explanation->name(), "roughness_compliance");
  credit_layers(problem, scanner, found);
  const auto layer = std::find_if(found.candidates.begin(), found.candidates.end(), [](const Candidate& c) {
    return c.fit.explanation->name() == "roughness_compliance";
  });
  EXPECT_EQ(layer->score, score);
  ASSERT_NE(layer->where_mended, nullptr);
  EXPECT_EQ(layer->where_mended->explanation->name(), both);
  // Of a layer that fits by its own law no other has such a score.
  const FitProblem by_its_law = layer_on_a_larger_sphere(5 * uN, 1);
  SearchResult alone =
      search_effects(by_its_law, fit_explanation(by_its_law, {}), [](const ModelFit&) { return false; }, {});
  credit_layers(by_its_law, Scanner(by_its_law.samples, by_its_law.experiment, by_its_law.noise, 1), alone);
  for (const Candidate& candidate : alone.candidates) EXPECT_EQ(candidate.where_mended, nullptr);
}

/// Found in blind recordings of rough spheres: a film with a second effect outdid asperities by themselves,
/// and the film was named.
TEST(Members_behaviour, a_film_has_no_score_but_its_own) {
  FitProblem problem = layer_on_a_larger_sphere(5 * uN, 1);
  const std::vector<double> force =
      simulate(test::with(problem.experiment, {{"film", {0.3, 40 * nm}}, {"detector_nonlinearity", {0.03}}}),
               problem.samples);
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; i < force.size(); ++i)
    problem.samples.list[i].response = force[i] + 5 * uN * normal(random);
  problem.thin = problem.samples;
  SearchResult found =
      search_effects(problem, fit_explanation(problem, {}), [](const ModelFit&) { return false; }, {});
  credit_layers(problem, Scanner(problem.samples, problem.experiment, problem.noise, 1), found);
  const auto film = std::find_if(found.candidates.begin(), found.candidates.end(),
                                 [](const Candidate& c) { return c.fit.explanation->name() == "film"; });
  ASSERT_NE(film, found.candidates.end());
  EXPECT_EQ(film->where_mended, nullptr);
}

Candidate candidate_of(const char* effect) {
  Candidate candidate;
  const Experiment e = test::experiment(Motion::normal);
  candidate.fit.explanation =
      std::make_shared<Explanation>(e, completed({}, e), std::vector<const Effect*>{&effect_of(effect)});
  candidate.score = candidate.score_as_stated = 0;
  return candidate;
}

TEST(Members_analytic, odds_of_ten_thousand_are_too_far_behind_of_layers_a_million) {
  const Candidate film = candidate_of("film");
  const auto is_behind = [&](Candidate other, double score, double as_stated) {
    other.score = score, other.score_as_stated = as_stated;
    return is_far_behind(other, film);
  };
  const Candidate tilt = candidate_of("baseline_tilt");
  EXPECT_FALSE(is_behind(tilt, -9.1, 1));
  EXPECT_TRUE(is_behind(tilt, -9.3, 1));
  Candidate asperities = candidate_of("roughness_compliance");
  EXPECT_TRUE(is_behind(asperities, -9.3, -1));
  EXPECT_FALSE(is_behind(asperities, -13.7, 1)) << "ahead if all laws were off by what they state";
  EXPECT_TRUE(is_behind(asperities, -13.9, 1));
  asperities.where_mended = std::make_shared<const ModelFit>();
  EXPECT_TRUE(is_behind(asperities, -9.3, 1)) << "its score is of a set that mends its law";
}

}  // namespace
}  // namespace asperity

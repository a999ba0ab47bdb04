// What laws may be off by, in the intervals of all parameters: against least squares worked out by hand.
#include "diagnosis/choose/law_shifts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/diagnosis/support/assembled_mechanics.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

using test::nm;
using test::uN;

constexpr double of_scale = 0.7, of_form = 1;  // parts of what a law states

/// An approach that effects with these values explain without residual.
struct Explained {
  FitProblem problem;
  ModelFit fit, baseline;

  Explained(Samples samples, Motion mode, const std::vector<const char*>& names,
            const std::vector<double>& values) {
    problem.experiment = test::experiment(mode);
    problem.choice = completed({}, problem.experiment);
    problem.samples = std::move(samples);
    std::vector<const Effect*> effects;
    for (const char* name : names) effects.push_back(&effect_of(name));
    fit.explanation = std::make_shared<Explanation>(problem.experiment, problem.choice, effects);
    fit.values = values;
    fit.held.assign(values.size(), false);
    baseline.explanation =
        std::make_shared<Explanation>(problem.experiment, problem.choice, std::vector<const Effect*>{});
    const auto response = fit.simulate(problem.samples);
    for (std::size_t i = 0; i < response.size(); ++i) problem.samples.list[i].response = response[i];
    problem.noise.sd.assign(response.size(), 10 * uN);
    problem.noise.shared.assign(1, {});
    problem.thin = problem.samples;
  }
  std::vector<double> half_widths() const { return half_widths_by_laws(problem, fit, baseline); }
};

/// Evenly from 0 to `depth`.
Samples approach(double depth, int count) {
  Samples samples;
  for (int i = 0; i < count; ++i) {
    Sample s;
    s.normal_displacement = depth * (i + 0.5) / count;
    s.time = i;
    s.radius = 8.5e-6;
    samples.list.push_back(s);
  }
  test::close_run(samples, false);
  return samples;
}

TEST(LawShifts_analytic, one_law_alone_is_off_by_a_factor_that_its_parameters_take_up) {
  constexpr double pressed = 60 * nm, strength = 1.2e9;
  const Explained layer(approach(pressed, 200), Motion::normal, {"bulk_plasticity"}, {strength});
  const double states = effect_of("bulk_plasticity").description().accuracy;
  ASSERT_EQ(layer.half_widths().size(), 1u);
  EXPECT_NEAR(layer.half_widths()[0], of_scale * states * strength, 1e-9 * strength);
}

/// f = f_Hertz + f0 + b d over d from 0 to D. A factor that grows straight from -sqrt(3) to sqrt(3) in the
/// part of the squares so far is sqrt(3) (2 x - 1) of the constant, x = d/D, and sqrt(3) (2 x^3 - 1) of the
/// tilt. Least squares of a + b x to (2 x - 1) give b = 2, to x (2 x^3 - 1) a = -2/5. Factors that do not
/// vary move nothing but their own law. Along the record as along the size.
TEST(LawShifts_analytic, a_law_moves_the_parameters_of_another_as_least_squares_say) {
  constexpr double depth = 60 * nm, offset = 30 * uN, slope = 400;
  Explained both(approach(depth, 400), Motion::normal, {"baseline_tilt", "normal_zero_offset"},
                 {slope, offset});
  for (const double part : {1.0, 0.25}) {
    both.fit.part_of_bound = part;
    const double states = part * EffectDescription::usual_accuracy,
                 form = of_form * states * std::sqrt(2 * 3.0);
    const auto half = both.half_widths();
    ASSERT_EQ(half.size(), 2u);
    EXPECT_NEAR(half[0], std::hypot(of_scale * states * slope, form * 2 * offset / depth), 2e-3 * half[0]);
    EXPECT_NEAR(half[1], std::hypot(of_scale * states * offset, form * 0.4 * slope * depth), 2e-3 * half[1]);
  }
}

/// On the way back the size falls as it rose, and what grows along the record is odd about the turn: it moves
/// neither, and of a constant the size does not vary.
TEST(LawShifts_analytic, along_the_record_is_not_along_the_size) {
  constexpr double depth = 60 * nm, offset = 30 * uN, slope = 400, states = EffectDescription::usual_accuracy;
  const Explained both(test::approach_and_back(0, depth, 400), Motion::normal,
                       {"baseline_tilt", "normal_zero_offset"}, {slope, offset});
  const auto half = both.half_widths();
  EXPECT_NEAR(half[0], of_scale * states * slope, 2e-3 * half[0]);
  EXPECT_NEAR(half[1], states * std::hypot(of_scale * offset, of_form * std::sqrt(3.0) * 0.4 * slope * depth),
              2e-2 * half[1]);
}

/// A law of the contact may be off by its bound whatever the residuals show, but moves others by no more than
/// they show: in proportion, until data do not tell (a mean square of a quarter, of any part).
TEST(LawShifts_analytic, a_law_of_the_contact_moves_others_as_far_as_residuals_leave_room) {
  constexpr double depth = 60 * nm, ratio = 1.1, slope = 400, states = EffectDescription::usual_accuracy;
  Explained both(approach(depth, 400), Motion::normal, {"effective_radius", "baseline_tilt"}, {ratio, slope});
  both.problem.noise.sd.assign(both.problem.samples.list.size(), 100 * uN);
  const auto moved = [&](double part) {
    both.fit.part_of_bound = part;
    const auto half = both.half_widths();
    EXPECT_GE(half[0], of_scale * states * ratio * (1 - 1e-9)) << part;
    return std::sqrt(half[1] * half[1] - std::pow(of_scale * states * part * slope, 2));
  };
  const double most = moved(1);
  EXPECT_GT(most, 0.01 * slope);
  EXPECT_NEAR(moved(0.5), most, 1e-3 * most);
  EXPECT_NEAR(moved(0.25), 0.5 * most, 0.02 * most);
  EXPECT_NEAR(moved(1.0 / 64), most / 32, 0.05 * most / 32);
}

TEST(LawShifts_analytic, laws_that_state_nothing_move_nothing) {
  Explained both(approach(60 * nm, 100), Motion::normal, {"baseline_tilt", "normal_zero_offset"},
                 {400, 30 * uN});
  both.fit.part_of_bound = 0;
  for (const double half : both.half_widths()) EXPECT_EQ(half, 0);
  const Explained none(approach(60 * nm, 100), Motion::normal, {}, {});
  EXPECT_TRUE(none.half_widths().empty());
}

/// Where the response jumps: the factors of all laws, on each parameter.
TEST(LawShifts_behaviour, parameters_of_laws_that_jump_get_the_factors_of_all) {
  constexpr double force = 20 * uN, slope = 400;
  const Explained jump(approach(60 * nm, 100), Motion::normal, {"adhesion", "baseline_tilt"},
                       {force, 0.5, slope});
  ASSERT_FALSE(jump.fit.explanation->is_smooth());
  const double of_adhesion = effect_of("adhesion").description().accuracy,
               of_tilt = effect_of("baseline_tilt").description().accuracy,
               together = of_scale * std::hypot(of_adhesion, of_tilt);
  const auto half = jump.half_widths();
  EXPECT_NEAR(half[0], together * force, 1e-9 * force);
  EXPECT_NEAR(half.back(), together * slope, 1e-9 * slope);
}

}  // namespace
}  // namespace asperity

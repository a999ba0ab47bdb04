// What laws may be off by, in the intervals of all parameters: against generalised least squares with the
// whole covariance matrix of noise and discrepancy, which the program never forms.
#include "diagnosis/choose/law_shifts.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "core/shear_moduli.h"
#include "diagnosis/choose/law_error.h"
#include "tests/diagnosis/support/assembled_mechanics.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

using test::nm;
using test::uN;

constexpr double of_scale = 0.7, deviation = 0.5, two_sided_95 = 1.959964;
constexpr double states = EffectDescription::usual_accuracy;

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
    baseline.values.assign(
        fit.values.begin(),
        fit.values.begin() + static_cast<std::ptrdiff_t>(baseline.explanation->parameters().size()));
    const auto response = fit.simulate(problem.samples), before = baseline.simulate(problem.samples);
    for (std::size_t i = 0; i < response.size(); ++i) {
      problem.samples.list[i].response = response[i];
      problem.baseline_residual.push_back(response[i] - before[i]);
    }
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

/// What laws that are off by `sizes` of the response, one deviation in each sample, add to the variances of
/// parameters that change it by `changes`: y = J p + m + e of n even samples,
///   cov m = s_i s_j sum_k w_k phi_k(x_i) phi_k(x_j),  phi_0 = 1, phi_k = sqrt(2) cos(pi k x),
///   w_k ~ 1/(1 + (k/4)^2), k = 0 to 12, of sum one,
///   cov e = noise^2 [(1 - share) delta_ij + share memory^|i - j|].
std::vector<double> added_variances(const std::vector<Eigen::VectorXd>& changes, double noise,
                                    const std::vector<Eigen::VectorXd>& sizes,
                                    const SharedNoise& shared = {}) {
  const Eigen::Index n = changes.front().size();
  Eigen::MatrixXd J(n, static_cast<Eigen::Index>(changes.size())), shapes = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t k = 0; k < changes.size(); ++k) J.col(static_cast<Eigen::Index>(k)) = changes[k];
  double weights = 0;
  for (int k = 0; k <= 12; ++k) {
    const double weight = 1 / (1 + k * k / 16.0);
    weights += weight;
    Eigen::VectorXd phi(n);
    for (Eigen::Index i = 0; i < n; ++i)
      phi[i] = k == 0 ? 1 : std::sqrt(2.0) * std::cos(M_PI * k * static_cast<double>(i) / (n - 1.0));
    shapes += weight * phi * phi.transpose();
  }
  Eigen::MatrixXd of_noise(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      of_noise(i, j) = noise * noise *
                       ((i == j ? 1 - shared.share : 0) +
                        shared.share * std::pow(shared.memory, static_cast<double>(std::abs(i - j))));
  Eigen::MatrixXd all = of_noise;
  for (const auto& size : sizes) all += shapes.cwiseProduct(size * size.transpose()) / weights;
  const auto covariance = [&](const Eigen::MatrixXd& of_data) {
    return (J.transpose() * of_data.inverse() * J).inverse().eval();
  };
  const Eigen::VectorXd added = (covariance(all) - covariance(of_noise)).diagonal();
  return {added.begin(), added.end()};
}

/// f = f_Hertz + f0 + b d over d from 0 to D: a law may be off by the largest part of what it changes within
/// a twentieth of the way.
struct StraightLine {
  static constexpr int count = 120;
  static constexpr double depth = 60 * nm, offset = 30 * uN, slope = 400;
  Eigen::VectorXd one = Eigen::VectorXd::Ones(count), way{count}, way_nearby{count};
  StraightLine() {
    for (int i = 0; i < count; ++i) {
      way[i] = depth * (i + 0.5) / count;
      way_nearby[i] = depth * (std::min(count - 1, i + count / 20) + 0.5) / count;
    }
  }
};

TEST(LawShifts_analytic, one_law_alone_is_off_in_its_scale_and_in_its_form) {
  const StraightLine line;
  Explained constant(approach(line.depth, line.count), Motion::normal, {"normal_zero_offset"}, {line.offset});
  for (const double part : {1.0, 0.1}) {
    constant.fit.part_of_bound = part;
    const auto form = added_variances({line.one}, 10 * uN, {part * states * line.offset * line.one});
    ASSERT_EQ(constant.half_widths().size(), 1u);
    const double expected =
        std::hypot(of_scale * part * states * line.offset, two_sided_95 * std::sqrt(form[0]));
    EXPECT_NEAR(constant.half_widths()[0], expected, 1e-6 * expected);
  }
}

TEST(LawShifts_analytic, a_law_moves_parameters_of_others_as_generalised_least_squares_say) {
  const StraightLine line;
  Explained both(approach(line.depth, line.count), Motion::normal, {"baseline_tilt", "normal_zero_offset"},
                 {line.slope, line.offset});
  for (const double noise : {10 * uN, 0.1 * uN})
    for (const double part : {1.0, 0.1}) {
      both.problem.noise.sd.assign(line.count, noise);
      both.fit.part_of_bound = part;
      const double off = part * states;
      const auto form = added_variances({line.way, line.one}, noise,
                                        {off * line.slope * line.way_nearby, off * line.offset * line.one});
      const auto half = both.half_widths();
      ASSERT_EQ(half.size(), 2u);
      const double of_slope = std::hypot(of_scale * off * line.slope, two_sided_95 * std::sqrt(form[0])),
                   of_offset = std::hypot(of_scale * off * line.offset, two_sided_95 * std::sqrt(form[1]));
      EXPECT_NEAR(half[0], of_slope, 1e-5 * of_slope) << noise << " " << part;
      EXPECT_NEAR(half[1], of_offset, 1e-5 * of_offset) << noise << " " << part;
    }
}

/// Noise of which neighbouring samples share a half, as that of amplifiers.
TEST(LawShifts_analytic, noise_that_samples_share_is_in_the_weights) {
  const StraightLine line;
  const SharedNoise shared{0.5, 0.7};
  Explained tilt(approach(line.depth, line.count), Motion::normal, {"baseline_tilt"}, {line.slope});
  tilt.problem.noise.shared.assign(1, shared);
  tilt.problem.noise.sd.assign(line.count, 1 * uN);
  tilt.fit.part_of_bound = 1;
  const std::vector<Eigen::VectorXd> off{states * line.slope * line.way_nearby};
  const double added = added_variances({line.way}, 1 * uN, off, shared)[0],
               if_white = added_variances({line.way}, 1 * uN, off)[0],
               expected = std::hypot(of_scale * states * line.slope, two_sided_95 * std::sqrt(added));
  EXPECT_GT(std::abs(added / if_white - 1), 0.01);
  EXPECT_NEAR(tilt.half_widths()[0], expected, 1e-5 * expected);
}

/// Of a law that is one curve and of one that is another in each run: what each adds by itself.
TEST(LawShifts_analytic, curves_and_runs_that_are_off_add_up) {
  const StraightLine line;
  constexpr double noise = 0.1 * uN, off = 20 * uN;
  const Samples samples = approach(line.depth, line.count);
  Noise of_data;
  of_data.sd.assign(line.count, noise);
  of_data.shared.assign(1, {});
  const LawError error(line.count, off);
  const auto added = [&](std::vector<LawError> of_curves, std::vector<LawError> of_runs) {
    ModelErrors errors;
    errors.of_curves = std::move(of_curves);
    errors.of_laws = std::move(of_runs);
    return LawErrors(samples).added_covariance(samples, of_data, line.way, errors)(0, 0);
  };
  const double expected = added_variances({line.way}, noise, {off * line.one})[0];
  EXPECT_NEAR(added({}, {error}), expected, 1e-6 * expected);
  EXPECT_NEAR(added({error}, {}), expected, 1e-6 * expected);  // driven evenly, so at the same places
  EXPECT_NEAR(added({error}, {error}), 2 * expected, 1e-6 * expected);
  EXPECT_EQ(added({}, {}), 0);
}

/// A drift in a recording whose clock stands still: the data say nothing of it, and as much of the others as
/// without it.
TEST(LawShifts_analytic, a_parameter_that_changes_nothing_leaves_the_others_as_they_are) {
  const StraightLine line;
  Samples at_once = approach(line.depth, line.count);
  for (Sample& sample : at_once.list) sample.time = 0;
  constexpr double rate = 1e-10;
  const Explained alone(at_once, Motion::normal, {"normal_zero_offset"}, {line.offset}),
      beside(at_once, Motion::normal, {"normal_zero_offset", "thermal_drift"}, {line.offset, rate});
  const auto half = beside.half_widths();
  ASSERT_EQ(half.size(), 2u);
  const bool offset_first = beside.fit.explanation->parameters()[0].name == "offset";
  EXPECT_NEAR(half[offset_first ? 0 : 1], alone.half_widths()[0], 1e-9 * alone.half_widths()[0]);
  EXPECT_NEAR(half[offset_first ? 1 : 0], of_scale * states * rate, 1e-9 * rate);
}

/// The bound that a law of the contact states is two deviations, whatever the residuals show; its scale is
/// not theirs to say either.
TEST(LawShifts_analytic, a_law_of_the_contact_is_off_by_what_it_states) {
  const StraightLine line;
  constexpr double ratio = 1.1;
  Explained contact(approach(line.depth, line.count), Motion::normal, {"effective_radius"}, {ratio});
  const double factor = 4.0 / 3 * contact.problem.experiment.hertz().reduced_modulus *
                        std::sqrt(contact.problem.experiment.radius);
  const Eigen::VectorXd hertz = factor * line.way.array().pow(1.5);
  const Eigen::VectorXd nearby = factor * line.way_nearby.array().pow(1.5);
  const auto form = added_variances({hertz / (2 * std::sqrt(ratio))}, 10 * uN,
                                    {deviation * states * (std::sqrt(ratio) - 1) * nearby});
  const double expected = std::hypot(of_scale * states * ratio, two_sided_95 * std::sqrt(form[0]));
  for (const double part : {1.0, 1.0 / 64}) {
    contact.fit.part_of_bound = part;
    EXPECT_NEAR(contact.half_widths()[0], expected, 1e-5 * expected) << part;
  }
}

/// Mindlin (1949), 1/(8 G* a) of the contact at a typical load: a tenth of it, beside what laws are off by.
TEST(LawShifts_analytic, a_compliance_in_series_is_known_to_a_tenth_of_the_contacts_own) {
  constexpr double compliance = 1e-5;
  Explained series(test::lateral_path(1000 * uN, {0, 100 * nm, 0}, 60), Motion::sliding,
                   {"lateral_compliance"}, {0.2, compliance});
  const Experiment& e = series.problem.experiment;
  series.fit.part_of_bound = 0;
  const double own =
      1 / (8 * reduced_shear_modulus(e.particle, e.substrate) * e.hertz().contact_radius(e.typical_force));
  ASSERT_EQ(series.half_widths().size(), 2u);
  EXPECT_NEAR(series.half_widths()[0], 0, 1e-12);
  EXPECT_NEAR(series.half_widths()[1], 0.1 * own, 1e-9 * own);
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

/// A period is what the data show, whatever form repeats: 1 %, where the law of the drops states 30 %.
TEST(LawShifts_behaviour, a_period_is_not_off_by_what_its_law_is) {
  constexpr double amplitude = 5 * uN, period = 20 * nm, friction = 0.2;
  const Explained events(test::lateral_path(1000 * uN, {0, 100 * nm, 0}, 60), Motion::sliding, {"stick_slip"},
                         {friction, amplitude, period});
  const double of_law = of_scale * effect_of("stick_slip").description().accuracy;
  const auto half = events.half_widths();
  ASSERT_EQ(half.size(), 3u);
  EXPECT_NEAR(half[0], of_law * friction, 1e-9 * friction);
  EXPECT_NEAR(half[1], of_law * amplitude, 1e-9 * amplitude);
  EXPECT_NEAR(half[2], 0.01 * period, 1e-9 * period);
}

}  // namespace
}  // namespace asperity

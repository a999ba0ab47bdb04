// Evidence with what the laws may be off by.
#include "diagnosis/choose/law_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

/// Finite elements whose approach is off by a nanometre.
class OffByANanometre : public BranchCorrection {
 public:
  double error() const override { return test::nm; }
};

struct Made {
  Samples samples = test::approach_and_back(0, 1e-8, 200);
  Noise noise;
  std::vector<double> white, error;
  Made() {
    for (std::size_t i = 0; i < 400; ++i)
      samples.list[i].segment = i < 200 ? 0 : 1, samples.list[i].part = i < 200 ? 0 : 1;
    samples.segment_names = {"load", "unload"};
    noise.sd.assign(400, 1.0);
    noise.shared = {{}};
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    for (std::size_t i = 0; i < 400; ++i)
      white.push_back(normal(random)), error.push_back(5);  // a law off by five deviations
  }
  double cost(const std::vector<double>& residual, const std::vector<LawError>& errors) const {
    return LawErrors(samples).cost(samples, noise, residual, {{}, errors}).sum();
  }
};

TEST(LawError_analytic, without_any_the_cost_is_that_of_the_residuals) {
  const Made m;
  double sum = 0;
  for (const double r : m.white) sum += huber_cost(r);
  EXPECT_NEAR(m.cost(m.white, {}), sum, 1e-9);
  EXPECT_NEAR(m.cost(m.white, {LawError(400, 0.0)}), sum, 1e-9);
}

TEST(LawError_behaviour, room_that_is_not_needed_costs_evidence) {
  const Made m;
  EXPECT_GT(m.cost(m.white, {m.error}), m.cost(m.white, {}) + 10);
}

TEST(LawError_behaviour, takes_up_what_varies_slowly_within_it_and_no_more) {
  const Made m;
  auto slow = m.white, fast = m.white, far = m.white;
  for (std::size_t i = 0; i < 400; ++i) {
    slow[i] += 5 * std::sin(static_cast<double>(i) / 60);
    fast[i] += 5 * std::sin(static_cast<double>(i) * 1.3);
    far[i] += 100 * std::sin(static_cast<double>(i) / 60);
  }
  const double noise = m.cost(m.white, {m.error});
  EXPECT_LT(m.cost(slow, {m.error}), noise + 60);
  EXPECT_GT(m.cost(slow, {}), noise + 2000);
  EXPECT_GT(m.cost(fast, {m.error}), noise + 2000);
  EXPECT_GT(m.cost(far, {m.error}), noise + 500);
}

/// One solution is off by the same part everywhere, and not up in one segment and down in the other.
TEST(LawError_behaviour, of_one_solution_is_shared_by_all_segments) {
  const Made m;
  auto same = m.white, opposed = m.white;
  for (std::size_t i = 0; i < 400; ++i) same[i] += 5, opposed[i] += i < 200 ? 5 : -5;
  const auto by_mesh = [&](const std::vector<double>& residual) {
    return LawErrors(m.samples).cost(m.samples, m.noise, residual, {{m.error}, {}}).sum();
  };
  const double noise = by_mesh(m.white);
  EXPECT_LT(by_mesh(same), noise + 10);
  EXPECT_GT(by_mesh(opposed), noise + 1000);
  EXPECT_LT(m.cost(opposed, {m.error}), m.cost(m.white, {m.error}) + 100);
}

/// One curve is off by the same at each place of it, up and down, and its room counts once.
TEST(LawError_behaviour, of_one_curve_is_shared_by_the_way_there_and_back) {
  const Made m;
  auto same = m.white, opposed = m.white;
  for (std::size_t i = 0; i < 400; ++i) {
    const double off = 5 * std::cos(2 * M_PI * m.samples.list[i].normal_displacement / 1e-8);
    same[i] += off, opposed[i] += i < 200 ? off : -off;
  }
  const auto as_curve = [&](const std::vector<double>& residual) {
    ModelErrors errors;
    errors.of_curves = {m.error};
    return LawErrors(m.samples).cost(m.samples, m.noise, residual, errors);
  };
  const double noise = as_curve(m.white).sum();
  EXPECT_LT(as_curve(same).sum(), noise + 30);
  EXPECT_GT(as_curve(opposed).sum(), noise + 1000);
  const double own_in_each =
      LawErrors(m.samples).cost(m.samples, m.noise, m.white, {{}, {m.error}}).log_determinant;
  EXPECT_LT(as_curve(m.white).log_determinant, 0.7 * own_in_each);
  EXPECT_EQ(laws_off_by(0.5, {{}, {}, {}, {}, {m.error}}).of_curves[0][0], 0.5 * m.error[0]);
}

/// A sensor that clips would hide what a mesh is off by, and gain evidence by it.
TEST(LawError_analytic, what_a_mesh_is_off_by_is_not_muted_by_the_sensor) {
  FitProblem problem;
  problem.experiment = test::experiment(Motion::normal);
  problem.choice = completed({}, problem.experiment);
  const auto samples = test::approach_and_back(1e-9, 1e-8, 20);
  const auto fit_of = [&](const std::vector<const Effect*>& effects, const std::vector<double>& values) {
    ModelFit fit;
    fit.explanation = std::make_shared<Explanation>(problem.experiment, problem.choice, effects,
                                                    std::make_shared<OffByANanometre>());
    fit.values = values;
    return fit;
  };
  const Hertz hertz = problem.experiment.hertz();
  const double clipped_at = 0.3 * hertz.force(1e-8);
  const auto plain = mesh_errors(fit_of({}, {}), samples),
             clipped = mesh_errors(fit_of({&effect_of("clipping")}, {clipped_at}), samples);
  ASSERT_EQ(plain.size(), 1u);
  ASSERT_EQ(clipped.size(), 1u);
  for (std::size_t i = 0; i < samples.list.size(); ++i) {
    const double d = samples.list[i].normal_displacement;
    EXPECT_EQ(clipped[0][i], plain[0][i]);
    EXPECT_NEAR(plain[0][i] / (hertz.force(d - test::nm) - hertz.force(d)), 1, 1e-6) << d;
  }
}

/// What every set has is no reason to prefer one that has less of it: only the room of laws counts.
TEST(LawError_analytic, the_determinant_is_that_of_the_laws_beside_the_mesh) {
  const Made m;
  const LawErrors errors(m.samples);
  const auto cost = [&](const std::vector<LawError>& of_laws, const std::vector<LawError>& of_mesh_along) {
    return errors.cost(m.samples, m.noise, m.white, {{}, of_laws, of_mesh_along, {}});
  };
  const double of_both = cost({m.error, m.error}, {}).log_determinant,
               of_one = cost({m.error}, {}).log_determinant;
  EXPECT_GT(of_one, 5);
  EXPECT_EQ(cost({}, {m.error}).log_determinant, 0);
  // Determinants multiply: of law and mesh together over that of the mesh.
  EXPECT_NEAR(cost({m.error}, {m.error}).log_determinant, of_both - of_one, 1e-6 * of_both);
  EXPECT_NEAR(cost({}, {m.error}).of_misfit, cost({m.error}, {}).of_misfit, 1e-9);
}

TEST(LawError_behaviour, surfaces_that_resemble_each_other_are_taken_off_together) {
  // What is off is the small difference of two of nine errors: coefficients of 2.5 and -2.5.
  const Made m;
  const std::size_t n = m.samples.list.size();
  ModelErrors errors;
  errors.of_surfaces.assign(9, LawError(n, 0.0));
  std::vector<double> residual(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double x = static_cast<double>(i) / static_cast<double>(n);
    errors.of_surfaces[0][i] = 1000 * m.noise.sd[i] * (1 + 0.3 * x);
    errors.of_surfaces[1][i] = 1000 * m.noise.sd[i];
    residual[i] = 2.5 * (errors.of_surfaces[0][i] - errors.of_surfaces[1][i]);
  }
  const auto left = LawErrors(m.samples).without_shared_error(m.samples, m.noise, residual, errors);
  for (std::size_t i = 0; i < n; ++i) EXPECT_LT(std::abs(left[i]), 0.5 * m.noise.sd[i]) << i;
}

}  // namespace
}  // namespace asperity

// A case on a generated surface: the recorded one is another realisation, by which nothing may be named.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "core/error.h"
#include "diagnosis/diagnose.h"
#include "diagnosis/mapping/branch_curves.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

using test::nm;
using test::uN;

/// Approach under a force: Hertz and a layer of asperities of this length [m].
double rough_approach(double force, double length) {
  const Hertz smooth = test::experiment(Motion::normal).hertz();
  const double onset = smooth.force(length);
  return smooth.approach(force) + length * std::log1p(force / onset);
}

/// A rough case whose surfaces differ by the length of their layer.
class RoughCase : public ForwardModel {
 public:
  double own = 1.2 * nm;
  bool is_too_large = false;  ///< for half-spaces
  std::vector<double> others;

  SimulatedBodies bodies() const override {
    const Experiment e = test::experiment(Motion::normal);
    SimulatedBodies b{e.particle, e.substrate, e.radius};
    b.is_smooth = false;
    return b;
  }
  std::vector<SolvedResponse> solve(const std::vector<CaseChange>& changes,
                                    const std::vector<LoadingProtocol>& protocols,
                                    const EnoughOfIt&) override {
    if (!changes.empty()) throw WorkError("the steps did not converge");
    std::vector<SolvedResponse> solved;
    for (const auto& protocol : protocols) {
      SolvedResponse r;
      constexpr int steps = 60;
      for (int i = 0; i <= steps; ++i) {
        r.force.push_back(protocol.largest_force * std::pow(static_cast<double>(i) / steps, 2));
        r.displacement.push_back(rough_approach(r.force.back(), own));
      }
      r.peak = steps;
      r.displacement_error = 0.01 * nm;
      solved.push_back(r);
    }
    return solved;
  }
  OtherSurfaces on_other_surfaces(double largest) override {
    if (is_too_large) throw InputError("the contact goes beyond half the Radius");
    OtherSurfaces surfaces;
    for (const double length : others) {
      SurfaceChange change;
      for (int i = 0; i < 8; ++i) {
        const double force = largest * std::pow(2e-3, 1 - i / 7.0);
        change.force.push_back(force);
        change.displacement.push_back(rough_approach(force, length) - rough_approach(force, own));
        if (i > 0) change.displacement.back() -= change.displacement.front();
      }
      change.displacement.front() = 0;
      surfaces.changes.push_back(change);
    }
    surfaces.unseen = 0.3 * nm;
    return surfaces;
  }
  std::vector<SolvedMotion> move(const std::vector<CaseChange>&, const std::vector<MotionProtocol>&,
                                 bool) override {
    throw WorkError("this stand-in does not slide");
  }
};

/// Pressed and released, on a layer of this length, with a spring in series [m/N].
Recording recorded_on(double length, double compliance = 0) {
  Recording r;
  r.mode = Motion::normal;
  r.particle = test::borosilicate();
  r.substrate = test::silicon();
  RecordingTable table;
  table.file = "pressed.csv";
  table.control = {"normal_force"};
  table.response = "normal_displacement";
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0, 0.05 * nm);
  constexpr double largest = 200 * uN;
  for (int i = 1; i <= 300; ++i) {
    const double force = largest * (i <= 150 ? i / 150.0 : (301 - i) / 150.0);
    table.columns["time"].push_back(0.1 * i);
    table.columns["normal_force"].push_back(force);
    table.columns["normal_displacement"].push_back(rough_approach(force, length) + compliance * force +
                                                   noise(random));
    table.segment.push_back(i <= 150 ? "load" : "unload");
  }
  r.tables = {table};
  return r;
}

Diagnosis diagnosed_on(const Recording& recording, RoughCase& simulation) {
  DiagnoseOptions options;
  options.simulation = &simulation;
  return diagnose(recording, options);
}

const std::vector<double> lengths{0.7 * nm,  0.85 * nm, 1.0 * nm,  1.1 * nm,
                                  1.35 * nm, 1.5 * nm,  1.65 * nm, 1.8 * nm};

TEST(OtherSurfaces_behaviour, another_realisation_is_no_mismatch) {
  for (const double recorded : {0.9 * nm, 1.45 * nm}) {
    RoughCase simulation;
    const Recording recording = recorded_on(recorded);
    EXPECT_NE(diagnosed_on(recording, simulation).verdict, Verdict::no_mismatch);
    simulation.others = lengths;
    const Diagnosis d = diagnosed_on(recording, simulation);
    EXPECT_EQ(d.verdict, Verdict::no_mismatch) << d.in_words;
    bool is_said = false;
    for (const auto& remark : d.remarks) is_said |= remark.find("on 8 other seeds") != std::string::npos;
    EXPECT_TRUE(is_said);
  }
}

TEST(OtherSurfaces_behaviour, what_no_realisation_shows_is_still_named) {
  RoughCase simulation;
  simulation.others = lengths;
  const double compliance = 20 * nm / (200 * uN);
  const Diagnosis d = diagnosed_on(recorded_on(1.3 * nm, compliance), simulation);
  ASSERT_EQ(d.left_out.size(), 1u) << d.in_words;
  EXPECT_EQ(d.left_out[0].id, "instrument_compliance") << d.in_words;
  const auto& found = d.left_out[0].parameters[0];
  EXPECT_LT(found.low, compliance);
  EXPECT_GT(found.high, compliance);
  // The interval holds what another surface would make of it.
  simulation.others.clear();
  const Diagnosis alone = diagnosed_on(recorded_on(1.2 * nm, compliance), simulation);
  ASSERT_EQ(alone.left_out.size(), 1u) << alone.in_words;
  const auto& narrow = alone.left_out[0].parameters[0];
  EXPECT_GT(found.high - found.low, narrow.high - narrow.low);
}

TEST(OtherSurfaces_behaviour, a_compliance_is_named_on_each_of_five_other_surfaces) {
  // Five nanometres of it at the largest load, where surfaces differ by three.
  const double compliance = 5 * nm / (200 * uN);
  int named = 0, held = 0;
  std::string answers;
  for (int i = 0; i < 5; ++i) {
    RoughCase simulation;
    simulation.others = lengths;
    const Diagnosis d = diagnosed_on(recorded_on((0.75 + 0.2 * i) * nm, compliance), simulation);
    answers += d.in_words + "\n";
    if (d.left_out.size() != 1u || d.left_out[0].id != "instrument_compliance") continue;
    ++named;
    const auto& found = d.left_out[0].parameters[0];
    held += found.low <= compliance && compliance <= found.high;
  }
  EXPECT_EQ(named, 5) << answers;
  EXPECT_EQ(held, named);
}

TEST(OtherSurfaces_behaviour, surfaces_that_are_all_alike_leave_the_zero_alone) {
  RoughCase simulation;
  simulation.others = {simulation.own, simulation.own};
  const Diagnosis d = diagnosed_on(recorded_on(simulation.own), simulation);
  EXPECT_EQ(d.verdict, Verdict::no_mismatch) << d.in_words;
  EXPECT_LT(d.baseline.chi2_reduced, 1.3);
}

TEST(OtherSurfaces_behaviour, where_half_spaces_do_not_solve_it_the_answer_says_so) {
  RoughCase simulation;
  simulation.is_too_large = true;
  const Diagnosis d = diagnosed_on(recorded_on(simulation.own), simulation);
  EXPECT_EQ(d.verdict, Verdict::no_mismatch) << d.in_words;
  bool is_said = false;
  for (const auto& remark : d.remarks)
    is_said |= remark.find("beyond half the Radius): what is named may be the surface") != std::string::npos;
  EXPECT_TRUE(is_said);
}

TEST(OtherSurfaces_analytic, errors_have_the_second_moments_of_the_changes) {
  OtherSurfaces surfaces;
  surfaces.changes = {{{1, 8}, {1e-9, 2e-9}}, {{1, 8}, {-3e-9, 4e-9}}, {{1, 8}, {2e-9, -1e-9}}};
  surfaces.unseen = 5e-10;
  const auto all = surface_errors_of(surfaces);
  const auto& errors = all.each;
  ASSERT_EQ(errors.size(), 3u);  // two forces: two ways in which three surfaces differ, and the zero
  const auto moment = [&](double a, double b) {
    return errors[0](a) * errors[0](b) + errors[1](a) * errors[1](b);
  };
  EXPECT_NEAR(moment(1, 1), (1 + 9 + 4) / 3.0 * 1e-18, 1e-27);
  EXPECT_NEAR(moment(8, 8), (4 + 16 + 1) / 3.0 * 1e-18, 1e-27);
  EXPECT_NEAR(moment(1, 8), (2 - 12 - 2) / 3.0 * 1e-18, 1e-27);
  for (const std::size_t k : {0u, 1u}) {
    EXPECT_EQ(errors[k](0), 0);
    // Halfway in f^(2/3).
    EXPECT_NEAR(errors[k](std::pow(2.5, 1.5)), 0.5 * (errors[k](1) + errors[k](8)), 1e-18);
  }
  EXPECT_EQ(errors[2](0), 5e-10);
  EXPECT_EQ(errors[2](8), 5e-10);
  EXPECT_TRUE(surface_errors_of({}).each.empty());
}

TEST(OtherSurfaces_analytic, changes_are_smooth_between_their_forces) {
  // A change that grows with the square of x = f^(2/3): straight lines between would be off by h^2/4.
  OtherSurfaces surfaces;
  SurfaceChange change;
  constexpr double step = 0.5;
  for (int i = 1; i <= 8; ++i) {
    change.force.push_back(std::pow(step * i, 1.5));
    change.displacement.push_back(step * i * step * i * nm);
  }
  surfaces.changes = {change};
  const auto errors = surface_errors_of(surfaces).each;
  ASSERT_EQ(errors.size(), 2u);
  for (int i = 2; i < 7; ++i) {
    const double x = step * (i + 0.5);
    EXPECT_NEAR(std::abs(errors[0](std::pow(x, 1.5))), x * x * nm, 0.1 * step * step / 4 * nm) << x;
  }
}

/// Two forces have straight lines between them, six a cubic.
TEST(OtherSurfaces_analytic, changes_together_are_their_sum_under_any_force) {
  for (const int forces : {2, 6}) {
    OtherSurfaces surfaces;
    surfaces.unseen = 0.3 * nm;
    for (int k = 0; k < 4; ++k) {
      SurfaceChange change;
      for (int i = 1; i <= forces; ++i) {
        change.force.push_back(i * i * uN);
        change.displacement.push_back(i == 1 ? 0.0 : std::sin(1.7 * i * (k + 1)) * nm);
      }
      surfaces.changes.push_back(change);
    }
    const SurfaceErrors errors = surface_errors_of(surfaces);
    std::vector<double> factors;
    for (std::size_t k = 0; k < errors.each.size(); ++k)
      factors.push_back(k == 1 ? 0.0 : 0.7 - 0.4 * static_cast<double>(k));
    const auto together = errors.together(factors);
    for (double force = -2 * uN; force < 1.2 * forces * forces * uN; force += 0.37 * uN) {
      double sum = 0;
      for (std::size_t k = 0; k < factors.size(); ++k) sum += factors[k] * errors.each[k](force);
      EXPECT_NEAR(together(force) / nm, sum / nm, 1e-12) << force << " of " << forces;
    }
  }
}

}  // namespace
}  // namespace asperity

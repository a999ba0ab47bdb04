// What no entry of a case says, around its solution: bodies that relax, and bursts. The truth of relaxing
// bodies is a rough contact of half-spaces followed in time by boundary elements, which knows nothing of
// hereditary integrals over a force.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>
#include <vector>

#include "core/error.h"
#include "diagnosis/catalogue/effect.h"
#include "diagnosis/diagnose.h"
#include "diagnosis/mechanics/mechanics.h"
#include "half_space/normal_contact.h"
#include "tests/diagnosis/support/made_recording.h"
#include "tests/support/verification.h"

namespace asperity {
namespace {

using half_space::Field;
using half_space::Grid;
using test::nm;
using test::Verified;

/// Nearly incompressible: E* of the pair relaxes in one exponential nearly, as these half-spaces do.
const ElasticBody relaxing_polymer{3e9, 0.49}, stiff_plate{179e9, 0.25};
constexpr double of_sphere = 8.5e-6;

/// Undeformed gap of a sphere and a plane with 3 nm RMS of waves of 0.2 to 0.6 um, 0 where they touch first.
Field rough_gap(const Grid& grid) {
  constexpr int waves = 40;
  constexpr double rms = 3 * nm;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(0, 1);
  Field gap(grid.cells());
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      gap[static_cast<std::size_t>(j * grid.nx + i)] =
          (grid.x(i) * grid.x(i) + grid.y(j) * grid.y(j)) / (2 * of_sphere);
  for (int w = 0; w < waves; ++w) {
    const double q = 2 * M_PI / (0.2e-6 + 0.4e-6 * any(random)), along = 2 * M_PI * any(random),
                 phase = 2 * M_PI * any(random);
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i)
        gap[static_cast<std::size_t>(j * grid.nx + i)] +=
            rms * std::sqrt(2.0 / waves) *
            std::cos(q * (grid.x(i) * std::cos(along) + grid.y(j) * std::sin(along)) + phase);
  }
  const double first = *std::min_element(gap.begin(), gap.end());
  for (double& g : gap) g -= first;
  return gap;
}

/// Half-spaces that are elastic, or relax from E* to (1 - share) E* with a time constant: in each cell, under
/// pressures that change evenly over a step,
///   u = v + q,  tau_c dq/dt = c v - q,  c = g/(1 - g),  tau_c = tau/(1 - g),
/// v: displacement of the elastic bodies (standard linear solid, under stress).
class RoughHalfSpaces {
 public:
  explicit RoughHalfSpaces(double share = 0, double time_constant = 1)
      : gap_(rough_gap(grid_)),
        part_(share / (1 - share)),
        time_constant_(time_constant / (1 - share)),
        elastic_(grid_.cells(), 0.0),
        delayed_(grid_.cells(), 0.0) {}

  /// Force [N] at an approach from first touch [m], a step of that duration after the last.
  double force(double approach, double time_step) {
    const double t = time_step / time_constant_, left = std::exp(-t), mean = t > 1e-9 ? (1 - left) / t : 1;
    const double at_once = 1 + part_ * (1 - mean);
    Field gap = gap_, remembered(grid_.cells());
    for (std::size_t k = 0; k < gap.size(); ++k) {
      remembered[k] = delayed_[k] * left + part_ * (mean - left) * elastic_[k];
      gap[k] += remembered[k];
    }
    double force = 0;
    Field opened(grid_.cells(), 0.0);
    if (*std::min_element(gap.begin(), gap.end()) < approach) {
      const half_space::NormalContact contact(grid_, half_space::Boundary::free,
                                              reduced_modulus(relaxing_polymer, stiff_plate) / at_once, gap);
      const auto solution = contact.at_approach(approach);
      force = solution.force;
      contact.compliance().apply(solution.pressure, opened);
    }
    for (std::size_t k = 0; k < gap.size(); ++k) {
      const double before = elastic_[k];
      elastic_[k] = opened[k] / at_once;
      delayed_[k] = delayed_[k] * left + part_ * (elastic_[k] * (1 - mean) + before * (mean - left));
    }
    return force;
  }

 private:
  Grid grid_ = half_space::square_grid(0.95e-6, 64);
  Field gap_;
  double part_, time_constant_;
  Field elastic_, delayed_;  ///< v and q [m]
};

/// The rough contact, elastic, as a solver states it; its polymer relaxes by `relaxation`.
class RoughCase : public ForwardModel {
 public:
  explicit RoughCase(const RelaxingPart& relaxation = {}) : relaxation_(relaxation) {}
  SimulatedBodies bodies() const override {
    SimulatedBodies b{relaxing_polymer, stiff_plate, of_sphere};
    b.is_smooth = false;
    b.particle_relaxation = relaxation_;
    return b;
  }
  std::vector<SolvedResponse> solve(const std::vector<CaseChange>& changes,
                                    const std::vector<LoadingProtocol>& protocols,
                                    const EnoughOfIt&) override {
    if (!changes.empty()) throw WorkError("these half-spaces are elastic");
    SolvedResponse r;
    r.displacement = {0};
    r.force = {0};
    for (double d = nm; r.force.back() < protocols.front().largest_force; d += nm) {
      r.displacement.push_back(d);
      r.force.push_back(RoughHalfSpaces().force(d, 0));
    }
    r.peak = r.force.size() - 1;
    r.displacement_error = 0.02 * nm;
    r.source = "half-spaces";
    return std::vector<SolvedResponse>(protocols.size(), r);
  }
  std::vector<SolvedMotion> move(const std::vector<CaseChange>&, const std::vector<MotionProtocol>&,
                                 bool) override {
    throw std::logic_error("it does not slide");
  }

 private:
  RelaxingPart relaxation_;
};

constexpr int samples_up = 60;
constexpr double depth = 40 * nm;
double depth_of(int sample) {
  return depth * (sample <= samples_up ? sample : 2 * samples_up - sample) / samples_up;
}

/// Pressed and drawn back in each of these times [s].
Recording recorded(const std::vector<double>& durations, const std::function<double(double, double)>& force,
                   const std::function<void()>& forget, double noise) {
  Recording r;
  r.mode = Motion::normal;
  r.particle = {"polymer",
                relaxing_polymer.youngs_modulus,
                relaxing_polymer.poisson_ratio,
                of_sphere,
                3 * nm,
                RecordedBody::unknown};
  r.substrate = test::silicon();
  RecordingTable table;
  table.file = "pressed.csv";
  table.control = {"normal_displacement"};
  table.response = "normal_force";
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  for (std::size_t run = 0; run < durations.size(); ++run) {
    forget();
    const double step = durations[run] / (2 * samples_up);
    for (int i = 0; i <= 2 * samples_up; ++i) {
      table.columns["run"].push_back(static_cast<double>(run + 1));
      table.columns["time"].push_back(step * i);
      table.columns["normal_displacement"].push_back(depth_of(i));
      table.columns["normal_force"].push_back(force(depth_of(i), i == 0 ? 0 : step) + noise * normal(random));
      table.segment.push_back(i <= samples_up ? "load" : "unload");
    }
  }
  r.tables = {table};
  return r;
}

Diagnosis by_rough_case(const Recording& recording, const RelaxingPart& relaxation = {}) {
  RoughCase simulation(relaxation);
  DiagnoseOptions options;
  options.simulation = &simulation;
  return diagnose(recording, options);
}

/// Where the rough contact is as large as a smooth one by Hertz, both relax alike: Lee & Radok's integral is
/// exact as it grows, and Ting's up to what the depths that they need differ by as it shrinks.
TEST(RelaxingRoughContact_analytic, the_integral_over_the_elastic_force_is_that_of_boundary_elements) {
  const double parameters[] = {0.5, 10}, step = 0.5;
  Mechanics m;
  m.geometry = {reduced_modulus(relaxing_polymer, stiff_plate), of_sphere};
  effect_of("viscoelasticity").assemble(m, parameters);
  const auto law = m.normal.contact->clone();
  RoughHalfSpaces relaxing(parameters[0], parameters[1]);
  double largest = 0, growing = 0, shrinking = 0;
  for (int i = 1; i < 2 * samples_up; ++i) {
    const double smooth_depth = m.geometry.approach(RoughHalfSpaces().force(depth_of(i), 0));
    law->begin_step(step);
    const double by_law = law->force(smooth_depth),
                 off = std::abs(by_law - relaxing.force(depth_of(i), step));
    law->accept(smooth_depth);
    largest = std::max(largest, by_law);
    double& worst = i <= samples_up ? growing : shrinking;
    worst = std::max(worst, off);
  }
  const auto verified = [](const std::string& what) {
    return Verified{"Half-space", "rough contact of relaxing bodies, force over the largest: " + what,
                    "boundary elements in time"};
  };
  EXPECT_TRUE(verified("Lee & Radok's integral as it grows").below(growing / largest, 1e-3));
  EXPECT_TRUE(verified("Ting's as it shrinks").below(shrinking / largest, 0.01));
}

/// Pressed again, before it opened and after: the law takes up where it was largest, or as if nothing had
/// been.
TEST(RelaxingRoughContact_analytic, pressed_again_is_that_of_boundary_elements_nearly) {
  const double parameters[] = {0.5, 10}, step = 0.5;
  Mechanics m;
  m.geometry = {reduced_modulus(relaxing_polymer, stiff_plate), of_sphere};
  effect_of("viscoelasticity").assemble(m, parameters);
  const auto law = m.normal.contact->clone();
  RoughHalfSpaces relaxing(parameters[0], parameters[1]);
  double largest = 0, before_opening = 0, after_opening = 0, at = 0;
  const auto go_to = [&](double to, double& off) {
    constexpr double stride = nm;
    while (std::abs(to - at) > 0.5 * stride) {
      at += to > at ? stride : -stride;
      const double elastic = RoughHalfSpaces().force(at, 0), smooth_depth = m.geometry.approach(elastic);
      law->begin_step(step);
      const double by_law = law->force(smooth_depth);
      law->accept(smooth_depth);
      largest = std::max(largest, by_law);
      off = std::max(off, std::abs(by_law - relaxing.force(at, step)));
    }
  };
  go_to(depth, before_opening);
  go_to(0.6 * depth, before_opening);
  go_to(1.1 * depth, before_opening);
  go_to(0, before_opening);
  go_to(depth, after_opening);
  EXPECT_LT(before_opening / largest, 0.02);
  EXPECT_LT(after_opening / largest, 0.12);
}

/// E* of the pair whose polymer has lost a share of its shear modulus and none of its bulk modulus [Pa].
double relaxed_modulus(double share) {
  const ElasticBody& fast = relaxing_polymer;
  const double shear = (1 - share) * fast.youngs_modulus / (2 * (1 + fast.poisson_ratio)),
               bulk = fast.youngs_modulus / (3 * (1 - 2 * fast.poisson_ratio)),
               youngs = 9 * bulk * shear / (3 * bulk + shear);
  return reduced_modulus({youngs, youngs / (2 * shear) - 1}, stiff_plate);
}

/// A body that relaxes slowly lags behind its load by what its entries say: to first order in the rate E* is
/// larger by its derivative with the shear modulus, times the lag of that.
TEST(SolvedInTime_analytic, the_entries_of_a_relaxing_body_leave_the_pair_its_end_and_its_lag) {
  Experiment e = test::experiment(Motion::normal);
  e.particle = relaxing_polymer, e.substrate = stiff_plate;
  e.by_finite_elements = true, e.duration = 6;
  for (const double share : {0.05, 0.4, 0.9}) {
    constexpr double time_constant = 3;
    const std::vector<DiagnosedParameter> found{
        {"share", "", share, 0.9 * share, std::min(0.99, 1.1 * share)},
        {"time_constant", "s", time_constant, 2, 4}};
    const auto entries = effect_of("viscoelasticity").corrected_entries(e, found);
    ASSERT_EQ(entries.size(), 3u);
    const double of_body = entries[0].value, step = 1e-5;
    EXPECT_NEAR(relaxed_modulus(of_body) / relaxed_modulus(0), 1 - share, 1e-6);
    const double by_share = (relaxed_modulus(of_body - step) - relaxed_modulus(of_body + step)) / (2 * step);
    EXPECT_NEAR(by_share * of_body * entries[1].value / (share * time_constant * relaxed_modulus(0)), 1,
                1e-3);
    EXPECT_LT(entries[0].low, of_body);
    EXPECT_GT(entries[1].high, entries[1].value);
    EXPECT_EQ(entries[2].value, 3);
  }
}

/// E* relaxes by a share of it; pressed in two times, 0.5 % noise.
Recording recorded_of_relaxing(double share, double time_constant) {
  RoughHalfSpaces contact(share, time_constant);
  const double largest = RoughHalfSpaces().force(depth, 0);
  return recorded(
      {4, 40}, [&](double d, double step) { return contact.force(d, step); },
      [&] { contact = RoughHalfSpaces(share, time_constant); }, 0.005 * largest);
}

TEST(SolvedInTime_behaviour, a_relaxing_body_is_named_around_the_solution_of_a_rough_case) {
  constexpr double share = 0.5, time_constant = 8;
  const Diagnosis d = by_rough_case(recorded_of_relaxing(share, time_constant));
  EXPECT_EQ(d.verdict, Verdict::explained) << d.in_words;
  ASSERT_EQ(d.left_out.size(), 1u) << d.in_words;
  EXPECT_EQ(d.left_out[0].id, "viscoelasticity");
  EXPECT_EQ(d.left_out[0].form, "reduced law that changes the normal force that was solved");
  const auto& entries = d.left_out[0].case_entries;
  ASSERT_EQ(entries.size(), 3u);
  EXPECT_EQ(entries[0].entry, "Particle/Relaxing share");
  EXPECT_EQ(entries[1].entry, "Particle/Relaxation time");
  EXPECT_EQ(entries[2].entry, "Experiment/Load time");
  EXPECT_DOUBLE_EQ(entries[2].value, 20);  // of the longest run
  EXPECT_NEAR(relaxed_modulus(entries[0].value) / relaxed_modulus(0) / (1 - share), 1, 0.05);
  for (const auto& entry : {entries[0], entries[1]}) {
    EXPECT_LT(entry.low, entry.value);
    EXPECT_GT(entry.high, entry.value);
  }
  for (const auto& p : d.left_out[0].parameters) {
    const double truth = p.name == "share" ? share : time_constant;
    EXPECT_LT(p.low, truth) << p.name;
    EXPECT_GT(p.high, truth) << p.name;
    EXPECT_NEAR(p.value / truth, 1, 0.1) << p.name;
  }
}

TEST(SolvedInTime_behaviour, a_case_that_relaxes_as_the_recorded_body_leaves_nothing_out) {
  const RelaxingPart of_pair{0.5, 8}, of_polymer = relaxing_shear(relaxing_polymer, of_pair, stiff_plate);
  const Recording recording = recorded_of_relaxing(of_pair.share, of_pair.time);
  const Diagnosis same = by_rough_case(recording, of_polymer);
  EXPECT_EQ(same.verdict, Verdict::no_mismatch) << same.in_words;
  const Diagnosis slower = by_rough_case(recording, {of_polymer.share, 4 * of_polymer.time});
  EXPECT_EQ(slower.verdict, Verdict::explained) << slower.in_words;
  ASSERT_EQ(slower.left_out.size(), 1u) << slower.in_words;
  EXPECT_EQ(slower.left_out[0].id, "viscoelasticity");
  EXPECT_NEAR(slower.left_out[0].parameters[1].value / of_pair.time, 1, 0.1);
  const auto tried_not =
      std::find_if(slower.not_tried.begin(), slower.not_tried.end(),
                   [](const auto& untried) { return untried.effect == "bulk_plasticity"; });
  ASSERT_NE(tried_not, slower.not_tried.end());
  EXPECT_EQ(tried_not->why, "a body of the case relaxes, and its law is one of bodies that do not");
}

TEST(SolvedInTime_behaviour, a_case_that_relaxes_needs_the_times_of_the_recording) {
  Recording recording = recorded_of_relaxing(0.5, 8);
  recording.tables[0].columns.erase("time");
  try {
    by_rough_case(recording, {0.5, 8});
    FAIL() << "it was taken";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(),
                 "a body of the case relaxes with time, and the recording has no column time; record "
                 "it, or leave out Relaxing share and Relaxation time");
  }
}

TEST(SolvedInTime_behaviour, a_burst_is_named_in_series_with_the_solution_of_a_rough_case) {
  constexpr double jump = 4 * nm, threshold = 0.45;
  const double largest = RoughHalfSpaces().force(depth, 0);
  bool has_burst = false;
  const Recording recording = recorded(
      {10},
      [&](double d, double) {
        const auto elastic = [](double at) { return at > 0 ? RoughHalfSpaces().force(at, 0) : 0.0; };
        has_burst = has_burst || elastic(d) > threshold * largest;
        return elastic(d - (has_burst ? jump : 0));
      },
      [&] { has_burst = false; }, 0.004 * largest);
  const Diagnosis d = by_rough_case(recording);
  EXPECT_EQ(d.verdict, Verdict::explained) << d.in_words;
  ASSERT_EQ(d.left_out.size(), 1u) << d.in_words;
  EXPECT_EQ(d.left_out[0].id, "pop_in");
  EXPECT_EQ(d.left_out[0].form, "reduced law in series with the solution");
  EXPECT_NEAR(d.left_out[0].parameters[0].value / jump, 1, 0.05);
}

TEST(SolvedInTime_behaviour, a_case_that_yields_or_attracts_has_no_relaxing_form_and_says_why) {
  Experiment e = test::experiment(Motion::normal);
  const Effect& relaxing = effect_of("viscoelasticity");
  e.by_finite_elements = true;
  EXPECT_EQ(relaxing.enters_by(e), EntersBy::on_force);
  EXPECT_EQ(relaxing.why_not_by_finite_elements(e), "");
  Experiment yields = e, attracts = e;
  yields.substrate_yield = 1e9;
  attracts.case_work_of_adhesion = 0.05;
  for (const Experiment& other : {yields, attracts}) {
    EXPECT_EQ(relaxing.enters_by(other), EntersBy::reduced_law_only);
    EXPECT_NE(relaxing.why_not_by_finite_elements(other), "");
  }
}

}  // namespace
}  // namespace asperity

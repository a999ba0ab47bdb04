// Diagnoses whose simulation is solved anew with attraction: a stand-in for finite elements after Maugis
// (1992), where the catalogue's reduced law is a fit to that solution.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "core/error.h"
#include "dem_compare/laws/maugis_dugdale.h"
#include "diagnosis/diagnose.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

using test::nm;

constexpr double sphere_radius = 8.5e-6;
const ElasticBody sphere{71e9, 0.17}, plane{179e9, 0.25};

double modulus() { return reduced_modulus(sphere, plane); }

class AttractingStandIn : public ForwardModel {
 public:
  int attracting = 0;
  double case_spacing = 0, least_cells_over_zone = std::numeric_limits<double>::infinity();

  SimulatedBodies bodies() const override {
    SimulatedBodies bodies{sphere, plane, sphere_radius};
    bodies.spacing = case_spacing;
    return bodies;
  }

  std::vector<SolvedResponse> solve(const std::vector<CaseChange>& changes,
                                    const std::vector<LoadingProtocol>& protocols,
                                    const EnoughOfIt&) override {
    double work = 0, range = 0, of_radius = sphere_radius, spacing = case_spacing;
    for (const auto& change : changes) {
      if (change.entry == "Interface/Work of adhesion") work = change.value;
      if (change.entry == "Interface/Adhesion range") range = change.value;
      if (change.entry == "Mesh/Interface spacing") spacing = change.value;
      if (change.entry == "Particle/Radius") of_radius = change.value;
      if (change.entry == "Particle/Yield stress") throw WorkError("this stand-in does not yield");
    }
    // Maugis' zone in the limit of Johnson, Kendall & Roberts (1992).
    if (work > 0)
      least_cells_over_zone =
          std::min(least_cells_over_zone, M_PI * modulus() * range * range / (4 * work) / spacing);
    std::vector<SolvedResponse> responses;
    for (const auto& protocol : protocols)
      responses.push_back(work > 0 ? attracted(protocol, {modulus(), of_radius, work, work / range})
                                   : pressed(protocol, of_radius));
    return responses;
  }

  std::vector<SolvedSlide> slide(const std::vector<CaseChange>&, const std::vector<SlidingProtocol>&,
                                 bool) override {
    throw WorkError("this stand-in does not slide");
  }

 private:
  static SolvedResponse pressed(const LoadingProtocol& protocol, double of_radius) {
    const Hertz hertz{modulus(), of_radius};
    SolvedResponse r;
    constexpr int steps = 40;
    for (int i = 0; i <= steps; ++i) {
      r.force.push_back(protocol.largest_force * i / steps);
      r.displacement.push_back(hertz.approach(r.force.back()));
    }
    r.peak = steps;
    r.displacement_error = 0.02 * nm;
    return r;
  }
  SolvedResponse attracted(const LoadingProtocol& protocol, const MaugisDugdale& law) {
    ++attracting;
    EXPECT_GT(protocol.approach, 0);
    SolvedResponse r;
    constexpr int steps = 60;
    NormalState state;
    const auto go = [&](double approach) {
      state = law.advance(state, approach);
      r.displacement.push_back(approach);
      r.force.push_back(state.force);
    };
    for (int i = 1; i <= steps; ++i) go(protocol.approach * i / steps);
    r.peak = steps - 1;
    for (int i = steps - 1; protocol.unloads && i >= 0; --i)
      go(-protocol.retract + (protocol.approach + protocol.retract) * i / steps);
    r.displacement_error = 0.02 * nm;
    return r;
  }
};

/// Pressed to a depth, back, and pulled off.
Recording pulled(const MaugisDugdale& law, double depth, double noise) {
  Recording r;
  r.mode = Motion::normal;
  r.particle = test::borosilicate();
  r.substrate = test::silicon();
  RecordingTable table;
  table.file = "pulled.csv";
  table.control = {"normal_displacement"};
  table.response = "normal_force";
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  NormalState state;
  const double back = 4 * nm;
  for (int i = 0; i <= 300; ++i) {
    const double d = -back + (depth + back) * (i <= 150 ? i / 150.0 : (300 - i) / 150.0);
    if (law.work_of_adhesion > 0) state = law.advance(state, d);
    const double force =
        law.work_of_adhesion > 0 ? state.force : Hertz{law.reduced_modulus, law.radius}.force(d);
    table.columns["time"].push_back(0.1 * i);
    table.columns["normal_displacement"].push_back(d);
    table.columns["normal_force"].push_back(force + noise * normal(random));
    table.segment.push_back(i <= 150 ? "load" : "unload");
  }
  r.tables = {table};
  return r;
}

Diagnosis diagnosed(const Recording& recording, ForwardModel& simulation) {
  DiagnoseOptions options;
  options.simulation = &simulation;
  return diagnose(recording, options);
}

TEST(SolvedAttraction_analytic, work_of_adhesion_and_range_are_those_of_Maugis_solution) {
  const double work = 0.3, stress = 2.5e8;
  const MaugisDugdale truth{modulus(), sphere_radius, work, stress};
  const double largest = truth.advance({}, 10 * nm).force;
  AttractingStandIn simulation;
  const Diagnosis d = diagnosed(pulled(truth, 10 * nm, 0.003 * largest), simulation);
  EXPECT_EQ(d.verdict, Verdict::explained) << d.in_words;
  ASSERT_EQ(d.left_out.size(), 1u) << d.in_words;
  EXPECT_EQ(d.left_out[0].id, "adhesion");
  EXPECT_GE(simulation.attracting, 2);
  ASSERT_EQ(d.corrected().size(), 2u);
  const CorrectedEntry found = d.corrected()[0];
  EXPECT_EQ(found.entry, "Interface/Work of adhesion");
  EXPECT_NEAR(found.value / work, 1, 0.03);
  EXPECT_LT(found.low, work);
  EXPECT_GT(found.high, work);
  EXPECT_EQ(d.corrected()[1].entry, "Interface/Adhesion range");
  // What these data hardly determine is not said to be known.
  EXPECT_LT(d.corrected()[1].low, work / stress);
  EXPECT_GT(d.corrected()[1].high, work / stress);
}

TEST(SolvedAttraction_analytic, attraction_of_a_short_range_is_solved_on_meshes_that_resolve_its_zone) {
  const double work = 0.2, range = 0.2 * nm;
  const MaugisDugdale truth{modulus(), sphere_radius, work, work / range};
  const double largest = truth.advance({}, 6 * nm).force;
  AttractingStandIn simulation;
  simulation.case_spacing = 20 * nm;
  const Diagnosis d = diagnosed(pulled(truth, 6 * nm, 0.005 * largest), simulation);
  EXPECT_EQ(d.verdict, Verdict::explained) << d.in_words;
  ASSERT_EQ(d.left_out.size(), 1u) << d.in_words;
  EXPECT_EQ(d.left_out[0].id, "adhesion");
  EXPECT_GE(simulation.least_cells_over_zone, 3);
  ASSERT_EQ(d.corrected().size(), 3u);
  const CorrectedEntry of_work = d.corrected()[0], of_range = d.corrected()[1], mesh = d.corrected()[2];
  EXPECT_NEAR(of_work.value / work, 1, 0.05);
  EXPECT_LT(of_range.low, range);
  EXPECT_GT(of_range.high, range);
  EXPECT_EQ(mesh.entry, "Mesh/Interface spacing");
  EXPECT_LT(mesh.value, 20 * nm);
  EXPECT_GT(mesh.value, 4 * nm);  // no finer than a workstation solves in minutes
}

TEST(SolvedAttraction_analytic, a_contact_without_attraction_gets_none) {
  const MaugisDugdale none{modulus(), sphere_radius, 0, 0};
  AttractingStandIn simulation;
  const Diagnosis d =
      diagnosed(pulled(none, 10 * nm, 0.003 * Hertz{modulus(), sphere_radius}.force(10 * nm)), simulation);
  EXPECT_EQ(d.verdict, Verdict::no_mismatch) << d.in_words;
  EXPECT_EQ(simulation.attracting, 0);
}

}  // namespace
}  // namespace asperity

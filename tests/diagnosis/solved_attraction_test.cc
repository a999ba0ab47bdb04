// Diagnoses whose simulation is solved anew with attraction: a stand-in for finite elements after Maugis
// (1992), where the catalogue's reduced law is a fit to that solution.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "core/csv.h"
#include "core/error.h"
#include "core/root.h"
#include "dem_compare/laws/maugis_dugdale.h"
#include "dem_compare/laws/pinned_dugdale.h"
#include "diagnosis/catalogue/effect.h"
#include "diagnosis/challenge/challenge_matrix.h"
#include "diagnosis/conceal/normal_truth.h"
#include "diagnosis/diagnose.h"
#include "diagnosis/mechanics/attraction_in_case.h"
#include "tests/diagnosis/support/made_recording.h"
#include "tests/support/verification.h"

namespace asperity {
namespace {

using test::nm;

constexpr double sphere_radius = 8.5e-6;
const ElasticBody sphere{71e9, 0.17}, plane{179e9, 0.25};

double modulus() { return reduced_modulus(sphere, plane); }

class AttractingStandIn : public ForwardModel {
 public:
  int attracting = 0;
  double own_work = 0, own_opening = 0, own_range = 0;  ///< of the case
  bool keeps_edge = false;  ///< of two works: as finite elements do (PinnedDugdale), and no flat punch
  double mesh_pulls_more = 0, stated_of_pull_off = 0;  ///< parts of the pull-off force
  double give = 1;  ///< its modulus over that of smooth bodies, as rough ones give way more
  double case_spacing = 0, least_cells_over_zone = std::numeric_limits<double>::infinity();

  SimulatedBodies bodies() const override {
    SimulatedBodies bodies{sphere, plane, sphere_radius};
    bodies.spacing = case_spacing;
    bodies.work_of_adhesion = own_work;
    bodies.work_of_separation = std::max(own_work, own_opening);
    bodies.adhesion_range = own_range;
    return bodies;
  }

  std::vector<SolvedResponse> solve(const std::vector<CaseChange>& changes,
                                    const std::vector<LoadingProtocol>& protocols,
                                    const EnoughOfIt&) override {
    double work = own_work, opening = own_opening, range = own_range, of_radius = sphere_radius,
           spacing = case_spacing;
    for (const auto& change : changes) {
      if (change.entry.find("/Film ") != std::string::npos) throw WorkError("this stand-in has no films");
      if (change.entry == "Interface/Work of adhesion on separation") opening = change.value;
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
      responses.push_back(work > 0 ? attracted(protocol, {give * modulus(), of_radius, work, work / range},
                                               std::max(work, opening))
                                   : pressed(protocol, of_radius));
    return responses;
  }

  std::vector<SolvedMotion> move(const std::vector<CaseChange>&, const std::vector<MotionProtocol>&,
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
  SolvedResponse attracted(const LoadingProtocol& protocol, const MaugisDugdale& law, double opening) {
    ++attracting;
    EXPECT_GT(protocol.approach, 0);
    SolvedResponse r;
    constexpr int steps = 60;
    MaugisDugdale of_opening = law;
    of_opening.work_of_adhesion = opening;
    of_opening.cohesive_stress *= opening / law.work_of_adhesion;  // over the same range
    hidden::HystereticTruth punch(law, of_opening);
    const double stiffness = 4.0 / 3 * law.reduced_modulus, unit = M_PI * opening * law.radius,
                 of_approach = std::cbrt(std::pow(unit / stiffness, 2) / law.radius);
    const PinnedDugdale held(
        2 * of_opening.cohesive_stress * std::cbrt(law.radius / (M_PI * opening * stiffness * stiffness)),
        law.work_of_adhesion / opening);
    DugdaleContact state{};
    const auto go = [&](double approach) {
      r.displacement.push_back(approach);
      if (keeps_edge) {
        state = held.at(approach / of_approach, state);
        r.force.push_back(unit * state.force);
      } else {
        r.force.push_back(punch.force(approach, 0));
        punch.take(approach, 0);
      }
    };
    for (int i = 1; i <= steps; ++i) go(protocol.approach * i / steps);
    r.peak = steps - 1;
    for (int i = steps - 1; protocol.unloads && i >= 0; --i)
      go(-protocol.retract + (protocol.approach + protocol.retract) * i / steps);
    r.displacement_error = 0.02 * nm;
    const double pull_off = -*std::min_element(r.force.begin(), r.force.end());
    for (double& force : r.force)
      if (force != 0) force -= mesh_pulls_more * pull_off;
    r.pull_off_error = stated_of_pull_off * pull_off;
    return r;
  }
};

/// Pressed to a depth, back, and pulled off: the force of each displacement, with noise.
Recording pulled(const std::function<double(double)>& force_at, double depth, double noise) {
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
  const double back = 4 * nm;
  for (int i = 0; i <= 300; ++i) {
    const double d = -back + (depth + back) * (i <= 150 ? i / 150.0 : (300 - i) / 150.0);
    table.columns["time"].push_back(0.1 * i);
    table.columns["normal_displacement"].push_back(d);
    table.columns["normal_force"].push_back(force_at(d) + noise * normal(random));
    table.segment.push_back(i <= 150 ? "load" : "unload");
  }
  r.tables = {table};
  return r;
}

Recording pulled(const MaugisDugdale& law, double depth, double noise) {
  NormalState state;
  return pulled(
      [&](double d) {
        if (law.work_of_adhesion == 0) return Hertz{law.reduced_modulus, law.radius}.force(d);
        state = law.advance(state, d);
        return state.force;
      },
      depth, noise);
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
  // The stand-in is what the law expects of it: the fit to its first solution leaves it as it was solved.
  EXPECT_EQ(simulation.attracting, 1);
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

TEST(SolvedAttraction_analytic, two_works_of_adhesion_are_those_on_approach_and_on_separation) {
  const double closing = 0.1, opening = 0.5, range = 0.3 * nm;
  hidden::HystereticTruth truth({modulus(), sphere_radius, closing, closing / range},
                                {modulus(), sphere_radius, opening, opening / range});
  const auto force = [&](double d) {
    const double f = truth.force(d, 0);
    truth.take(d, 0);
    return f;
  };
  AttractingStandIn simulation;
  const Diagnosis d = diagnosed(pulled(force, 8 * nm, 0.5e-6), simulation);
  EXPECT_EQ(d.verdict, Verdict::explained) << d.in_words;
  ASSERT_EQ(d.left_out.size(), 1u) << d.in_words;
  EXPECT_EQ(d.left_out[0].id, "adhesion_hysteresis");
  EXPECT_EQ(d.left_out[0].form, "entries of the case");
  ASSERT_EQ(d.corrected().size(), 3u);
  EXPECT_EQ(d.corrected()[0].entry, "Interface/Work of adhesion");
  EXPECT_NEAR(d.corrected()[0].value / closing, 1, 0.15);
  EXPECT_EQ(d.corrected()[2].entry, "Interface/Work of adhesion on separation");
  EXPECT_NEAR(d.corrected()[2].value / opening, 1, 0.05);
}

/// Of a range that no mesh here resolves: the edge stays where it is on the way back from each depth, as it
/// would in the limit of Johnson, Kendall & Roberts, and not as over the range that is solved.
TEST(SolvedAttraction_analytic, two_works_over_a_range_that_no_mesh_resolves_are_told_over_growing_cycles) {
  const double closing = 0.05, opening = 0.2, range = 0.12 * nm;
  Recording recording;
  for (const double depth : {2.5 * nm, 5 * nm}) {
    hidden::HystereticTruth truth({modulus(), sphere_radius, closing, closing / range},
                                  {modulus(), sphere_radius, opening, opening / range});
    const Recording cycle = pulled(
        [&](double d) {
          const double f = truth.force(d, 0);
          truth.take(d, 0);
          return f;
        },
        depth, 0.3e-6);
    if (recording.tables.empty()) {
      recording = cycle;
      continue;
    }
    RecordingTable& table = recording.tables[0];
    const double last = table.columns["time"].back() + 0.1;
    for (const auto& [name, column] : cycle.tables[0].columns)
      for (const double value : column) table.columns[name].push_back(value + (name == "time" ? last : 0));
    for (const auto& segment : cycle.tables[0].segment) table.segment.push_back(segment);
  }
  AttractingStandIn simulation;
  simulation.case_spacing = 16 * nm, simulation.keeps_edge = true;
  const Diagnosis d = diagnosed(recording, simulation);
  EXPECT_EQ(d.verdict, Verdict::explained) << d.in_words;
  ASSERT_EQ(d.left_out.size(), 1u) << d.in_words;
  EXPECT_EQ(d.left_out[0].id, "adhesion_hysteresis");
  EXPECT_NEAR(d.left_out[0].parameters[1].value / opening, 1, 0.03);
  EXPECT_GT(d.corrected()[1].value, 1.5 * range);
  EXPECT_TRUE(std::any_of(d.remarks.begin(), d.remarks.end(), [](const std::string& remark) {
    return remark.find("adhesion_hysteresis fits with transition = ") == 0;
  })) << diagnosis_json(d);
}

TEST(SolvedAttraction_analytic, a_case_that_attracts_as_recorded_leaves_nothing_out) {
  const double work = 0.3, range = 1.2 * nm;
  const MaugisDugdale truth{modulus(), sphere_radius, work, work / range};
  const double largest = truth.advance({}, 10 * nm).force;
  const Recording recording = pulled(truth, 10 * nm, 0.003 * largest);
  AttractingStandIn simulation;
  simulation.own_work = work, simulation.own_range = range;
  const Diagnosis same = diagnosed(recording, simulation);
  EXPECT_EQ(same.verdict, Verdict::no_mismatch) << same.in_words;
  EXPECT_EQ(simulation.attracting, 1);
  simulation.own_work = 0.2;
  const Diagnosis other = diagnosed(recording, simulation);
  EXPECT_EQ(other.verdict, Verdict::explained) << other.in_words;
  ASSERT_EQ(other.left_out.size(), 1u) << other.in_words;
  EXPECT_EQ(other.left_out[0].id, "adhesion");
  EXPECT_EQ(other.corrected()[0].entry, "Interface/Work of adhesion");
  EXPECT_NEAR(other.corrected()[0].value / work, 1, 0.03);
  ASSERT_EQ(other.corrected().size(), 3u);
  EXPECT_EQ(other.corrected()[2].entry, "Interface/Work of adhesion on separation")
      << "that of the case would be less than the work on approach";
  EXPECT_EQ(other.corrected()[2].value, other.corrected()[0].value);
  const auto bulk = std::find_if(other.not_tried.begin(), other.not_tried.end(),
                                 [](const UntriedEffect& untried) { return untried.effect == "film"; });
  ASSERT_NE(bulk, other.not_tried.end());
  EXPECT_EQ(bulk->why, "the surfaces of the case attract, and its law is one of surfaces that do not");
}

TEST(SolvedAttraction_analytic, what_its_mesh_makes_of_the_attraction_is_in_the_interval_and_is_no_mismatch) {
  const double work = 0.3, range = 1.2 * nm;
  const MaugisDugdale truth{modulus(), sphere_radius, work, work / range};
  const Recording recording = pulled(truth, 10 * nm, 0.001 * truth.advance({}, 10 * nm).force);
  AttractingStandIn simulation;
  simulation.mesh_pulls_more = 0.03, simulation.stated_of_pull_off = 0.04;
  const Diagnosis named = diagnosed(recording, simulation);
  EXPECT_EQ(named.verdict, Verdict::explained) << named.in_words;
  ASSERT_EQ(named.left_out.size(), 1u) << named.in_words;
  EXPECT_EQ(named.left_out[0].id, "adhesion");
  const DiagnosedParameter& pull_off = named.left_out[0].parameters[0];
  EXPECT_LT(pull_off.low, truth.pull_off_force());
  EXPECT_GT(pull_off.high, truth.pull_off_force());
  EXPECT_GT(pull_off.high / pull_off.value, 1.078) << "two standard deviations of 4 %, also where the range";
  EXPECT_LT(pull_off.low / pull_off.value, 0.922) << "could take a part of them up";

  simulation.own_work = work, simulation.own_range = range;
  const Diagnosis same = diagnosed(recording, simulation);
  EXPECT_EQ(same.verdict, Verdict::no_mismatch) << same.in_words;
  simulation.stated_of_pull_off = 0;
  const Diagnosis unstated = diagnosed(recording, simulation);
  EXPECT_NE(unstated.verdict, Verdict::no_mismatch) << unstated.in_words;
}

TEST(SolvedAttraction_analytic, instruments_and_another_radius_are_named_around_a_case_that_attracts) {
  const double work = 0.3, range = 1.2 * nm, of_radius = 0.7;
  AttractingStandIn simulation;
  simulation.own_work = work, simulation.own_range = range;
  const MaugisDugdale truth{modulus(), sphere_radius, work, work / range},
      smaller{modulus(), of_radius * sphere_radius, work, work / range};
  const double largest = truth.advance({}, 10 * nm).force;
  Recording drifts = pulled(truth, 10 * nm, 0.003 * largest);
  for (std::size_t i = 0; i < drifts.tables[0].columns["time"].size(); ++i)
    drifts.tables[0].columns["normal_displacement"][i] += 0.05 * nm * drifts.tables[0].columns["time"][i];
  const Diagnosis drift = diagnosed(drifts, simulation);
  EXPECT_EQ(drift.verdict, Verdict::explained) << drift.in_words;
  ASSERT_EQ(drift.left_out.size(), 1u) << drift.in_words;
  EXPECT_EQ(drift.left_out[0].id, "thermal_drift");
  EXPECT_NEAR(drift.left_out[0].parameters[0].value / (0.05 * nm), 1, 0.05);
  const Diagnosis radius = diagnosed(pulled(smaller, 10 * nm, 0.003 * largest), simulation);
  EXPECT_EQ(radius.verdict, Verdict::explained) << radius.in_words;
  ASSERT_EQ(radius.left_out.size(), 1u) << radius.in_words;
  EXPECT_EQ(radius.left_out[0].id, "effective_radius");
  EXPECT_NEAR(radius.left_out[0].parameters[0].value / of_radius, 1, 0.03);
}

TEST(SolvedAttraction_analytic, a_case_that_gives_way_more_than_its_law_is_pressed_to_the_largest_force) {
  const double work = 0.3, range = 1.2 * nm;
  AttractingStandIn simulation;
  simulation.own_work = work, simulation.own_range = range, simulation.give = 0.6;
  const MaugisDugdale truth{simulation.give * modulus(), sphere_radius, work, work / range};
  const double largest = truth.advance({}, 10 * nm).force;
  const Diagnosis d = diagnosed(pulled(truth, 10 * nm, 0.003 * largest), simulation);
  EXPECT_EQ(d.verdict, Verdict::no_mismatch) << d.in_words;
  EXPECT_EQ(simulation.attracting, 2);
  simulation.give = 0.1;
  EXPECT_THROW(diagnosed(pulled(truth, 10 * nm, 0.003 * largest), simulation), WorkError);
}

TEST(SolvedAttraction_analytic, a_case_of_two_works_as_recorded_leaves_nothing_out) {
  const double closing = 0.1, opening = 0.5, range = 0.3 * nm;
  hidden::HystereticTruth truth({modulus(), sphere_radius, closing, closing / range},
                                {modulus(), sphere_radius, opening, opening / range});
  const Recording recording = pulled(
      [&](double d) {
        const double f = truth.force(d, 0);
        truth.take(d, 0);
        return f;
      },
      8 * nm, 0.5e-6);
  AttractingStandIn simulation;
  simulation.own_work = closing, simulation.own_opening = opening, simulation.own_range = range;
  const Diagnosis same = diagnosed(recording, simulation);
  EXPECT_EQ(same.verdict, Verdict::no_mismatch) << same.in_words;
  for (const double alike : {closing, opening}) {
    simulation.own_work = simulation.own_opening = alike;
    const Diagnosis without = diagnosed(recording, simulation);
    ASSERT_EQ(without.left_out.size(), 1u) << without.in_words;
    EXPECT_EQ(without.left_out[0].id, "adhesion_hysteresis");
    EXPECT_NEAR(without.left_out[0].parameters[1].value / opening, 1, 0.05);
  }
}

TEST(SolvedAttraction_analytic, electrostatic_attraction_stands_beside_the_solution) {
  const Hertz hertz{modulus(), sphere_radius};
  const double voltage = 12, distance = 3 * nm, permittivity = 8.8541878128e-12;
  const auto force = [&](double d) {
    const double z = distance + std::max(0.0, -d);
    const double pull =
        M_PI * permittivity * std::pow(voltage * sphere_radius, 2) / (z * (z + sphere_radius));
    return (d > 0 ? hertz.force(d) : 0.0) - pull;
  };
  AttractingStandIn simulation;
  const Diagnosis d = diagnosed(pulled(force, 10 * nm, 0.2e-6), simulation);
  EXPECT_EQ(d.verdict, Verdict::explained) << d.in_words;
  ASSERT_EQ(d.left_out.size(), 1u) << d.in_words;
  EXPECT_EQ(d.left_out[0].id, "electrostatic");
  EXPECT_EQ(d.left_out[0].form, "reduced law beside the solution");
  EXPECT_NEAR(d.left_out[0].parameters[0].value / voltage, 1, 0.1);
}

/// Solved by finite elements with the works and the range that the case states; none is fitted.
TEST(AdhesionHysteresis_analytic, is_what_finite_elements_solve) {
  const double work = 0.8, range = 1.5 * nm;
  Experiment e;
  e.particle = sphere, e.substrate = plane, e.radius = sphere_radius;
  const double unit = std::cbrt(sphere_radius / (M_PI * work * std::pow(4.0 / 3 * modulus(), 2)));
  const double lambda = 2 * work / range * unit,
               transition = root_between([&](double alpha) { return lambda_of_transition(alpha) - lambda; },
                                         0.0, 0.999);
  const double works[] = {0.2, work, transition};
  Mechanics m;
  m.experiment = e, m.geometry = e.hertz();
  effect_of("adhesion_hysteresis").assemble(m, works);
  const auto contact = m.normal.contact->clone();
  const CsvTable solved = read_csv(solved_truth("adhesion_hysteresis") / "history.csv");
  const auto d = solved.numbers("normal_displacement [m]"), f = solved.numbers("normal_force [N]");
  test::Largest error;
  for (std::size_t i = 0; i < d.size(); ++i) {
    error.count((contact->force(d[i]) - f[i]) / 92e-6);
    contact->accept(d[i]);
  }
  EXPECT_TRUE(test::Verified({"Adhesion", "hysteresis, 0.2 and 0.8 J/m2 over 1.5 nm: force over the largest",
                              "finite elements"})
                  .below(error, 0.006));
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

// Diagnoses whose simulation is solved anew: a stand-in for finite elements, whose yielding is that of
// published finite elements (Kogut & Etsion 2002) and not that of the catalogue's reduced law (Jackson &
// Green 2005).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <set>

#include "core/error.h"
#include "core/printed.h"
#include "core/topography_spec.h"
#include "diagnosis/catalogue/effect.h"
#include "diagnosis/conceal/normal_truth.h"
#include "diagnosis/conceal/other_code_truth.h"
#include "diagnosis/conceal/rough_layer.h"
#include "diagnosis/diagnose.h"
#include "tests/diagnosis/support/made_recording.h"
#include "tests/support/coated_half_space.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::message_of;
using test::nm;

constexpr double radius = 8.5e-6;
const ElasticBody glass{71e9, 0.17}, wafer{179e9, 0.25};

/// Stiffer than Hertz by a factor, as a body of finite size may be, or yielding.
class StandIn : public ForwardModel {
 public:
  double stiffer = 1;
  std::string cannot_solve;  ///< an entry
  bool is_slow = false;      ///< it would be solved in more time
  bool is_smooth = true;
  double share_solved = 1;  ///< of the load, where it yields; what is left takes too long
  std::optional<double> yield_of_case;
  int solved = 0;
  std::set<double> yields;  ///< stresses that it was solved with

  SimulatedBodies bodies() const override {
    SimulatedBodies b{glass, wafer, radius};
    if (yield_of_case) b.particle_yield = *yield_of_case;
    b.is_smooth = is_smooth;
    return b;
  }

  std::vector<SolvedResponse> solve(const std::vector<CaseChange>& changes,
                                    const std::vector<LoadingProtocol>& protocols,
                                    const EnoughOfIt&) override {
    double of_radius = radius;
    std::optional<double> yield = yield_of_case;
    Film film;
    for (const auto& change : changes) {
      if (change.entry == cannot_solve && is_slow) throw OutOfTime("it took too long");
      if (change.entry == cannot_solve) throw WorkError("the steps did not converge");
      if (change.entry == "Particle/Radius")
        of_radius = change.value;
      else if (change.entry == "Particle/Yield stress")
        yields.insert(*(yield = change.value));
      else if (change.entry == "Particle/Film thickness")
        film.thickness = change.value;
      else if (change.entry == "Particle/Film Young modulus")
        film.body.youngs_modulus = change.value;
      else if (change.entry == "Particle/Film Poisson ratio")
        film.body.poisson_ratio = change.value;
      else
        ADD_FAILURE() << change.entry;
    }
    std::vector<SolvedResponse> responses;
    for (const auto& protocol : protocols) responses.push_back(response(protocol, of_radius, yield, film));
    return responses;
  }

  std::vector<SolvedMotion> move(const std::vector<CaseChange>&, const std::vector<MotionProtocol>&,
                                 bool) override {
    throw WorkError("this stand-in does not slide");
  }

 private:
  struct Film {
    ElasticBody body;
    double thickness = 0;
  };

  SolvedResponse response(const LoadingProtocol& protocol, double of_radius, std::optional<double> yield,
                          const Film& film) {
    ++solved;
    std::unique_ptr<hidden::NormalTruth> contact;
    const double modulus = reduced_modulus(glass, wafer);
    if (yield)
      contact = std::make_unique<hidden::PlasticTruth>(modulus, of_radius, glass.poisson_ratio, *yield);
    const auto force = [&](double d) {
      if (contact) return contact->force(d, 0);
      const double E = film.thickness > 0 ? filmed_modulus(film, std::sqrt(of_radius * d)) : modulus;
      return 4.0 / 3 * stiffer * E * std::sqrt(of_radius) * d * std::sqrt(d);
    };
    const bool all = !contact || share_solved == 1;
    const double largest = all ? protocol.largest_force : share_solved * protocol.largest_force;
    double low = 0, high = 1e-6;
    for (int i = 0; i < 80; ++i) (force(0.5 * (low + high)) < largest ? low : high) = 0.5 * (low + high);
    SolvedResponse r;
    if (!all) r.ended_early = "it took too long", r.is_out_of_time = true;
    constexpr int steps = 40;
    for (int i = 0; i <= steps; ++i) add(r, low * i / steps, force(low * i / steps));
    r.peak = steps;
    if (contact) contact->take(low, 0);
    for (int i = steps - 1; i >= 0 && protocol.unloads && all; --i)
      add(r, low * i / steps, force(low * i / steps));
    r.displacement_error = 0.05 * nm;
    r.source = "stand-in";
    return r;
  }
  /// Reduced modulus of the coated glass on the wafer (Perriot & Barthel 2004), which the effect applies to
  /// both bodies together.
  static double filmed_modulus(const Film& film, double contact_radius) {
    const auto alone = [](const ElasticBody& b) {
      return b.youngs_modulus / (1 - b.poisson_ratio * b.poisson_ratio);
    };
    const CoatedHalfSpace coated{alone(film.body), alone(glass), film.thickness};
    return contact_radius > 0 ? 1 / (1 / coated.modulus(contact_radius) + 1 / alone(wafer)) : alone(wafer);
  }
  static void add(SolvedResponse& r, double displacement, double force) {
    if (!r.force.empty() && r.force.size() > 1 && force <= 0) return;
    r.displacement.push_back(displacement);
    r.force.push_back(force);
  }
};

/// Pressed to each of these depths and back, one after the other; `force` of the displacement.
Recording pressed(const std::function<double(double)>& force, double noise,
                  const std::vector<double>& depths = {60 * nm}) {
  Recording r;
  r.mode = Motion::normal;
  r.particle = test::borosilicate();
  r.substrate = test::silicon();
  RecordingTable table;
  table.file = "pressed.csv";
  table.control = {"normal_displacement"};
  table.response = "normal_force";
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (std::size_t cycle = 0; cycle < depths.size(); ++cycle)
    for (int i = cycle == 0 ? 0 : 1; i <= 300; ++i) {
      const double d = depths[cycle] * (i <= 150 ? i / 150.0 : (300 - i) / 150.0);
      table.columns["time"].push_back(0.1 * (i + 300 * static_cast<double>(cycle)));
      table.columns["normal_displacement"].push_back(d);
      table.columns["normal_force"].push_back(force(d) + noise * normal(random));
      table.segment.push_back((i <= 150 ? "load " : "unload ") + std::to_string(cycle + 1));
    }
  r.tables = {table};
  return r;
}

/// Whether a set stands among the alternatives.
bool holds(const Diagnosis& d, const std::vector<std::string>& effects) {
  return std::any_of(d.alternatives.begin(), d.alternatives.end(), [&](const AlternativeExplanation& a) {
    return std::equal(a.effects.begin(), a.effects.end(), effects.begin(), effects.end(),
                      [](const DiagnosedEffect& effect, const std::string& id) { return effect.id == id; });
  });
}

/// The same of a sphere that yields, noise 0.3 % of the largest force.
Recording pressed_yielding(double yield, const std::vector<double>& depths = {60 * nm}) {
  hidden::PlasticTruth truth(reduced_modulus(glass, wafer), radius, glass.poisson_ratio, yield);
  return pressed(
      [&](double d) {
        const double force = truth.force(d, 0);
        truth.take(d, 0);
        return force;
      },
      0.003 * truth.loading_force(depths.back()), depths);
}

double force_of_hertz(double d) { return Hertz{reduced_modulus(glass, wafer), radius}.force(d); }
Diagnosis diagnosed(const Recording& recording, StandIn* simulation) {
  DiagnoseOptions options;
  options.simulation = simulation;
  return diagnose(recording, options);
}

bool says(const Diagnosis& d, const std::string& words) {
  for (const auto& remark : d.remarks)
    if (remark.find(words) != std::string::npos) return true;
  return false;
}

TEST(SolvedCase_behaviour, what_the_case_says_is_the_simulation_and_not_the_reduced_law) {
  StandIn stiff;
  stiff.stiffer = 1.06;
  const Recording recording =
      pressed([](double d) { return 1.06 * force_of_hertz(d); }, 0.003 * force_of_hertz(60 * nm));
  EXPECT_NE(diagnosed(recording, nullptr).verdict, Verdict::no_mismatch);
  const Diagnosis d = diagnosed(recording, &stiff);
  EXPECT_EQ(d.verdict, Verdict::no_mismatch) << d.in_words;
  EXPECT_EQ(stiff.solved, 1);
  EXPECT_TRUE(d.simulation.by_finite_elements);
  EXPECT_TRUE(d.corrected().empty());
}

TEST(SolvedCase_behaviour, yielding_gets_the_yield_stress_of_the_case_and_not_that_of_the_reduced_law) {
  constexpr double yield = 0.9e9;
  const Recording recording = pressed_yielding(yield);
  StandIn elastic;
  const Diagnosis d = diagnosed(recording, &elastic);
  EXPECT_EQ(d.verdict, Verdict::explained) << d.in_words;
  ASSERT_EQ(d.left_out.size(), 1u) << d.in_words;
  EXPECT_EQ(d.left_out[0].id, "bulk_plasticity");
  ASSERT_EQ(d.corrected().size(), 1u);
  const CorrectedEntry entry = d.corrected()[0];
  EXPECT_EQ(entry.entry, "Particle/Yield stress");
  EXPECT_NEAR(entry.value / yield, 1, 0.03);
  EXPECT_LT(entry.low, yield);
  EXPECT_GT(entry.high, yield);
  EXPECT_LT(d.improved.held_out_chi2_reduced, 1.5);
  // Every effect that has no form in the case is said not to be tried, and why.
  const auto burst = std::find_if(d.not_tried.begin(), d.not_tried.end(),
                                  [](const auto& untried) { return untried.effect == "indentation_size"; });
  ASSERT_NE(burst, d.not_tried.end());
  EXPECT_TRUE(says(d, "indentation_size was not tried: " + burst->why));
  const auto json = nlohmann::json::parse(diagnosis_json(d));
  EXPECT_EQ(json["forward_model"]["kind"], "finite_elements");
  EXPECT_EQ(json["forward_model"]["solves"], d.simulation.solves);
  EXPECT_NEAR(json["forward_model"]["discretisation_error"]["value"].get<double>(), 0.05 * nm, 1e-15);
  EXPECT_EQ(json["left_out"][0]["tried_in"], nlohmann::json::array({"finite_elements"}));
  EXPECT_EQ(json["left_out"][0]["case_entries"]["Particle/Yield stress"], printed("%.6g Pa", entry.value));
  EXPECT_EQ(json["not_tried"].size(), d.not_tried.size());
  EXPECT_LE(elastic.solved, 20);
  // Its law and the stand-in differ: a second solution checks the first.
  EXPECT_GE(elastic.yields.size(), 2u);
}

TEST(SolvedCase_behaviour, nothing_is_the_only_explanation_where_another_could_not_be_solved) {
  constexpr double yield = 0.9e9;
  const Recording recording = pressed_yielding(yield);
  StandIn fails;
  fails.cannot_solve = "Particle/Yield stress";
  const Diagnosis d = diagnosed(recording, &fails);
  EXPECT_EQ(d.verdict, Verdict::ambiguous) << d.in_words;
  ASSERT_FALSE(d.alternatives.empty());
  EXPECT_EQ(d.alternatives.front().told_apart_by, "a case that can be solved with what the remarks name");
  EXPECT_TRUE(says(d, "the steps did not converge"));
  EXPECT_TRUE(holds(d, {"bulk_plasticity"})) << d.in_words;
  double sum = 0;
  for (const auto& alternative : d.alternatives) sum += alternative.probability;
  EXPECT_NEAR(sum, 1, 1e-9);
}

TEST(SolvedCase_behaviour, what_could_not_be_solved_is_an_answer_where_nothing_else_explains) {
  StandIn fails;
  fails.cannot_solve = "Particle/Yield stress", fails.is_slow = true;
  const Diagnosis d = diagnosed(pressed_yielding(0.9e9, {30 * nm, 60 * nm}), &fails);
  EXPECT_EQ(d.verdict, Verdict::ambiguous) << d.in_words;
  EXPECT_TRUE(d.left_out.empty()) << d.in_words;
  EXPECT_TRUE(d.nearest.empty());
  EXPECT_FALSE(d.mismatch.empty());
  ASSERT_TRUE(holds(d, {"bulk_plasticity"})) << d.in_words;
  EXPECT_NE(d.in_words.find("Nothing is named until it is solved to its end"), std::string::npos)
      << d.in_words;
  double sum = 0;
  for (const auto& alternative : d.alternatives) {
    sum += alternative.probability;
    EXPECT_EQ(alternative.told_apart_by, "a longer --minutes, in which it is solved to its end");
    EXPECT_EQ(alternative.effects.size(), 1u) << "what only adds to another is none of its own";
  }
  EXPECT_NEAR(sum, 1, 1e-9);
}

TEST(SolvedCase_behaviour, each_turning_point_is_solved_and_yielding_recovered_over_cycles_of_growing_depth) {
  constexpr double yield = 0.9e9;
  const Recording recording = pressed_yielding(yield, {20 * nm, 40 * nm, 60 * nm});
  StandIn elastic;
  const Diagnosis d = diagnosed(recording, &elastic);
  EXPECT_EQ(d.verdict, Verdict::explained) << d.in_words;
  ASSERT_EQ(d.left_out.size(), 1u) << d.in_words;
  EXPECT_EQ(d.left_out[0].id, "bulk_plasticity");
  ASSERT_EQ(d.corrected().size(), 1u);
  const CorrectedEntry entry = d.corrected()[0];
  EXPECT_NEAR(entry.value / yield, 1, 0.03);
  EXPECT_LT(entry.low, yield);
  EXPECT_GT(entry.high, yield);
  EXPECT_LT(d.improved.held_out_chi2_reduced, 1.5);

  StandIn yields;
  yields.yield_of_case = yield;
  const Diagnosis same = diagnosed(recording, &yields);
  EXPECT_EQ(same.verdict, Verdict::no_mismatch) << same.in_words;
  EXPECT_EQ(yields.solved, 3);
}

TEST(SolvedCaseNightly_behaviour, more_turning_points_than_are_solved_leave_yielding_open_and_say_so) {
  std::vector<double> depths;
  for (int i = 2; i <= 8; ++i) depths.push_back(7.5 * nm * i);
  StandIn elastic;
  const Diagnosis d = diagnosed(pressed_yielding(0.9e9, depths), &elastic);
  EXPECT_NE(d.verdict, Verdict::explained) << d.in_words;
  EXPECT_TRUE(says(d, "the recording turns back from 7 loads")) << d.in_words;
}

/// What no case takes would stay open, whatever else explains the recording.
TEST(SolvedCase_behaviour, a_film_is_no_thicker_than_a_case_takes) {
  Experiment e = test::experiment(Motion::normal);
  e.radius = radius, e.largest_displacement = 200 * nm;  // of a contact wide enough for more
  const auto thickest = [&] {
    for (const auto& p : effect_of("film").parameters(e))
      if (p.name == "thickness") return p.high;
    return 0.0;
  };
  EXPECT_GT(thickest(), 0.5 * radius);
  e.by_finite_elements = true;
  EXPECT_LT(thickest(), 0.5 * radius);
  EXPECT_GT(thickest(), 0.4 * radius);
}

TEST(SolvedCase_behaviour, yielding_at_another_stress_than_the_case_says) {
  constexpr double yield = 0.9e9;
  for (const double of_case : {0.6e9, 1.4e9}) {
    StandIn yields;
    yields.yield_of_case = of_case;
    const Diagnosis d = diagnosed(pressed_yielding(yield), &yields);
    EXPECT_EQ(d.verdict, Verdict::explained) << d.in_words;
    ASSERT_EQ(d.left_out.size(), 1u) << d.in_words;
    EXPECT_EQ(d.left_out[0].id, "bulk_plasticity");
    ASSERT_EQ(d.corrected().size(), 1u);
    EXPECT_EQ(d.corrected()[0].entry, "Particle/Yield stress");
    EXPECT_NEAR(d.corrected()[0].value / yield, 1, 0.03);
    EXPECT_LT(d.corrected()[0].low, yield);
    EXPECT_GT(d.corrected()[0].high, yield);
  }
}

TEST(SolvedCase_behaviour, what_is_solved_in_part_is_judged_on_that_part_and_said) {
  const double compliance = 3e-6;
  const auto in_series = [&](double d) {
    double low = 0, high = d;
    for (int i = 0; i < 80; ++i) {
      const double middle = 0.5 * (low + high);
      (middle + compliance * force_of_hertz(middle) < d ? low : high) = middle;
    }
    return force_of_hertz(low);
  };
  StandIn slow;
  slow.share_solved = 0.6;
  const Diagnosis compliant = diagnosed(pressed(in_series, 0.003 * in_series(60 * nm)), &slow);
  EXPECT_EQ(compliant.verdict, Verdict::explained) << compliant.in_words;
  ASSERT_EQ(compliant.left_out.size(), 1u);
  EXPECT_EQ(compliant.left_out[0].id, "instrument_compliance");
  const DiagnosedParameter& found = compliant.left_out[0].parameters.at(0);
  EXPECT_LT(found.low, compliance);
  EXPECT_GT(found.high, compliance);

  const Diagnosis yielding = diagnosed(pressed_yielding(0.9e9), &slow);
  EXPECT_EQ(yielding.verdict, Verdict::ambiguous) << yielding.in_words;
  EXPECT_TRUE(holds(yielding, {"bulk_plasticity"})) << yielding.in_words;
  EXPECT_TRUE(says(yielding, "bulk_plasticity was solved up to")) << yielding.in_words;
  EXPECT_TRUE(says(yielding, "it took too long"));
  EXPECT_TRUE(says(yielding, "which leaves it open; a longer --minutes solves it further"));
}

/// Generated surfaces on half-spaces, which follow no layer's law exactly, counted from 0.2 % of the load.
TEST(SolvedCase_other_code, a_rough_contact_of_half_spaces_is_named_with_its_height_and_its_zero) {
  constexpr double largest = 250e-6;
  int explained = 0;
  for (const unsigned seed : {3u, 4u}) {
    const hidden::RoughSurface surface{1.2 * nm, 150 * nm, 70 * nm, seed};
    const auto contact = hidden::rough_half_spaces(glass, wafer, radius, surface, largest);
    double deepest = 5 * nm;
    while (contact->force(deepest, 0) < largest) deepest += 0.05 * nm;
    const Recording recording =
        pressed([&](double d) { return contact->force(d, 0); }, 0.003 * largest, {deepest});
    StandIn smooth;
    const Diagnosis d = diagnosed(recording, &smooth);
    ASSERT_EQ(d.left_out.size(), 1u) << d.in_words;
    EXPECT_EQ(d.left_out[0].id, "roughness_compliance");
    EXPECT_TRUE(d.verdict == Verdict::explained || d.verdict == Verdict::partly_explained) << d.in_words;
    if (d.verdict != Verdict::explained) {  // a spot that is smooth where it is touched first
      EXPECT_TRUE(d.corrected().empty());
      EXPECT_TRUE(says(d, "corrected.prm has no topography"));
      continue;
    }
    ++explained;
    ASSERT_EQ(d.corrected().size(), 1u);
    EXPECT_LT(d.corrected()[0].low, surface.rms);
    EXPECT_GT(d.corrected()[0].high, surface.rms);
    const auto& parameters = d.left_out[0].parameters;
    const auto zero = std::find_if(parameters.begin(), parameters.end(),
                                   [](const auto& p) { return p.name == "zero_force"; });
    ASSERT_NE(zero, parameters.end());
    EXPECT_GT(zero->value, 1e-3 * largest);
    EXPECT_LT(zero->value, 5e-3 * largest);
  }
  EXPECT_GE(explained, 1);
}

/// A layer of asperities whose pressure follows the gap exponentially, solved on rings: no formula of the
/// catalogue. Recorded from where it bears a thousandth of the largest force.
TEST(SolvedCase_behaviour, asperities_are_named_around_the_solution_and_enter_as_a_topography) {
  const double modulus = reduced_modulus(glass, wafer), length = 0.6 * nm, deepest = 25 * nm;
  hidden::RoughLayer layer({modulus, radius}, length, 5e9, 3 * std::sqrt(radius * deepest), 80);
  double touch = -20 * nm;
  const double largest = layer.force(deepest);
  while (layer.force(touch) < 1e-3 * largest) touch += 0.05 * nm;
  const Recording recording =
      pressed([&](double d) { return layer.force(touch + d); }, 0.002 * largest, {deepest - touch});
  StandIn smooth;
  const Diagnosis d = diagnosed(recording, &smooth);
  ASSERT_EQ(d.left_out.size(), 1u) << d.in_words;
  EXPECT_EQ(d.left_out[0].id, "roughness_compliance");
  EXPECT_EQ(d.left_out[0].form, "reduced law in series with the solution");
  ASSERT_EQ(d.corrected().size(), 1u);
  const CorrectedEntry entry = d.corrected()[0];
  EXPECT_EQ(entry.entry, "Substrate/Topography");
  const TopographySpec topography(entry.written());
  ASSERT_NE(topography.generator(), nullptr) << entry.written();
  EXPECT_NEAR(topography.rms() / entry.value, 1, 1e-3);
  EXPECT_LT(entry.low, entry.value);
  EXPECT_GT(entry.high, entry.value);
  // A case that is rough already gets no second topography.
  StandIn rough;
  rough.is_smooth = false;
  EXPECT_TRUE(diagnosed(recording, &rough).corrected().empty());
}

}  // namespace
}  // namespace asperity

// A recording of several surfaces whose simulation is a case: a stand-in for finite elements, whose
// attraction falls with the roughness, which no reduced law here says.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "core/error.h"
#include "diagnosis/diagnose.h"
#include "tests/diagnosis/support/made_recording.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::message_of;
using test::nm;
using test::uN;

class RoughStandIn : public ForwardModel {
 public:
  static constexpr double friction = 0.3;
  double rms_of_case = 1.5 * nm;
  std::set<double> slid_on{};

  /// Of one attraction, what presses on a surface so rough.
  static double left_of(double attraction, double rms) { return attraction * std::exp(-rms / (3 * nm)); }

  SimulatedBodies bodies() const override {
    SimulatedBodies b{{71e9, 0.17}, {179e9, 0.25}, 8.5e-6};
    b.is_smooth = false;
    b.friction_coefficient = friction;
    b.substrate_rms = rms_of_case;
    return b;
  }
  std::vector<SolvedResponse> solve(const std::vector<CaseChange>&, const std::vector<LoadingProtocol>&,
                                    const EnoughOfIt&) override {
    throw WorkError("nothing is pressed alone here");
  }
  std::vector<SolvedMotion> move(const std::vector<CaseChange>& changes,
                                 const std::vector<MotionProtocol>& protocols, bool) override {
    double mu = friction, attraction = 0, strength = 0;
    for (const auto& change : changes) {
      if (change.entry == "Interface/Friction coefficient") mu = change.value;
      if (change.entry == "Interface/Attraction force") attraction = change.value;
      if (change.entry.find("strength") != std::string::npos) strength = change.value;
    }
    std::vector<SolvedMotion> motions;
    for (const auto& protocol : protocols) {
      const double rms = protocol.substrate_rms.value_or(rms_of_case);
      slid_on.insert(rms);
      SolvedMotion s;
      s.normal_force = protocol.normal_force;
      s.substrate_rms = protocol.substrate_rms;
      const Hertz hertz{reduced_modulus(bodies().particle, bodies().substrate), bodies().radius};
      const double area =
          M_PI * std::pow(hertz.contact_radius(s.normal_force), 2) * std::exp(-rms / (2 * nm));
      s.resistance = mu * (s.normal_force + left_of(attraction, rms)) + strength * area;
      s.resistance_error = 0.005 * s.resistance;
      s.source = "stand-in";
      motions.push_back(s);
    }
    return motions;
  }
};

/// Steady friction on each surface, both ways; noise of 0.2 uN.
Recording recorded(const std::vector<double>& surfaces,
                   const std::function<double(double, double)>& friction) {
  Recording r;
  r.mode = Motion::sliding;
  r.particle = test::borosilicate();
  r.substrate = test::silicon();
  RecordingTable table;
  table.file = "series.csv";
  table.kind = TableKind::series;
  table.control = {"normal_force"};
  table.response = "lateral_force";
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 0.2 * uN);
  for (const double rms : surfaces)
    for (const double load : {3., 10., 20., 30., 40., 50., 65., 80., 100.})
      for (const int way : {1, -1}) {
        table.columns["normal_force"].push_back(load * uN);
        table.columns["rms_roughness"].push_back(rms);
        table.columns["lateral_force"].push_back(way * friction(load * uN, rms) + noise(random));
        table.columns["lateral_force_sd"].push_back(0.2 * uN);
        table.segment.push_back(way > 0 ? "forward" : "backward");
      }
  r.tables = {table};
  return r;
}

Diagnosis diagnosed_by(const Recording& recording, ForwardModel& model) {
  DiagnoseOptions options;
  options.simulation = &model;
  return diagnose(recording, options);
}

const std::vector<double> wafers{0.3 * nm, 1.5 * nm, 2.7 * nm};

TEST(SolvedSurfaces_behaviour, each_surface_is_solved_with_its_own_roughness_and_needs_nothing_more) {
  RoughStandIn stand_in;
  const Diagnosis d = diagnosed_by(recorded(wafers, [](double f, double) { return 0.3 * f; }), stand_in);
  EXPECT_EQ(d.verdict, Verdict::no_mismatch) << d.in_words;
  EXPECT_EQ(stand_in.slid_on, std::set<double>(wafers.begin(), wafers.end()));
  EXPECT_EQ(d.simulation.solves, 9);
}

TEST(SolvedSurfaces_behaviour, local_friction_by_roughness_is_told_from_attraction_that_roughness_takes) {
  RoughStandIn stand_in;
  const double attraction = 40 * uN;
  const auto friction = [&](double f, double rms) {
    return (0.1 + 0.2 * rms / nm) * (f + RoughStandIn::left_of(attraction, rms));
  };
  const Diagnosis d = diagnosed_by(recorded(wafers, friction), stand_in);
  EXPECT_EQ(d.verdict, Verdict::explained) << d.in_words;
  ASSERT_EQ(d.left_out.size(), 2u) << d.in_words;
  const auto of = [&](const std::string& id) {
    return *std::find_if(d.left_out.begin(), d.left_out.end(), [&](const auto& e) { return e.id == id; });
  };
  const auto by_roughness = of("friction_by_roughness"), by_attraction = of("adhesion_offset");
  EXPECT_NEAR(by_roughness.parameters[0].value, 0.1, 0.01);
  EXPECT_NEAR(by_roughness.parameters[1].value, 0.2e9, 0.01e9);
  EXPECT_NEAR(by_attraction.parameters[0].value, attraction, 0.06 * attraction);
  // The corrected case has the friction of its own surface.
  for (const CorrectedEntry& entry : d.corrected())
    if (entry.entry == "Interface/Friction coefficient") {
      EXPECT_NEAR(entry.value, 0.4, 0.01);
    }
}

TEST(SolvedSurfaces_behaviour, a_case_whose_roughness_cannot_follow_is_refused_with_the_remedy) {
  RoughStandIn of_a_scan;
  of_a_scan.rms_of_case = 0;
  const Recording several = recorded(wafers, [](double f, double) { return 0.3 * f; });
  const std::string said = message_of<InputError>([&] { diagnosed_by(several, of_a_scan); });
  EXPECT_NE(said.find("varies rms_roughness"), std::string::npos) << said;
  EXPECT_NE(said.find("Substrate/Topography = generated(...)"), std::string::npos) << said;
}

}  // namespace
}  // namespace asperity

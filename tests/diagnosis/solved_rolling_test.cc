// Recordings of rolling and torsion whose simulation is a case: a stand-in for finite elements, whose contact
// is widened by what closing gains (Johnson, Kendall & Roberts 1971), and by 4 % by the range of attraction,
// where the reduced law takes Hertz' radius.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "core/error.h"
#include "diagnosis/diagnose.h"
#include "tests/diagnosis/support/made_recording.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::message_of;
using test::nm;
using test::uN;

const ElasticBody rolled_glass{71e9, 0.17}, rolled_wafer{179e9, 0.25};
constexpr double rolled_radius = 8.5e-6;
const Hertz rolled_contact{reduced_modulus(rolled_glass, rolled_wafer), rolled_radius};

/// Radius under load and adhesion: 4/3 E* a^3/R = f + 3 pi w R + (6 pi w R f + (3 pi w R)^2)^(1/2).
double adhering_radius(double load, double work) {
  const double pull = 3 * M_PI * work * rolled_radius;
  return rolled_contact.contact_radius(load + pull + std::sqrt(2 * pull * load + pull * pull));
}

class RollingStandIn : public ForwardModel {
 public:
  double closing = 0, opening = 0;  ///< works of adhesion of the case [J/m^2]
  double range = 1 * nm;            ///< of its attraction [m]
  double lost = 1e-3;               ///< share of the load that its bodies lose [-]
  double off_by = 0;                ///< of its mesh, as a share of the load [-]
  double spurious = 0;              ///< all of it the mesh's, at 1 mN; it grows faster than the load [N]
  double rms = 0;                   ///< of its substrate [m]
  std::vector<double> paths{};      ///< in contact radii
  std::set<std::string> changed{};  ///< entries

  SimulatedBodies bodies() const override {
    SimulatedBodies b{rolled_glass, rolled_wafer, rolled_radius};
    b.adhesion_range = range;
    b.work_of_adhesion = closing;
    b.work_of_separation = std::max(closing, opening);
    b.spacing = 20 * nm;
    b.substrate_rms = rms;
    b.is_smooth = rms == 0;
    return b;
  }
  std::vector<SolvedResponse> solve(const std::vector<CaseChange>&, const std::vector<LoadingProtocol>&,
                                    const EnoughOfIt&) override {
    throw WorkError("nothing is pressed alone here");
  }
  std::vector<SolvedMotion> move(const std::vector<CaseChange>& changes,
                                 const std::vector<MotionProtocol>& protocols, bool) override {
    double on_approach = closing, on_separation = std::max(closing, opening);
    for (const auto& change : changes) {
      changed.insert(change.entry);
      if (change.entry == "Interface/Work of adhesion")
        on_approach = change.value;
      else if (change.entry == "Interface/Work of adhesion on separation")
        on_separation = change.value;
    }
    std::vector<SolvedMotion> motions;
    for (const auto& protocol : protocols) {
      EXPECT_EQ(protocol.motion, Motion::rolling);
      SolvedMotion m;
      m.normal_force = protocol.normal_force;
      m.substrate_rms = protocol.substrate_rms;
      const double share = lost * std::exp(-protocol.substrate_rms.value_or(0) / (2 * nm));
      const double of_mesh = spurious * std::pow(m.normal_force / (1000 * uN), 1.6);
      m.resistance = rolls(share, on_approach, on_separation, protocol.normal_force) + of_mesh;
      if (m.resistance < 2 * of_mesh) {  // no more than the mesh makes of smooth elastic bodies
        m.of_mesh = m.resistance;
        m.resistance /= 2;
      }
      m.resistance_error =
          std::max({0.01 * m.resistance, off_by * m.normal_force, m.of_mesh > 0 ? m.resistance : 0});
      m.source = "stand-in";
      paths.push_back(protocol.path / rolled_contact.contact_radius(protocol.normal_force));
      motions.push_back(m);
    }
    return motions;
  }
  static double rolls(double share, double on_approach, double on_separation, double load) {
    constexpr double by_range = 1.04;
    return share * load + 2 * by_range * adhering_radius(load, on_approach) * (on_separation - on_approach);
  }
};

/// Steady force forth and back at each load, noise of the largest; of several surfaces where they are given.
Recording rolled(const std::function<double(double load, double rms)>& force, double noise,
                 const std::vector<double>& surfaces = {}) {
  Recording r;
  r.mode = Motion::rolling;
  r.particle = test::borosilicate();
  r.substrate = test::silicon();
  r.indenter = r.substrate;
  RecordingTable table;
  table.file = "rolled.csv";
  table.kind = TableKind::series;
  table.control = {"normal_force"};
  table.response = "lateral_force";
  std::mt19937 random(5);
  std::normal_distribution<double> deviation(0, noise * force(1000 * uN, 0));
  for (const double rms : surfaces.empty() ? std::vector<double>{0} : surfaces)
    for (const double load : {100 * uN, 160 * uN, 250 * uN, 400 * uN, 630 * uN, 1000 * uN})
      for (int repeat = 0; repeat < 6; ++repeat)
        for (const int direction : {1, -1}) {
          table.columns["normal_force"].push_back(load);
          if (!surfaces.empty()) table.columns["rms_roughness"].push_back(rms);
          table.columns["lateral_force"].push_back(direction * force(load, rms) + deviation(random));
          table.segment.push_back(direction > 0 ? "forward" : "backward");
        }
  if (!surfaces.empty()) table.control.push_back("rms_roughness");
  r.tables = {table};
  r.noise["lateral_force"] = noise * force(1000 * uN, 0);
  return r;
}

Diagnosis diagnosed_rolling(const Recording& recording, RollingStandIn& simulation) {
  DiagnoseOptions options;
  options.simulation = &simulation;
  return diagnose(recording, options);
}

TEST(SolvedRolling_behaviour, the_case_that_rolls_as_recorded_needs_nothing) {
  RollingStandIn stand_in;
  stand_in.opening = 0.1;
  const Diagnosis d = diagnosed_rolling(
      rolled([&](double f, double) { return RollingStandIn::rolls(stand_in.lost, 0, 0.1, f); }, 0.01),
      stand_in);
  EXPECT_EQ(d.verdict, Verdict::no_mismatch) << d.in_words;
  ASSERT_EQ(stand_in.paths.size(), 3u);
  for (const double path : stand_in.paths) EXPECT_NEAR(path, 6, 1e-6);
  EXPECT_EQ(d.simulation.error_of, "rolling resistance");
}

/// The noise is then that of rows under one load in one direction, not that of neighbours in sorted order.
TEST(SolvedRolling_behaviour, noise_that_is_not_stated_comes_from_rows_that_repeat) {
  RollingStandIn stand_in;
  stand_in.opening = 0.1;
  const auto force = [&](double f, double) { return RollingStandIn::rolls(stand_in.lost, 0, 0.1, f); };
  Recording recording = rolled(force, 0.01);
  recording.noise.clear();
  const Diagnosis d = diagnosed_rolling(recording, stand_in);
  EXPECT_EQ(d.verdict, Verdict::no_mismatch) << d.in_words;
  ASSERT_EQ(d.noise.size(), 1u);
  EXPECT_EQ(d.noise.begin()->second.from, "repeats");
  EXPECT_NEAR(d.noise.begin()->second.value / (0.01 * force(1000 * uN, 0)), 1, 0.2);
}

/// Of a resistance that is all mesh error nothing follows for what stands beside it: with the error as a part
/// of the whole response, an offset of a share of the load would explain anything.
TEST(SolvedRolling_behaviour, a_case_without_a_resistance_of_its_own_lends_no_room_to_others) {
  RollingStandIn stand_in;
  stand_in.lost = stand_in.off_by = 1e-6;
  const Diagnosis d = diagnosed_rolling(
      rolled([&](double f, double) { return RollingStandIn::rolls(0, 0, 0.05, f); }, 0.01), stand_in);
  EXPECT_EQ(d.verdict, Verdict::explained) << d.in_words;
  ASSERT_EQ(d.left_out.size(), 1u) << d.in_words;
  EXPECT_EQ(d.left_out[0].id, "rolling_adhesion_hysteresis");
  EXPECT_LE(stand_in.paths.size(),
            9u);  // as it is and twice with what it lacks, which serves all larger sets
  EXPECT_NEAR(d.left_out[0].parameters[0].value / 0.05, 1, 0.05);
}

/// As smooth elastic bodies roll on a mesh: next to nothing at small loads, a third of what is measured at
/// the largest. A factor from that would weigh what adhesion adds by a quarter at small loads.
TEST(SolvedRolling_behaviour, noise_of_the_mesh_that_grows_with_the_load_hides_no_adhesion) {
  RollingStandIn stand_in;
  stand_in.lost = 1e-7;
  stand_in.spurious = 17e-9;
  const Diagnosis d = diagnosed_rolling(
      rolled([&](double f, double) { return RollingStandIn::rolls(0, 0, 0.06, f); }, 0.01), stand_in);
  ASSERT_EQ(d.left_out.size(), 1u) << d.in_words;
  EXPECT_EQ(d.left_out[0].id, "rolling_adhesion_hysteresis") << d.in_words;
  EXPECT_LE(stand_in.paths.size(),
            9u);  // as it is and twice with what it lacks, which serves all larger sets
  EXPECT_LT(d.left_out[0].parameters[0].low, 0.06);
  EXPECT_GT(d.left_out[0].parameters[0].high, 0.06);
}

TEST(SolvedRolling_behaviour, work_that_opening_takes_is_named_with_its_entry) {
  for (const double closing : {0.0, 0.08}) {
    constexpr double lost = 0.05;
    RollingStandIn stand_in;
    stand_in.closing = closing;
    const Diagnosis d = diagnosed_rolling(
        rolled([&](double f,
                   double) { return RollingStandIn::rolls(stand_in.lost, closing, closing + lost, f); },
               0.01),
        stand_in);
    EXPECT_EQ(d.verdict, Verdict::explained) << d.in_words;
    ASSERT_EQ(d.left_out.size(), 1u) << d.in_words;
    EXPECT_EQ(d.left_out[0].id, "rolling_adhesion_hysteresis");
    EXPECT_EQ(d.left_out[0].form, "entries of the case");
    EXPECT_EQ(stand_in.changed.count("Interface/Work of adhesion on separation"), 1u);
    bool found = false;
    for (const auto& entry : d.corrected()) {
      if (entry.entry != "Interface/Work of adhesion on separation") continue;
      found = true;
      EXPECT_NEAR(entry.value / (closing + lost), 1, 0.05);
      EXPECT_LT(entry.low, closing + lost);
      EXPECT_GT(entry.high, closing + lost);
    }
    EXPECT_TRUE(found) << d.in_words;
  }
}

/// What the case's own wafers say of roughness is the solution's; the force beside it is the same on each.
TEST(SolvedRolling_behaviour, a_force_that_no_load_changes_is_told_on_surfaces_that_roll_otherwise) {
  constexpr double beside = 0.6 * uN;
  RollingStandIn stand_in;
  stand_in.lost = 6e-3;
  stand_in.rms = 1.5 * nm;
  const Diagnosis d = diagnosed_rolling(
      rolled([&](double f, double rms) { return stand_in.lost * std::exp(-rms / (2 * nm)) * f + beside; },
             0.01, {0.3 * nm, 1.5 * nm, 2.7 * nm}),
      stand_in);
  ASSERT_EQ(d.left_out.size(), 1u) << d.in_words;
  EXPECT_EQ(d.left_out[0].id, "constant_lateral_force");
  EXPECT_EQ(d.left_out[0].form, "reduced law beside the solution");
  EXPECT_NEAR(d.left_out[0].parameters[0].value / beside, 1, 0.1);
}

/// Local friction summed over rings of Hertz' pressure, which all slip.
double spun_moment(double friction, double load, double attraction = 0) {
  const double a = rolled_contact.contact_radius(load), peak = 1.5 * (load + attraction) / (M_PI * a * a);
  constexpr int rings = 2000;
  double moment = 0;
  for (int i = 0; i < rings; ++i) {
    const double x = (i + 0.5) / rings;
    moment += friction * peak * std::sqrt(1 - x * x) * 2 * M_PI * x * x * a * a * a / rings;
  }
  return moment;
}

class SpinningStandIn : public RollingStandIn {
 public:
  double friction = 0.3;
  SimulatedBodies bodies() const override {
    SimulatedBodies b = RollingStandIn::bodies();
    b.friction_coefficient = friction;
    b.adhesion_range = 0;
    return b;
  }
  std::vector<SolvedMotion> move(const std::vector<CaseChange>& changes,
                                 const std::vector<MotionProtocol>& protocols, bool) override {
    double mu = friction, attraction = 0;
    for (const auto& change : changes) {
      if (change.entry == "Interface/Friction coefficient") mu = change.value;
      if (change.entry == "Interface/Attraction force") attraction = change.value;
    }
    std::vector<SolvedMotion> motions;
    for (const auto& protocol : protocols) {
      EXPECT_EQ(protocol.motion, Motion::torsion);
      SolvedMotion m;
      m.normal_force = protocol.normal_force;
      m.resistance = 1.01 * spun_moment(mu, m.normal_force, attraction) / rolled_radius;
      m.resistance_error = 0.01 * m.resistance;
      motions.push_back(m);
    }
    return motions;
  }
};

TEST(SolvedTorsion_behaviour, local_friction_and_attraction_are_told_from_the_moment) {
  const auto spun = [](double friction, double attraction) {
    Recording r = rolled(
        [&](double f, double) { return 1.01 * spun_moment(friction, f, attraction) / rolled_radius; }, 0.005);
    r.mode = Motion::torsion;
    r.indenter.reset();
    r.simulation.torsion = "constant";
    return r;
  };
  SpinningStandIn stand_in;
  EXPECT_EQ(diagnosed_rolling(spun(0.3, 0), stand_in).verdict, Verdict::no_mismatch);
  const Diagnosis rougher = diagnosed_rolling(spun(0.41, 0), stand_in);
  EXPECT_EQ(rougher.verdict, Verdict::explained) << rougher.in_words;
  ASSERT_EQ(rougher.left_out.size(), 1u) << rougher.in_words;
  EXPECT_EQ(rougher.left_out[0].id, "friction_coefficient");
  EXPECT_NEAR(rougher.left_out[0].parameters[0].value / 0.41, 1, 0.02);
  const Diagnosis attracted = diagnosed_rolling(spun(0.3, 60 * uN), stand_in);
  EXPECT_EQ(attracted.verdict, Verdict::explained) << attracted.in_words;
  ASSERT_EQ(attracted.left_out.size(), 1u) << attracted.in_words;
  EXPECT_EQ(attracted.left_out[0].id, "adhesion_offset");
  EXPECT_NEAR(attracted.left_out[0].parameters[0].value / (60 * uN), 1, 0.1);
}

TEST(SolvedRolling_behaviour, a_groove_and_a_rail_are_refused) {
  RollingStandIn stand_in;
  Recording groove = rolled([](double f, double) { return 1e-3 * f; }, 0.01);
  groove.tables[0].columns["rail_angle"].assign(groove.tables[0].columns["normal_force"].size(), 0.6);
  EXPECT_NE(message_of<InputError>([&] { diagnosed_rolling(groove, stand_in); }).find("rolls in a groove"),
            std::string::npos);
  Recording rail = rolled([](double f, double) { return 1e-3 * f; }, 0.01);
  rail.mode = Motion::rail;
  EXPECT_NE(message_of<InputError>([&] { diagnosed_rolling(rail, stand_in); }).find("recording is of a rail"),
            std::string::npos);
}

}  // namespace
}  // namespace asperity

// Recordings of sliding whose simulation is a case: a stand-in for finite elements, whose attraction over a
// range presses by another law than the reduced one, beside friction loops of Mindlin and Deresiewicz in
// closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <string>

#include "core/error.h"
#include "core/shear_moduli.h"
#include "diagnosis/conceal/masing_contact.h"
#include "diagnosis/diagnose.h"
#include "diagnosis/mapping/solved_resistance.h"
#include "tests/diagnosis/support/made_recording.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::message_of;
using test::nm;
using test::uN;

const ElasticBody silica{71e9, 0.17}, wafer_of_silicon{179e9, 0.25};
constexpr double sphere_size = 8.5e-6;
const Hertz smooth_contact{reduced_modulus(silica, wafer_of_silicon), sphere_size};
const std::vector<double> loads_of_test{40 * uN, 80 * uN, 160 * uN, 300 * uN};

double full_stiffness(double load) {
  return 8 * reduced_shear_modulus(silica, wafer_of_silicon) * smooth_contact.contact_radius(load);
}
double contact_area(double load) { return M_PI * std::pow(smooth_contact.contact_radius(load), 2); }

class SlidingStandIn : public ForwardModel {
 public:
  double friction = 0.3;
  double softer = 1;              ///< lateral stiffness over the smooth contact's
  double range = 0;               ///< of attraction, where the case gives one [m]
  double attracts = 0;            ///< beyond the contact, of the case [N]
  double adheres = 0;             ///< work of adhesion of the case [J/m^2]
  std::string cannot_solve{};     ///< an entry
  std::vector<double> slid{};     ///< loads
  std::set<std::string> tried{};  ///< entries, those that are changed together in one line

  SimulatedBodies bodies() const override {
    SimulatedBodies b{silica, wafer_of_silicon, sphere_size};
    b.friction_coefficient = friction;
    b.adhesion_range = range;
    b.attraction_force = attracts;
    b.work_of_adhesion = adheres;
    return b;
  }
  std::vector<SolvedResponse> solve(const std::vector<CaseChange>&, const std::vector<LoadingProtocol>&,
                                    const EnoughOfIt&) override {
    throw WorkError("nothing is pressed alone here");
  }
  /// Attraction over a range presses around and across the contact, the more the larger that is (Derjaguin
  /// 1934); the area that shears is 5 % below Hertz'.
  double pressed_by(double work, double load) const {
    return 0.9 * (2 * M_PI * sphere_size * work + work / range * contact_area(load));
  }
  static double sheared_area(double load) { return 0.95 * contact_area(load); }
  std::vector<SolvedMotion> move(const std::vector<CaseChange>& changes,
                                 const std::vector<MotionProtocol>& protocols, bool) override {
    double mu = friction, strength = 0, work = adheres, attraction = attracts;
    std::string together;
    for (const auto& change : changes) {
      together += "[" + change.entry + "]";
      if (change.entry == cannot_solve) throw WorkError("the steps did not converge");
      if (change.entry == "Interface/Friction coefficient")
        mu = change.value;
      else if (change.entry == "Interface/Adhesive shear strength" ||
               change.entry == "Interface/Shear strength")
        strength = change.value;
      else if (change.entry == "Interface/Work of adhesion")
        work = change.value;
      else if (change.entry == "Interface/Attraction force")
        attraction = change.value;
      else
        ADD_FAILURE() << change.entry;
    }
    tried.insert(together);
    std::vector<SolvedMotion> motions;
    for (const auto& protocol : protocols) {
      SolvedMotion s;
      s.normal_force = protocol.normal_force;
      s.resistance = mu * (s.normal_force + attraction + (work > 0 ? pressed_by(work, s.normal_force) : 0)) +
                     strength * sheared_area(s.normal_force);
      s.resistance_error = 0.002 * s.resistance;
      s.lateral_stiffness = softer * full_stiffness(s.normal_force);
      s.lateral_stiffness_error = 0.013 * s.lateral_stiffness;
      s.source = "stand-in";
      motions.push_back(s);
      slid.push_back(s.normal_force);
      EXPECT_GT(protocol.path, 1.5 * mu * s.normal_force / full_stiffness(s.normal_force));
    }
    return motions;
  }
};

/// One and a half loops at each load; `limit` of the load; noise 0.5 % of the largest force.
Recording looped(const std::function<double(double)>& limit, double softer = 1, double compliance = 0) {
  Recording r;
  r.mode = Motion::sliding;
  r.particle = test::borosilicate();
  r.substrate = test::silicon();
  RecordingTable table;
  table.file = "loops.csv";
  table.control = {"lateral_displacement", "normal_force"};
  table.response = "lateral_force";
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0, 0.005 * limit(loads_of_test.back()));
  double run = 0;
  for (const double load : loads_of_test) {
    hidden::MasingContact contact(softer * full_stiffness(load), limit(load));
    ++run;
    double x = 0;
    const auto record = [&](double to, const char* segment) {
      constexpr int count = 100;
      const double from = x;
      for (int i = 1; i <= count; ++i) {
        x = from + (to - from) * i / count;
        const double force = contact.force(x);
        table.columns["run"].push_back(run);
        table.columns["time"].push_back(0.1 * static_cast<double>(table.segment.size()));
        table.columns["normal_force"].push_back(load);
        table.columns["lateral_displacement"].push_back(x + compliance * force);
        table.columns["lateral_force"].push_back(force + noise(random));
        table.segment.push_back(segment);
      }
    };
    record(100 * nm, "forth");
    record(0, "back");
    record(100 * nm, "forth again");
  }
  r.tables = {table};
  return r;
}

Diagnosis diagnosed_by(const Recording& recording, SlidingStandIn& simulation) {
  DiagnoseOptions options;
  options.simulation = &simulation;
  return diagnose(recording, options);
}

const CorrectedEntry* entry_of(const Diagnosis& d, const std::string& name) {
  static std::vector<CorrectedEntry> list;
  list = d.corrected();
  for (const auto& e : list)
    if (e.entry == name) return &e;
  return nullptr;
}

void expect_found(const Diagnosis& d, const std::string& name, double truth, double within) {
  const CorrectedEntry* entry = entry_of(d, name);
  ASSERT_NE(entry, nullptr) << d.in_words;
  EXPECT_NEAR(entry->value / truth, 1, within) << name;
  EXPECT_LT(entry->low, truth) << name;
  EXPECT_GT(entry->high, truth) << name;
}

TEST(SolvedSliding_behaviour, the_case_that_slides_as_recorded_needs_nothing_and_is_slid_at_three_loads) {
  SlidingStandIn rough;
  rough.softer = 0.6;
  const Diagnosis d = diagnosed_by(looped([](double f) { return 0.3 * f; }, rough.softer), rough);
  EXPECT_EQ(d.verdict, Verdict::no_mismatch) << d.in_words;
  ASSERT_EQ(rough.slid.size(), 3u);
  EXPECT_NEAR(rough.slid[0] / (300 * uN), 1, 1e-6);
  EXPECT_NEAR(rough.slid[1] / (80 * uN), 1, 1e-6);
  EXPECT_NEAR(rough.slid[2] / (40 * uN), 1, 1e-6);
  EXPECT_EQ(d.simulation.solves, 3);
  const auto model = nlohmann::json::parse(diagnosis_json(d))["forward_model"];
  EXPECT_EQ(model["kind"], "finite_elements");
  EXPECT_NEAR(model["discretisation_error"]["value"].get<double>(), 0.002, 1e-9);
  EXPECT_EQ(model["discretisation_error"]["unit"], "");
}

TEST(SolvedSliding_behaviour, local_friction_other_than_the_case_says_is_named) {
  SlidingStandIn stand_in;
  const Diagnosis d = diagnosed_by(looped([](double f) { return 0.21 * f; }), stand_in);
  EXPECT_EQ(d.verdict, Verdict::explained) << d.in_words;
  ASSERT_EQ(d.left_out.size(), 1u) << d.in_words;
  EXPECT_EQ(d.left_out[0].id, "friction_coefficient");
  expect_found(d, "Interface/Friction coefficient", 0.21, 0.01);
  EXPECT_LT(d.improved.held_out_chi2_reduced, 1.5);
}

TEST(SolvedSliding_behaviour, attraction_beyond_the_contact_is_added_to_what_the_case_has_of_it) {
  constexpr double whole = 35 * uN;
  for (const double of_case : {0 * uN, 20 * uN, 60 * uN}) {
    SlidingStandIn stand_in;
    stand_in.attracts = of_case;
    const Diagnosis d = diagnosed_by(looped([&](double f) { return 0.3 * (f + whole); }), stand_in);
    EXPECT_EQ(d.verdict, Verdict::explained) << d.in_words;
    ASSERT_EQ(d.left_out.size(), 1u) << d.in_words;
    EXPECT_EQ(d.left_out[0].id, "adhesion_offset");
    expect_found(d, "Interface/Attraction force", whole, 0.03);
  }
}

TEST(SolvedSliding_behaviour, attraction_that_the_recording_does_not_have_comes_out_as_none) {
  SlidingStandIn stand_in;
  stand_in.attracts = 20 * uN;
  const Diagnosis d = diagnosed_by(looped([](double f) { return 0.3 * f; }), stand_in);
  EXPECT_EQ(d.verdict, Verdict::explained) << d.in_words;
  ASSERT_EQ(d.left_out.size(), 1u) << d.in_words;
  const CorrectedEntry* entry = entry_of(d, "Interface/Attraction force");
  ASSERT_NE(entry, nullptr) << d.in_words;
  EXPECT_LT(entry->value, 0.6 * uN);
}

/// Local friction off by less than reduced laws may be off is still its own finding beside the attraction.
TEST(SolvedSliding_behaviour, attraction_beside_another_local_friction) {
  SlidingStandIn stand_in;
  const Diagnosis d = diagnosed_by(looped([&](double f) { return 0.315 * (f + 35 * uN); }), stand_in);
  EXPECT_EQ(d.verdict, Verdict::explained) << d.in_words;
  ASSERT_EQ(d.left_out.size(), 2u) << d.in_words;
  expect_found(d, "Interface/Friction coefficient", 0.315, 0.01);
  expect_found(d, "Interface/Attraction force", 35 * uN, 0.05);
}

/// Beside the attraction it is less than the mesh is off by, until both are solved.
TEST(SolvedSliding_behaviour, a_set_is_solved_with_another_local_friction_too_where_laws_do_not_tell) {
  SlidingStandIn stand_in;
  const Diagnosis d = diagnosed_by(looped([&](double f) { return 0.3003 * (f + 35 * uN); }), stand_in);
  EXPECT_EQ(d.verdict, Verdict::explained) << d.in_words;
  ASSERT_EQ(d.left_out.size(), 1u) << d.in_words;
  EXPECT_EQ(d.left_out[0].id, "adhesion_offset");
  EXPECT_EQ(stand_in.tried.count("[Interface/Attraction force]"), 1u);
  EXPECT_EQ(stand_in.tried.count("[Interface/Friction coefficient][Interface/Attraction force]"), 1u);
}

/// Two effects leave next to noise here, and the case's friction is still looked at beside them.
TEST(SolvedSliding_behaviour, another_local_friction_beside_attraction_and_a_compliant_mount) {
  constexpr double compliance = 1e-4;
  SlidingStandIn stand_in;
  const Diagnosis d =
      diagnosed_by(looped([](double f) { return 0.315 * (f + 35 * uN); }, 1, compliance), stand_in);
  ASSERT_EQ(d.left_out.size(), 3u) << d.in_words;
  expect_found(d, "Interface/Friction coefficient", 0.315, 0.01);
  expect_found(d, "Interface/Attraction force", 35 * uN, 0.05);
}

TEST(SolvedSliding_behaviour, attraction_over_the_case_s_range_gets_the_work_that_presses_so) {
  constexpr double work = 0.06;
  for (const double of_case : {0.0, 0.15}) {
    SlidingStandIn stand_in;
    stand_in.range = 2 * nm;
    stand_in.adheres = of_case;
    const Diagnosis d =
        diagnosed_by(looped([&](double f) { return 0.3 * (f + stand_in.pressed_by(work, f)); }), stand_in);
    EXPECT_EQ(d.verdict, Verdict::explained) << d.in_words;
    ASSERT_EQ(d.left_out.size(), 1u) << d.in_words;
    EXPECT_EQ(d.left_out[0].id, "adhesion_offset");
    EXPECT_EQ(d.left_out[0].form, "entries of the case");
    expect_found(d, "Interface/Work of adhesion", work, 0.05);
  }
}

TEST(SolvedSliding_behaviour, shear_strength_of_the_interface_in_place_of_a_coefficient_or_beside_it) {
  constexpr double strength = 3e8;
  SlidingStandIn stand_in;
  const Diagnosis area =
      diagnosed_by(looped([&](double f) { return strength * SlidingStandIn::sheared_area(f); }), stand_in);
  ASSERT_EQ(area.left_out.size(), 1u) << area.in_words;
  EXPECT_EQ(area.left_out[0].id, "area_proportional_friction") << area.in_words;
  expect_found(area, "Interface/Shear strength", strength, 0.02);
  const CorrectedEntry* coefficient = entry_of(area, "Interface/Friction coefficient");
  ASSERT_NE(coefficient, nullptr);
  EXPECT_EQ(coefficient->value, 0);

  SlidingStandIn other;
  const Diagnosis both = diagnosed_by(
      looped([&](double f) { return 0.3 * f + strength * SlidingStandIn::sheared_area(f); }), other);
  ASSERT_EQ(both.left_out.size(), 1u) << both.in_words;
  EXPECT_EQ(both.left_out[0].id, "two_term_friction") << both.in_words;
  expect_found(both, "Interface/Adhesive shear strength", strength, 0.03);
}

/// A stiffness that is off by no more than the mesh is no compliance of the mount.
TEST(SolvedSliding_behaviour, what_the_mesh_may_be_off_by_in_stiffness_is_not_named) {
  SlidingStandIn stiff;
  stiff.softer = 1.015;
  const Diagnosis d = diagnosed_by(looped([](double f) { return 0.3 * f; }), stiff);
  EXPECT_EQ(d.verdict, Verdict::no_mismatch) << d.in_words;
}

TEST(SolvedSliding_behaviour, a_compliant_mount_is_the_measurement_s_and_changes_no_entry) {
  SlidingStandIn stand_in;
  const double compliance = 1e-4;
  const Diagnosis d = diagnosed_by(looped([](double f) { return 0.3 * f; }, 1, compliance), stand_in);
  EXPECT_EQ(d.verdict, Verdict::explained) << d.in_words;
  ASSERT_EQ(d.left_out.size(), 1u) << d.in_words;
  EXPECT_EQ(d.left_out[0].id, "lateral_compliance");
  EXPECT_TRUE(d.corrected().empty());
}

TEST(SolvedSliding_behaviour, what_cannot_be_slid_leaves_the_answer_open) {
  SlidingStandIn stand_in;
  stand_in.cannot_solve = "Interface/Attraction force";
  const Diagnosis d = diagnosed_by(looped([](double f) { return 0.3 * (f + 35 * uN); }), stand_in);
  EXPECT_NE(d.verdict, Verdict::explained) << d.in_words;
  EXPECT_NE(d.verdict, Verdict::no_mismatch) << d.in_words;
}

TEST(SolvedSliding_behaviour, recordings_of_several_surfaces_and_cases_without_a_coefficient_are_refused) {
  Recording several = looped([](double f) { return 0.3 * f; });
  auto& roughness = several.tables[0].columns["rms_roughness"];
  for (std::size_t i = 0; i < several.tables[0].rows(); ++i) roughness.push_back(i < 200 ? 1e-9 : 2e-9);
  SlidingStandIn stand_in;
  EXPECT_NE(message_of<InputError>([&] { diagnosed_by(several, stand_in); }).find("varies rms_roughness"),
            std::string::npos);
  SlidingStandIn none;
  none.friction = 0;
  EXPECT_NE(message_of<InputError>([&] {
              diagnosed_by(looped([](double f) { return 0.3 * f; }), none);
            }).find("Interface/Friction coefficient"),
            std::string::npos);
}

}  // namespace
}  // namespace asperity

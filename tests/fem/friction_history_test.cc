// Friction that depends on the slip of each point: a static peak that comes back after a reversal, and
// running-in, on smooth spheres that slip as a whole.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/error.h"
#include "fem/interface/friction/adhesive_shear_and_load.h"
#include "fem/interface/friction/running_in.h"
#include "fem/interface/friction/static_peak.h"
#include "tests/fem/support/glass_sphere.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace asperity;

constexpr double pressed = 100e-6;  // normal load [N]

CaseInput slid(const std::filesystem::path& folder, const std::string& friction, const std::string& distances,
               const std::string& spacing = "32 nm") {
  return test::glass_case(folder, friction,
                          "set Type = sliding\n set Normal load = 100 uN\n set Load steps = 3\n"
                          " set Unload = false\n" +
                              distances,
                          "set Interface spacing = " + spacing + "\n set Contact region = 320 nm\n");
}

/// Friction over load of a sphere that slips as a whole, whose points have slipped by `shift` less what the
/// bodies give way, (1 - r^2/(2 a^2)) 3 C/(16 a) per lateral force (Mindlin 1949; shear in proportion to
/// Hertz' pressure); `before`: lateral force that this give was under at first, against the present one.
double friction_after(double shift, double before, double contact_radius,
                      const std::function<double(double)>& coefficient) {
  const double give = 3 * test::GlassSphere::lateral_compliance / (16 * contact_radius);
  double ratio = coefficient(shift);
  for (int update = 0; update < 100; ++update) {
    constexpr int rings = 200;
    double sum = 0;
    for (int k = 0; k < rings; ++k) {
      const double t = (k + 0.5) / rings;  // (r/a)^2, of even share of the area
      const double slip = shift - give * (1 - 0.5 * t) * (pressed * ratio + before);
      sum += 1.5 * std::sqrt(1 - t) / rings * coefficient(std::max(0.0, slip));
    }
    ratio = sum;
  }
  return ratio;
}

struct SlidSphere {
  std::vector<double> ratio, shift, sticking;
  double contact_radius, farthest, turning_force;
  explicit SlidSphere(const test::SolvedExperiment& s)
      : ratio(s.history.numbers("lateral_force [N]")),
        shift(s.history.numbers("lateral_displacement [m]")),
        sticking(s.history.numbers("sticking_share")),
        contact_radius(std::sqrt(
            std::cbrt(3 * pressed * test::GlassSphere::radius / (4 * test::GlassSphere::reduced_modulus)) *
            s.history.numbers("contact_radius [m]").back())) {
    const auto turn = std::max_element(shift.begin(), shift.end()) - shift.begin();
    farthest = shift[turn], turning_force = ratio[turn];
    for (double& q : ratio) q /= pressed;
  }
  /// Of full slip on either way, the largest relative error against a coefficient as a function of the slip
  /// of its own way and of the way before.
  double error(bool back, const std::function<double(double, double)>& coefficient) const {
    test::Largest error;
    bool turned = false;
    int counted = 0;
    for (std::size_t k = 0; k < ratio.size(); ++k) {
      const bool backwards = turned;
      turned = turned || shift[k] == farthest;
      if (backwards != back || sticking[k] > 0 || shift[k] <= 0) continue;
      const double expected =
          back ? -friction_after(farthest - shift[k], turning_force, contact_radius,
                                 [&](double s) { return coefficient(s, farthest); })
               : friction_after(shift[k], 0, contact_radius, [&](double s) { return coefficient(s, 0); });
      error.count(ratio[k] / expected - 1);
      ++counted;
    }
    EXPECT_GE(counted, 3);
    return error;
  }
};

test::Verified of_sliding(const std::string& what, const char* source) { return {"Sliding", what, source}; }

TEST(StaticPeak_analytic, fades_with_slip_and_comes_back_after_a_reversal) {
  const test::TemporaryFolder folder;
  const auto s =
      test::solve_experiment(slid(folder.path,
                                  "set Friction coefficient = 0.2\n set Static friction coefficient = 0.3\n"
                                  " set Friction decay length = 80 nm\n",
                                  "set Distance = 200 nm\n set Return distance = 150 nm\n"),
                             folder.path / "solved");
  const SlidSphere slid(s);
  const auto law = [](double slip, double) { return 0.2 + 0.1 * std::exp(-slip / 80e-9); };
  const char* source = "law and Mindlin (1949)";
  EXPECT_TRUE(of_sliding("static peak that fades over 80 nm, a/h 8: friction beyond full slip", source)
                  .within(1 + slid.error(false, law), 1, 0.015));
  EXPECT_TRUE(of_sliding("the same after the reversal", source).within(1 + slid.error(true, law), 1, 0.015));
  EXPECT_TRUE(of_sliding("the same: its peak", "mu_s P")
                  .within(*std::max_element(slid.ratio.begin(), slid.ratio.end()), 0.3, 0.02));
  EXPECT_TRUE(of_sliding("the same: its peak on the way back", "mu_s P")
                  .within(-*std::min_element(slid.ratio.begin(), slid.ratio.end()), 0.3, 0.02));
  EXPECT_TRUE(test::leaves_no_energy_open("Sliding", "static peak that fades over 80 nm", s));
}

/// Both directions: friction that grows and friction that falls with the path, which the reversal does not
/// take back.
TEST(RunningIn_analytic, goes_on_with_the_whole_path_up_or_down) {
  const test::TemporaryFolder folder;
  for (const auto& [name, fresh, run_in] : {std::tuple{"up", 0.2, 0.35}, std::tuple{"down", 0.3, 0.15}}) {
    const auto s = test::solve_experiment(
        slid(folder.path,
             "set Friction coefficient = " + std::to_string(fresh) + "\n set Run-in friction coefficient = " +
                 std::to_string(run_in) + "\n set Running-in length = 100 nm\n",
             "set Distance = 120 nm\n set Return distance = 100 nm\n"),
        folder.path / name);
    const SlidSphere slid(s);
    const double give = 3 * test::GlassSphere::lateral_compliance / (16 * slid.contact_radius);
    const double slipped = 0.8 * give * slid.turning_force;  // less than the way there, on average
    const auto law = [&, fresh = fresh, run_in = run_in](double slip, double before) {
      const double path = slip + (before > 0 ? before - slipped : 0.0);
      return run_in + (fresh - run_in) * std::exp(-path / 100e-9);
    };
    const std::string what = std::string("running-in over 100 nm, ") + name + ": friction ";
    EXPECT_TRUE(of_sliding(what + "on the way there", "law and Mindlin (1949)")
                    .within(1 + slid.error(false, law), 1, 0.015));
    EXPECT_TRUE(of_sliding(what + "on the way back", "law and Mindlin (1949)")
                    .within(1 + slid.error(true, law), 1, 0.015));
    EXPECT_TRUE(test::leaves_no_energy_open("Sliding", std::string("running-in ") + name, s));
  }
}

TEST(StaticPeak_behaviour, is_refused_where_the_contact_would_jump) {
  const test::TemporaryFolder folder;
  const auto decaying_over = [&](const char* length) {
    return slid(folder.path,
                std::string("set Friction coefficient = 0.2\n set Static friction coefficient = 0.5\n") +
                    " set Friction decay length = " + length + "\n",
                "set Distance = 100 nm\n");
  };
  EXPECT_NO_THROW(check_case(decaying_over("20 nm")));
  const std::string message = test::message_of<InputError>([&] { check_case(decaying_over("1 nm")); });
  EXPECT_NE(message.find("it would jump (stick-slip); raise the length"), std::string::npos) << message;
}

fem::InterfacePoint slipped_point(double pressure, double slip, double path) {
  fem::InterfacePoint point;
  point.pressure = pressure, point.slip = {0.6 * slip, -0.8 * slip}, point.slip_path = path;
  return point;
}

TEST(FrictionLaws_analytic, a_static_peak_is_that_of_the_slip_since_the_point_stuck) {
  const fem::StaticPeak law(0.2, 0.5, 10e-9);
  double history = 0;
  const auto coefficient = [&](double slip) {
    return law.limit(slipped_point(1e9, slip, 1), &history).stress / 1e9;
  };
  EXPECT_DOUBLE_EQ(coefficient(0), 0.5);
  law.remember(slipped_point(1e9, 4e-9, 1), &history);
  EXPECT_NEAR(coefficient(6e-9), 0.2 + 0.3 / M_E, 1e-12);
  // At rest within a step the limit stays; the next one finds the peak.
  EXPECT_NEAR(coefficient(0), 0.2 + 0.3 * std::exp(-0.4), 1e-12);
  law.remember(slipped_point(1e9, 0, 1), &history);
  EXPECT_DOUBLE_EQ(coefficient(0), 0.5);
  EXPECT_DOUBLE_EQ(law.steepest_fall(1e9), 0.3e9 / 10e-9);
  EXPECT_THROW(fem::StaticPeak(0.5, 0.2, 1e-9), InputError);
}

TEST(FrictionLaws_analytic, running_in_is_that_of_the_whole_path) {
  for (const auto& [fresh, run_in] : {std::pair{0.2, 0.5}, std::pair{0.5, 0.2}}) {
    const fem::RunningIn law(fresh, run_in, 10e-9);
    EXPECT_DOUBLE_EQ(law.initial_limit(1e9).stress, fresh * 1e9);
    EXPECT_NEAR(law.limit(slipped_point(1e9, 1e-9, 10e-9), nullptr).stress,
                (run_in + (fresh - run_in) / M_E) * 1e9, 1);
    EXPECT_NEAR(law.limit(slipped_point(1e9, 0, 1e-6), nullptr).stress, run_in * 1e9, 1);
    EXPECT_DOUBLE_EQ(law.steepest_fall(1e9), std::max(0.0, fresh - run_in) * 1e9 / 10e-9);
  }
}

TEST(FrictionLaws_analytic, adhesive_shear_is_there_without_load_and_ends_at_its_cap) {
  const fem::AdhesiveShearAndLoad law(50e6, 0.3), capped(50e6, 0.3, 200e6);
  EXPECT_DOUBLE_EQ(law.initial_limit(0).stress, 0);
  EXPECT_DOUBLE_EQ(law.initial_limit(50e6).stress, 65e6);
  EXPECT_DOUBLE_EQ(law.initial_limit(10e6).stress, 20e6);  // at the edge
  EXPECT_DOUBLE_EQ(fem::AdhesiveShearAndLoad(0, 3).initial_limit(10e6).stress, 30e6);
  EXPECT_DOUBLE_EQ(law.initial_limit(1e9).stress, 350e6);
  EXPECT_DOUBLE_EQ(law.initial_limit(std::numeric_limits<double>::infinity()).slope, 0.3);
  EXPECT_DOUBLE_EQ(capped.initial_limit(0.4e9).stress, 170e6);
  EXPECT_DOUBLE_EQ(capped.initial_limit(1e9).stress, 200e6);
  EXPECT_DOUBLE_EQ(capped.initial_limit(1e9).slope, 0);
  EXPECT_THROW(fem::AdhesiveShearAndLoad(50e6, 0.3, 40e6), InputError);
}

/// Friction of the whole contact: tau0 over its area, and mu of the load.
TEST(AdhesiveShear_analytic, of_a_smooth_sphere_adds_its_area_to_its_load) {
  const test::TemporaryFolder folder;
  const auto s = test::solve_experiment(
      slid(folder.path, "set Friction coefficient = 0.1\n set Adhesive shear strength = 100 MPa\n",
           "set Distance = 30 nm\n set Reverse = false\n", "20 nm"),
      folder.path / "solved");
  const double a =
      std::cbrt(3 * pressed * test::GlassSphere::radius / (4 * test::GlassSphere::reduced_modulus));
  EXPECT_TRUE(
      of_sliding("adhesive shear and load, a/h 13: friction", "tau0 pi a^2 + mu P, Hertz")
          .within(s.history.numbers("lateral_force [N]").back(), 100e6 * M_PI * a * a + 0.1 * pressed, 0.05));
  EXPECT_TRUE(test::leaves_no_energy_open("Sliding", "adhesive shear and load", s));
}

}  // namespace

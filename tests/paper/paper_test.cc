// The paper's numbers recomputed from its Table 1 and 2; expected values were worked out independently of
// this program.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "paper/analysis.h"
#include "tests/engines/canonical_contact.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

const Published& published() {
  static const Published data = read_published(test::paper_run("published"));
  return data;
}

const PaperAnalysis& analysis() {
  static const PaperAnalysis all = analyse_paper(published());
  return all;
}

double computed(const std::string& section, const std::string& what) {
  return analysis().number(section, what).computed->value;
}

double sigma(const std::string& section, const std::string& what) {
  const PaperNumber& number = analysis().number(section, what);
  return deviation_in_sigma(*number.computed, *number.published);
}

struct Pair {
  const char* plane;
  double E, G, printed_G, a100, delta100, a1000, a3000, p0, p_mean;  // GPa, um, nm, GPa
};

TEST(PaperElasticity_other_code, moduli_contact_radii_and_pressures_of_the_three_pairs) {
  const std::string in = "Hertz and Mindlin";
  for (const Pair& pair :
       {Pair{"silicon", 52.8684, 11.7989, 10.8668, 0.2293, 6.186, 0.4940, 0.7125, 2.821, 1.881},
        Pair{"diamond", 68.7268, 15.6407, 14.5543, 0.2101, 5.194, 0.4527, 0.6529, 3.361, 2.240},
        Pair{"fused quartz", 36.5565, 8.2901, 7.6967, 0.2593, 7.912, 0.5587, 0.8058, 2.206, 1.471}}) {
    const std::string on = std::string("sphere on ") + pair.plane + ": ";
    EXPECT_NEAR(computed(in, on + "E*") / 1e9, pair.E, 5e-5 + 1e-9);
    EXPECT_NEAR(computed(in, on + "G*") / 1e9, pair.G, 5e-5 + 1e-9);
    EXPECT_NEAR(computed(in, on + "G* with (2 - nu^2)") / 1e9, pair.printed_G, 5e-5 + 1e-9);
    EXPECT_NEAR(computed(in, on + "a at 100 uN") / 1e-6, pair.a100, 5e-5);
    // One unit of the last digit: on quartz it is 7.91149 nm, and 7.912 was rounded twice.
    EXPECT_NEAR(computed(in, on + "delta at 100 uN") / 1e-9, pair.delta100, 1e-3);
    EXPECT_NEAR(computed(in, on + "a at 1 mN") / 1e-6, pair.a1000, 5.1e-5);
    EXPECT_NEAR(computed(in, on + "a at 3 mN") / 1e-6, pair.a3000, 5.1e-5);
    EXPECT_NEAR(computed(in, on + "p0 at 3 mN") / 1e9, pair.p0, 5.1e-4);
    EXPECT_NEAR(computed(in, on + "mean pressure at 3 mN") / 1e9, pair.p_mean, 5.1e-4);
  }
  EXPECT_NEAR(computed(in, "sphere on silicon: 8 G* a at 100 uN"), 2.1645e4, 1);
  EXPECT_NEAR(computed(in, "sphere on diamond: 8 G* a at 100 uN"), 2.629e4, 5);
  EXPECT_NEAR(computed(in, "G* with silicon's nu taken as 0.17") / 1e9, 11.8715, 5.1e-5);
  EXPECT_NEAR(computed(in, "sphere on silicon: load of first yield, p0 = 1.6 Y") / 1e-3, 14.8, 0.05);
  EXPECT_NEAR(computed(in, "sphere on diamond: load of first yield, p0 = 1.6 Y") / 1e-3, 8.7, 0.05);
  EXPECT_NEAR(computed(in, "p0 on fused quartz at 10 mN") / 1e9, 3.30, 0.005);
}

TEST(PaperElasticity_other_code, damping_restitution_and_the_two_ways_to_a_stiffer_sphere) {
  const std::string in = "Hertz and Mindlin";
  EXPECT_NEAR(computed(in, "restitution of gamma_n = 0.0062 (m k)^(1/2)"), 0.989, 5e-4);
  EXPECT_NEAR(computed(in, "gamma_n/(m k)^(1/2) for a restitution of 0.97"), 0.0177, 5e-5);
  EXPECT_NEAR(computed(in, "stiffness factor of a fit with R = 9 um"), 1.0290, 5e-5);
  EXPECT_NEAR(computed(in, "modulus factor of the sphere that does the same"), 1.060, 5e-4);
  EXPECT_NEAR(computed(in, "stiffness factor of that modulus factor as printed"), 1.0244, 5e-5);
  EXPECT_NEAR(computed(in, "E* with silicon's nu taken as 0.17") / 1e9, 52.3488827, 5e-8);
}

TEST(PaperSliding_other_code, fitted_modulus_is_that_of_the_caption_and_travels_are_nanometres) {
  const std::string in = "Sliding loop";
  EXPECT_NEAR(computed(in, "G* of the fitted slope, as in the text") / 1e9, 1.2096, 5e-5);
  EXPECT_NEAR(computed(in, "travel to sliding, Mindlin no slip") / 1e-9, 1.063, 5e-4);
  EXPECT_NEAR(computed(in, "travel to sliding, Mindlin-Deresiewicz") / 1e-9, 1.594, 5e-4);
  EXPECT_NEAR(computed(in, "travel to sliding, fitted slope") / 1e-9, 10.37, 0.006);
  EXPECT_NEAR(computed(in, "travel to sliding, fitted slope, with h_l") / 1e-9, 11.61, 0.005);
  const std::string& remark = analysis().number(in, "G* of the fitted slope, as in the text").remark;
  EXPECT_NE(remark.find("1.36 GPa would need a = 0.204 um"), std::string::npos) << remark;
  EXPECT_NEAR(computed(in, "load at which it would be 1.36 GPa") / 1e-6, 70.4, 0.05);
  EXPECT_NEAR(computed(in, "radius of the sphere with which it would be 1.36 GPa") / 1e-6, 6.0, 0.05);
  EXPECT_NEAR(computed(in, "with a of the sphere on diamond") / 1e9, 1.320, 5e-4);
  EXPECT_NEAR(computed(in, "with a of the sphere on fused quartz") / 1e9, 1.070, 5e-4);
  EXPECT_NEAR(computed(in, "with a of a sphere of 10 um") / 1e9, 1.146, 5e-4);
}

TEST(PaperRolling_other_code, friction_law_reproduces_table_2_and_the_offset_law_does_not) {
  const std::string in = "Rolling against roughness";
  const double friction[] = {7.853e-4, 4.626e-4, 3.484e-4}, offset[] = {659e-6, 1961e-6, 2553e-6},
               off_by[] = {1.6, 6.8, 3.5};
  int i = 0;
  for (const std::string surface : {"untreated", "etched 1600 W", "etched 1800 W"}) {
    EXPECT_NEAR(computed(in, surface + ": eq:murofit as printed"), friction[i], 5.1e-8);
    EXPECT_LE(std::abs(sigma(in, surface + ": eq:murofit as printed")), 0.2);
    EXPECT_NEAR(computed(in, surface + ": eq:frofit as printed"), offset[i], 0.5e-6);
    EXPECT_NEAR(sigma(in, surface + ": eq:frofit as printed"), off_by[i], 0.05);
    ++i;
  }
  EXPECT_NEAR(computed(in, "eq:frofit b'") / 1e-3, 4.0717, 5e-5);
  EXPECT_NEAR(computed(in, "eq:frofit c'") / 1e-3, 3.7442, 5e-5);
  EXPECT_NEAR(computed(in, "eq:frofit d'") / 1e-9, 4.4547, 5e-5);
  EXPECT_NEAR(computed(in, "eq:murofit b"), 2.95e-4, 5e-7);
  EXPECT_NEAR(computed(in, "eq:murofit c"), 6.515e-4, 5e-8);
  EXPECT_NEAR(computed(in, "eq:murofit d") / 1e-9, 1.0923, 5e-5);
  EXPECT_NEAR(computed(in, "the same with eq:barhro as printed") / 1e-6, 285.9, 0.05);
  EXPECT_NEAR(computed(in, "mean offset of two equal contacts, eq:barhro") / 1e-6, 571.4, 1e-9);
  const double untreated[] = {1.00, 1.23, 1.21};
  i = 0;
  for (const std::string load : {"0.1", "1", "3"})
    EXPECT_NEAR(computed(in, "untreated: force with lambda = a over that with r, " + load + " mN"),
                untreated[i++], 0.005);
  EXPECT_NEAR(computed(in, "etched 1800 W: force with lambda = a over that with r, 0.1 mN"), 0.75, 0.005);
  EXPECT_NEAR(computed(in, "etched 1600 W: force with lambda = a over that with r, 1 mN"), 1.32, 0.005);
}

TEST(PaperRail_other_code, predictions_deviations_and_torsion_of_each_rail) {
  const std::string in = "Rails";
  struct Rail {
    const char* angle;
    double rolling, predicted, without, deviation, torsion, offset, implied;
  };
  for (const Rail& rail : {Rail{"25 deg: ", 3.602e-4, 1.584e-3, 3.43e-4, 0.20, 0.00558, 417e-6, -311e-6},
                           Rail{"45 deg: ", 3.146e-4, 2.580e-3, 2.61e-4, 1.78, 0.00521, 239e-6, -206e-6},
                           Rail{"60 deg: ", 2.960e-4, 3.431e-3, 1.97e-4, 0.48, 0.00544, 168e-6, 19e-6}}) {
    const std::string of = rail.angle;
    EXPECT_NEAR(computed(in, of + "mu_ro at the rail's roughness, eq:murofit"), rail.rolling, 5.1e-8);
    EXPECT_NEAR(computed(in, of + "mu_rail, eq:murail with mu_to = 0.0056"), rail.predicted, 6e-7);
    EXPECT_NEAR(computed(in, of + "mu_rail without torsion"), rail.without, 6e-7);
    EXPECT_NEAR(sigma(in, of + "mu_rail, eq:murail with mu_to = 0.0056"), rail.deviation, 0.005);
    EXPECT_NEAR(computed(in, of + "mu_to from mu_rail"), rail.torsion, 5e-6);
    EXPECT_NEAR(computed(in, of + "h_rail with h_to = 0"), rail.offset, 0.5e-6);
    EXPECT_NEAR(computed(in, of + "h_to that h_rail asks for"), rail.implied, 0.5e-6);
  }
  EXPECT_NEAR(computed(in, "60 deg: mu_rail at 65 deg, as Table 2 prints the angle"), 3.743e-3, 6e-7);
  EXPECT_NEAR(sigma(in, "60 deg: mu_rail at 65 deg, as Table 2 prints the angle"), 2.12, 0.005);
  EXPECT_NEAR(computed(in, "60 deg: mu_to from mu_rail at 65 deg"), 0.00497, 5e-6);
  EXPECT_NEAR(computed(in, "mean mu_to from the three rails"), 0.0054, 5e-5);
}

TEST(PaperTorsion_other_code, scalings_agree_at_one_load_only_and_the_gap_to_sliding_is_not_seven) {
  const std::string in = "Torsion: length scale";
  EXPECT_NEAR(computed(in, "0.064 a/r at 0.1 mN"), 0.00173, 5e-6);
  EXPECT_NEAR(computed(in, "0.064 a/r at 0.5 mN"), 0.00295, 5e-6);
  EXPECT_NEAR(computed(in, "0.064 a/r at 1 mN"), 0.00372, 5e-6);
  EXPECT_NEAR(computed(in, "0.064 a/r at 3 mN"), 0.00536, 6e-6);
  EXPECT_NEAR(computed(in, "load at which both scalings agree") / 1e-3, 3.41, 0.005);
  EXPECT_NEAR(computed(in, "mu_l of the glued sphere in the 25 deg rail"), 0.236, 5e-4);
  EXPECT_NEAR(computed(in, "the same with h_l = 7.76 uN"), 0.207, 5e-4);
  EXPECT_NEAR(computed(in, "mu_l of the glued sphere if 26 uN is the force on one slope"), 0.47, 5e-3);
  EXPECT_NEAR(computed(in, "mu_l of the glued sphere if 26 uN is the force on one slope, with h_l = 7.76 uN"),
              0.41, 5e-3);
  EXPECT_NEAR(computed(in, "lateral force that mu_l = 0.63 gives") / 1e-6, 79, 0.5);
  EXPECT_NEAR(computed(in, "lateral force that mu_l = 0.72 gives") / 1e-6, 91, 0.5);
  EXPECT_NEAR(computed(in, "(2/3) mu_l over mu_to, mu_l of the glued sphere"), 2.46, 0.006);
  EXPECT_NEAR(computed(in, "(3 pi/16) mu_l over mu_to, mu_l of the glued sphere"), 2.17, 0.005);
  EXPECT_NEAR(computed(in, "(2/3) mu_l over mu_to, mu_l = 0.65"), 6.8, 0.05);
  EXPECT_NEAR(computed(in, "(3 pi/16) mu_l over mu_to, mu_l = 0.65"), 6.0, 0.05);
  EXPECT_NEAR(computed(in, "k_to = 8 G* a with the lever r"), 1.56e-6, 0.005e-6);
  EXPECT_NEAR(computed(in, "no-slip torsion (16/3) G a^3"), 1.37e-9, 0.005e-9);
  EXPECT_NEAR(computed(in, "ratio of both"), 1141, 0.5);
  EXPECT_NEAR(computed(in, "k_to = 8 G* a with lambda = a and lever r"), 4.2e-8, 0.05e-8);
  EXPECT_NEAR(computed(in, "k_to = 8 G* a with lambda = a, over no-slip torsion"), 31, 0.5);
  // The published fits come out of the published lines.
  EXPECT_LT(std::abs(sigma(in, "mu_to of eq:muto2, lambda = r")), 1);
  EXPECT_LT(std::abs(sigma(in, "mu_to of eq:muto2, lambda = a")), 1);
}

TEST(PaperMagnitudes_other_code, ratios_of_forces_and_offsets) {
  const std::string in = "Orders of magnitude";
  const double low[] = {49, 80, 94}, high[] = {246, 787, 1111}, orders[] = {2.25, 2.71, 3.03},
               times[] = {3.75, 1.65, 4.08};
  int i = 0;
  for (const std::string surface : {"untreated", "etched 1600 W", "etched 1800 W"}) {
    EXPECT_NEAR(computed(in, surface + ": sliding over rolling force at 0.1 mN"), low[i], 0.5);
    EXPECT_NEAR(computed(in, surface + ": sliding over rolling force at 3 mN"), high[i], 0.5);
    EXPECT_NEAR(computed(in, surface + ": orders of magnitude between h_ro and h_n"), orders[i], 0.005);
    EXPECT_NEAR(computed(in, surface + ": h_l over h_n"), times[i], 0.005);
    ++i;
  }
  EXPECT_NEAR(computed(in, "lateral force of rolling at 100 uN, untreated") / 1e-6, 0.53, 0.005);
  EXPECT_NEAR(computed(in, "lateral force of sliding at 100 uN, untreated") / 1e-6, 25.8, 0.05);
  EXPECT_NEAR(computed(in, "friction at the diamond below which it would slide first"), 0.005, 5e-4);
}

TEST(Paper_behaviour, every_figure_has_curves_of_equal_length_without_gaps) {
  ASSERT_EQ(analysis().curves.size(), 11u);
  for (const auto& curve : analysis().curves) {
    ASSERT_EQ(curve.columns.size(), curve.values.size()) << curve.name;
    for (const auto& column : curve.values) {
      EXPECT_EQ(column.size(), curve.values.front().size()) << curve.name;
      for (const double value : column) EXPECT_TRUE(std::isfinite(value)) << curve.name;
    }
  }
}

TEST(Paper_analytic, partial_slip_loop_has_mindlins_slope_after_reversal_and_slides_after_twice_its_travel) {
  for (const auto& curve : analysis().curves) {
    if (curve.name != "fig_slide") continue;
    const auto &x = curve.values[0], &partial = curve.values[2];
    EXPECT_NEAR((partial[1] - partial[0]) / (x[1] - x[0]), 21645,
                0.03 * 21645);  // the secant over 0.25 nm is 2 % softer
    for (std::size_t i = 0; i < x.size() / 2; ++i)
      if (x[i] + 1e-6 > 2 * 1.594e-9) {
        EXPECT_NEAR(partial[i], 23e-6, 1e-11);
      }
  }
}

TEST(Paper_behaviour, refuses_published_numbers_that_are_not_there) {
  const test::TemporaryFolder folder;
  EXPECT_NE(test::message_of<InputError>([&] { read_published(folder.path); }).find("bodies.csv"),
            std::string::npos);
  EXPECT_NE(test::message_of<InputError>([] {
              published().quoted("torsion_q");
            }).find("there is no quantity 'torsion_q'"),
            std::string::npos);
}

}  // namespace
}  // namespace asperity

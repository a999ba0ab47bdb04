#include "core/hertz.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/csv.h"
#include "tests/support/shared_files.h"

namespace asperity {
namespace {

// The reference tables give eight significant digits: rounding is at most half a unit of the eighth, 0.5e-7
// of 1.
constexpr double table_digits = 5e-8;

/// Pairs of the paper, by the names the reference tables use.
const std::map<std::string, ElasticBody>& plane_of() {
  static const std::map<std::string, ElasticBody> planes{{"borosilicate/rigid", {1e30, 0.25}},
                                                         {"borosilicate/Si", {179e9, 0.25}},
                                                         {"borosilicate/fusedquartz", {71e9, 0.17}},
                                                         {"borosilicate/diamond", {1140e9, 0.07}}};
  return planes;
}
const ElasticBody borosilicate{71e9, 0.17};
constexpr double radius = 8.5e-6;

TEST(Hertz_other_code,
     radius_approach_pressure_and_stiffness_agree_with_the_reference_for_all_pairs_and_loads) {
  const auto path = asperity::test::reference_table("01_hertz_table_loads.csv");
  const CsvTable table = read_csv(path);
  const auto column = [&](const char* name) { return table.numbers(name); };
  const auto load = column("P_uN"), a = column("a_nm"), delta = column("delta_nm"), p0 = column("p0_GPa"),
             kn = column("kn_N_per_m"), area = column("area_um2"), energy = column("elastic_energy_2Pd5_fJ");
  int compared = 0;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto plane = plane_of().find(table.rows[i][0]);
    if (plane == plane_of().end()) continue;
    const Hertz hertz{reduced_modulus(borosilicate, plane->second), radius};
    const double force = load[i] * 1e-6;
    EXPECT_NEAR(hertz.contact_radius(force) / (a[i] * 1e-9), 1, table_digits);
    EXPECT_NEAR(hertz.approach(force) / (delta[i] * 1e-9), 1, table_digits);
    EXPECT_NEAR(hertz.peak_pressure(force) / (p0[i] * 1e9), 1, table_digits);
    EXPECT_NEAR(hertz.normal_stiffness(force) / kn[i], 1, table_digits);
    EXPECT_NEAR(hertz.contact_area(force) / (area[i] * 1e-12), 1, table_digits);
    EXPECT_NEAR(hertz.elastic_energy(force) / (energy[i] * 1e-15), 1, table_digits);
    EXPECT_NEAR(hertz.force(hertz.approach(force)) / force, 1, 1e-12);
    EXPECT_NEAR(hertz.force_at_peak_pressure(hertz.peak_pressure(force)) / force, 1, 1e-12);
    ++compared;
  }
  EXPECT_GE(compared, 28);
}

TEST(Hertz_other_code, stresses_on_the_axis_agree_with_the_reference) {
  const auto path = asperity::test::reference_table("01_hertz_table_axis_stress.csv");
  const CsvTable table = read_csv(path);
  const auto depth = table.numbers("z_over_a");
  ASSERT_GT(depth.size(), 5u);
  for (const std::string nu : {"0.17", "0.25"}) {
    const auto radial = table.numbers("srr/p0_nu" + nu), axial = table.numbers("szz/p0_nu" + nu),
               shear = table.numbers("tau/p0_nu" + nu);
    for (std::size_t i = 0; i < depth.size(); ++i) {
      const AxisStress stress = hertz_axis_stress(depth[i], std::stod(nu));
      EXPECT_NEAR(stress.radial, radial[i], table_digits);
      EXPECT_NEAR(stress.axial, axial[i], table_digits);
      EXPECT_NEAR(stress.largest_shear(), shear[i], table_digits);
    }
  }
}

TEST(Hertz_other_code, place_height_and_pressure_of_first_yield_agree_with_the_reference) {
  const auto path = asperity::test::reference_table("01_hertz_table_yield_vs_nu.csv");
  const CsvTable table = read_csv(path);
  const auto nu = table.numbers("nu"), depth = table.numbers("z_over_a_max"),
             stress = table.numbers("sVM_over_p0"), pressure = table.numbers("p0_over_Y_first_yield");
  ASSERT_GT(nu.size(), 5u);
  for (std::size_t i = 0; i < nu.size(); ++i) {
    const SubsurfaceMaximum maximum = hertz_subsurface_maximum(nu[i]);
    EXPECT_NEAR(maximum.depth_over_radius, depth[i], 1e-6);
    EXPECT_NEAR(maximum.von_mises, stress[i], 1e-8);
    EXPECT_NEAR(hertz_yield_factor(nu[i]) / pressure[i], 1, 1e-7);
  }
}

TEST(Hertz_other_code, load_of_first_yield_agrees_with_the_reference) {
  const auto path = asperity::test::reference_table("02_elastoplastic_table_critical_system.csv");
  const CsvTable table = read_csv(path);
  const auto yield_stress = table.numbers("Y_GPa"), factor = table.numbers("C(nu)_exact"),
             load = table.numbers("Fc_uN");
  int compared = 0;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto plane = plane_of().find(table.rows[i][table.column("pair")]);
    if (plane == plane_of().end() || table.rows[i][table.column("yielding_body")] != "borosilicate") continue;
    const Hertz hertz{reduced_modulus(borosilicate, plane->second), radius};
    EXPECT_NEAR(hertz_yield_factor(borosilicate.poisson_ratio) / factor[i], 1, 1e-5);
    EXPECT_NEAR(hertz.first_yield_force(borosilicate.poisson_ratio, yield_stress[i] * 1e9) / (load[i] * 1e-6),
                1, 1e-5);
    ++compared;
  }
  EXPECT_GE(compared, 6);
}

TEST(Hertz_analytic, force_follows_three_halves_law) {
  const Hertz hertz{52e9, radius};
  EXPECT_NEAR(hertz.force(4e-9) / hertz.force(1e-9), 8, 1e-12);
  EXPECT_EQ(hertz.force(-1e-9), 0);
}

TEST(Hertz_analytic, stiffness_is_the_derivative_of_force) {
  const Hertz hertz{52e9, radius};
  const double delta = 10e-9, step = 1e-13;
  const double slope = (hertz.force(delta + step) - hertz.force(delta - step)) / (2 * step);
  EXPECT_NEAR(hertz.normal_stiffness(hertz.force(delta)) / slope, 1, 1e-8);
}

TEST(Hertz_analytic, a_body_that_cannot_yield_has_no_first_yield_load) {
  EXPECT_TRUE(
      std::isinf(Hertz({52e9, radius}).first_yield_force(0.17, std::numeric_limits<double>::infinity())));
}

TEST(Hertz_analytic, unit_contact_has_the_values_of_the_formulas) {
  const Hertz hertz{1, 1};  // E* = R = 1, approach 1: a = 1
  const double force = 4.0 / 3, pi = M_PI;
  EXPECT_NEAR(hertz.force(1), force, 1e-15);
  EXPECT_NEAR(hertz.approach(force), 1, 1e-15);
  EXPECT_NEAR(hertz.contact_radius(force), 1, 1e-15);
  EXPECT_NEAR(hertz.contact_area(force), pi, 1e-14);
  EXPECT_NEAR(hertz.peak_pressure(force), 2 / pi, 1e-15);
  EXPECT_NEAR(hertz.normal_stiffness(force), 2, 1e-14);
  EXPECT_NEAR(hertz.elastic_energy(force), 8.0 / 15, 1e-15);
  EXPECT_NEAR(hertz.force_at_peak_pressure(2 / pi), force, 1e-14);
  EXPECT_EQ(hertz.force(0), 0);
  EXPECT_EQ(hertz.approach(0), 0);
}

TEST(Hertz_analytic, force_of_first_yield_goes_with_the_cube_of_the_yield_stress) {
  const Hertz hertz{52e9, radius};
  EXPECT_NEAR(hertz.first_yield_force(0.17, 2e9) / hertz.first_yield_force(0.17, 1e9), 8, 1e-12);
  EXPECT_NEAR(hertz.peak_pressure(hertz.first_yield_force(0.17, 1e9)) / (hertz_yield_factor(0.17) * 1e9), 1,
              1e-12);
}

TEST(Hertz_analytic, a_rigid_body_leaves_the_compliance_of_the_other) {
  const ElasticBody rigid{std::numeric_limits<double>::infinity(), 0.3};
  EXPECT_NEAR(reduced_modulus(borosilicate, rigid) / (71e9 / (1 - 0.17 * 0.17)), 1, 1e-14);
  EXPECT_NEAR(reduced_modulus(borosilicate, borosilicate) / reduced_modulus(borosilicate, rigid), 0.5, 1e-14);
  EXPECT_EQ(reduced_modulus(borosilicate, {179e9, 0.25}), reduced_modulus({179e9, 0.25}, borosilicate));
}

TEST(AxisStress_analytic, von_mises_and_shear_have_no_sign) {
  EXPECT_EQ((AxisStress{0, -1}).von_mises(), 1);  // pressed along the axis
  EXPECT_EQ((AxisStress{0, 1}).von_mises(), 1);   // drawn
  EXPECT_EQ((AxisStress{-2, -5}).von_mises(), 3);
  EXPECT_EQ((AxisStress{-5, -2}).von_mises(), 3);
  EXPECT_EQ((AxisStress{-5, -2}).largest_shear(), 1.5);
  EXPECT_EQ((AxisStress{-4, -4}).von_mises(), 0);
}

TEST(AxisStress_analytic, is_Johnsons_at_the_surface_and_Boussinesqs_far_below) {
  for (const double nu : {0.0, 0.17, 0.3, 0.5}) {
    const AxisStress top = hertz_axis_stress(1e-9, nu), deep = hertz_axis_stress(1e3, nu);
    EXPECT_NEAR(top.radial, -(1 + 2 * nu) / 2, 1e-8);  // Johnson 1985, eq. 3.44
    EXPECT_NEAR(top.axial, -1, 1e-8);
    EXPECT_NEAR(deep.axial * 1e6, -1, 1e-5);  // -3 P/(2 pi z^2)
    EXPECT_NEAR(deep.radial * 1e6, (1 - 2 * nu) / 6, 1e-5);
  }
}

}  // namespace
}  // namespace asperity

// Rough contacts of half-spaces against another code's, and those of cases.
#include <gtest/gtest.h>

#include <cmath>

#include "core/csv.h"
#include "core/error.h"
#include "half_space/case_contact.h"
#include "surfaces/generate.h"
#include "tests/support/shared_files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/verification.h"

namespace asperity::half_space {
namespace {

using test::Largest;
using test::Verified;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Root mean square of the gradient of a periodic map, by its waves' exact slopes on a cube of differences.
double rms_slope(const Topography& map) {
  // Central differences over one and two pixels, extrapolated: waves of 16 pixels are right to 1e-4.
  double sum = 0;
  const auto slope = [&](int ix, int iy, int sx, int sy) {
    const auto at = [&](int steps) {
      return map.at((ix + steps * sx + map.nx) % map.nx, (iy + steps * sy + map.ny) % map.ny);
    };
    return (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * (sx ? map.dx() : map.dy()));
  };
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
      sum += std::pow(slope(ix, iy, 1, 0), 2) + std::pow(slope(ix, iy, 0, 1), 2);
  return std::sqrt(sum / (map.nx * map.ny));
}

TEST(HalfSpaceRough_other_code, area_and_gap_of_self_affine_surfaces_follow_those_of_another_code) {
  // Hurst exponent 0.8, waves from a quarter to a thirty-second of the period, 16 pixels over the shortest.
  const CsvTable table = read_csv(test::reference_table("07_rough_table_own_BEM.csv"));
  const auto pixels = table.numbers("grid_n"), shortest = table.numbers("lambda_s_pixels"),
             loads = table.numbers("p/(E*h'_rms)"), areas = table.numbers("A/A0_edge_corrected"),
             gaps = table.numbers("mean_gap/h_rms");
  constexpr int n = 512, realisations = 3;
  constexpr double length = 1e-6, modulus = 50e9;
  GenerateOptions options;
  options.nx = options.ny = n;
  options.lx = options.ly = length;
  options.rms = 1e-9;
  const auto spectrum = [](double q) {
    const double longest = length / 4, least = length / 32, wave = 2 * M_PI / q;
    return wave <= longest * (1 + 1e-9) && wave >= least * (1 - 1e-9) ? std::pow(q, -3.6) : 0.0;
  };
  std::vector<double> area(loads.size(), 0.0), gap(loads.size(), 0.0);
  const auto is_asked = [&](std::size_t k) {
    return pixels[k] == n && shortest[k] == 16 && (loads[k] == 0.02 || loads[k] == 0.1);
  };
  for (int seed = 1; seed <= realisations; ++seed) {
    options.seed = seed;
    const Topography map = generate_periodic(spectrum, options);
    double square = 0;
    for (const double h : map.heights) square += h * h / (n * n);
    const double slope = rms_slope(map);
    const Grid grid{n, n, length / n, length / n};
    Field initial(grid.cells());
    for (std::size_t k = 0; k < initial.size(); ++k) initial[k] = -map.heights[k];
    const NormalContact contact(grid, Boundary::periodic, modulus, initial);
    for (std::size_t k = 0; k < loads.size(); ++k) {
      if (!is_asked(k)) continue;
      const auto solution = contact.at_force(loads[k] * modulus * slope * length * length);
      double sum = 0;
      for (const double g : solution.gap) sum += g / (n * n);
      area[k] += contact_shape(grid, solution.pressure, infinite).area / (length * length) / realisations;
      gap[k] += sum / std::sqrt(square) / realisations;
    }
  }
  Largest area_error, gap_error;
  for (std::size_t k = 0; k < loads.size(); ++k)
    if (is_asked(k)) area_error.count(area[k] / areas[k] - 1), gap_error.count(gap[k] / gaps[k] - 1);
  const auto verified = [](const std::string& what) {
    return Verified{"Half-space",
                    "three self-affine surfaces that repeat, 2 and 10 % of the rms slope times E*: " + what,
                    "another boundary element code, three surfaces of its own, scatter 2 to 4 %"};
  };
  EXPECT_TRUE(verified("real contact area").below(area_error, 0.04));
  EXPECT_TRUE(verified("mean gap").below(gap_error, 0.06));
}

CaseInput sphere_on_silicon() {
  CaseInput input;
  input.file = "case.prm";
  input.radius = 8.5e-6;
  input.particle.youngs_modulus = 71e9, input.particle.poisson_ratio = 0.17;
  input.substrate.youngs_modulus = 179e9, input.substrate.poisson_ratio = 0.25;
  input.experiment.normal_load = 100e-6;
  return input;
}

CaseInput rough_case() {
  CaseInput input = sphere_on_silicon();
  input.particle.topography = "generated(rms=0.7 nm, hurst=0.8, rolloff=200 nm, cutoff=80 nm, seed=1)";
  input.substrate.topography = "generated(rms=1.5 nm, hurst=0.8, rolloff=200 nm, cutoff=80 nm, seed=2)";
  return input;
}

TEST(CaseContact_analytic, of_smooth_bodies_is_that_of_Hertz_by_force_and_by_approach) {
  CaseInput input = sphere_on_silicon();
  const Hertz hertz = hertz_of(input);
  const double F = input.experiment.normal_load;
  const CaseContact by_force = contact_of_case(input);
  EXPECT_EQ(by_force.enlarged, 0);
  // The sphere is no paraboloid: (a/R)^2 apart at most.
  EXPECT_NEAR(by_force.approach() / hertz.approach(F), 1, 1e-3);
  EXPECT_NEAR(by_force.shape.area / hertz.contact_area(F), 1, 0.01);
  EXPECT_NEAR(by_force.stiffness / hertz.normal_stiffness(F), 1, 0.01);
  EXPECT_NEAR(by_force.shape.reach / hertz.contact_radius(F), 1, 0.05);
  input.experiment.control = ExperimentInput::Control::displacement;
  input.experiment.normal_load = 0;
  input.experiment.normal_approach = hertz.approach(F);
  const CaseContact by_approach = contact_of_case(input);
  EXPECT_NEAR(by_approach.solution.force / F, 1, 2e-3);
}

TEST(CaseContact_behaviour, of_rough_bodies_is_the_same_on_squares_of_another_size) {
  const CaseInput input = rough_case();
  CaseContactOptions options;
  options.spacing = 6e-9;
  const CaseContact derived = contact_of_case(input, options);
  options.half_width = 1.4 * derived_half_width(input);
  const CaseContact wider = contact_of_case(input, options);
  options.half_width = 0.5 * derived_half_width(input);
  const CaseContact narrow = contact_of_case(input, options);
  EXPECT_EQ(derived.enlarged, 0);
  EXPECT_GT(narrow.enlarged, 0);
  for (const auto* other : {&wider, &narrow}) {
    EXPECT_NEAR(other->approach() / derived.approach(), 1, 2e-3);
    EXPECT_NEAR(other->shape.area / derived.shape.area, 1, 0.02);
    EXPECT_NEAR(other->stiffness / derived.stiffness, 1, 0.01);
  }
}

TEST(CaseContact_behaviour, both_surfaces_count_alike_and_roughness_lessens_area_and_stiffness) {
  const CaseInput rough = rough_case();
  CaseInput turned = rough;
  std::swap(turned.particle.topography, turned.substrate.topography);
  CaseContactOptions options;
  options.spacing = 8e-9;
  const CaseContact one = contact_of_case(rough, options), other = contact_of_case(turned, options),
                    smooth = contact_of_case(sphere_on_silicon(), options);
  EXPECT_NEAR(other.approach() / one.approach(), 1, 1e-9);
  EXPECT_LT(one.shape.area, 0.9 * smooth.shape.area);
  EXPECT_LT(one.stiffness, 0.99 * smooth.stiffness);
  EXPECT_GT(one.shape.spots, 3);
  EXPECT_LT(one.first_touch, 0);
}

TEST(CasePreview_behaviour, tells_the_error_of_two_spacings_and_caps_pressures) {
  CaseInput input = rough_case();
  constexpr double hardness = 3e9;
  const CasePreview preview = preview_of_case(input, hardness);
  EXPECT_EQ(preview.coarse.grid.nx * 2, preview.fine.grid.nx);
  EXPECT_GT(preview.error_of_area(), 0);
  EXPECT_LT(preview.error_of_area(), 0.05);
  EXPECT_LT(preview.error_of_largest_pressure(), 0.2);
  EXPECT_LT(preview.error_of_stiffness(), 0.01);
  ASSERT_TRUE(preview.capped);
  EXPECT_EQ(preview.capped->shape.largest_pressure, hardness);
  EXPECT_GT(preview.capped->shape.area, preview.fine.shape.area);
  EXPECT_FALSE(preview_of_case(input, infinite).capped);
  // The stated errors hold the answer of a spacing half as wide.
  CaseContactOptions options;
  options.spacing = preview.fine.grid.dx / 2;
  options.half_width = 0.5 * preview.fine.grid.nx * preview.fine.grid.dx;
  const CaseContact finer = contact_of_case(input, options);
  EXPECT_NEAR(finer.shape.area / preview.fine.shape.area, 1, preview.error_of_area());
  EXPECT_NEAR(finer.shape.largest_pressure / preview.fine.shape.largest_pressure, 1,
              preview.error_of_largest_pressure());
}

TEST(CasePreview_behaviour, states_no_less_of_the_largest_pressure_than_was_measured_for_its_cells) {
  CasePreview preview;
  preview.fine.shape.largest_pressure = preview.coarse.shape.largest_pressure = 5e9;  // the same by chance
  for (const auto& [cells, error] : {std::pair{16.0, 0.02}, std::pair{8.0, 0.05}}) {
    preview.resolution = 1 / cells;
    EXPECT_NEAR(preview.error_of_largest_pressure(), error, 1e-12);
  }
  preview.resolution = 0;  // smooth
  EXPECT_EQ(preview.error_of_largest_pressure(), 0);
  preview.coarse.shape.largest_pressure = 4e9;
  EXPECT_NEAR(preview.error_of_largest_pressure(), 0.2, 1e-12);
}

TEST(CaseContact_behaviour, is_enlarged_until_the_hardness_carries_the_load) {
  CaseInput input = sphere_on_silicon();
  CaseContactOptions options;
  options.hardness = input.experiment.normal_load / std::pow(3 * derived_half_width(input), 2);
  const CaseContact soft = contact_of_case(input, options);
  EXPECT_FALSE(soft.shape.reaches_edge);
  EXPECT_NEAR(soft.shape.area * options.hardness / input.experiment.normal_load, 1, 0.01);
  options.hardness /= 100;
  EXPECT_THROW(contact_of_case(input, options), InputError);
}

TEST(CaseContact_analytic, attraction_is_taken_off_pressures_and_off_what_a_hardness_bounds) {
  const CaseInput input = sphere_on_silicon();
  constexpr double held = 0.4e9, range = 1e-9;
  const auto law = [=](double gap) { return held * std::exp(-gap / range); };
  CaseContactOptions options;
  options.attraction = Attraction{law, law, 5 * range, held * range};
  options.with_pull_off = options.with_stiffness = false;
  const CaseContact elastic = contact_of_case(input, options);
  const double load = input.experiment.normal_load;
  EXPECT_NEAR(elastic.mean_pressure() * elastic.shape.area, load, 1e-4 * load);
  EXPECT_DOUBLE_EQ(elastic.largest_pressure(), elastic.shape.largest_pressure - held);
  EXPECT_GT(elastic.attracting, 0.1 * load);
  // More than without attraction, and less than were all of it load (Johnson 1985, sec. 5.5).
  EXPECT_GT(elastic.largest_pressure(), hertz_of(input).peak_pressure(load));
  EXPECT_LT(elastic.largest_pressure(), hertz_of(input).peak_pressure(load + elastic.attracting));
  options.hardness = 0.8 * elastic.largest_pressure();
  const CaseContact yielding = contact_of_case(input, options);
  EXPECT_NEAR(yielding.largest_pressure() / options.hardness, 1, 1e-9);
  EXPECT_GT(yielding.shape.area_at_bound, 0);
  EXPECT_GT(yielding.shape.area, elastic.shape.area);
}

TEST(CaseContact_analytic, attraction_of_touching_surfaces_alone_leaves_the_pressures_of_Hertz) {
  // None before touch: what bears the attraction is the attraction itself, wherever the bodies touch.
  const CaseInput input = sphere_on_silicon();
  constexpr double held = 0.4e9, range = 1e-9;
  CaseContactOptions options;
  options.attraction =
      Attraction{[](double) { return 0.0; }, [=](double gap) { return held * std::exp(-gap / range); },
                 5 * range, held * range};
  options.with_pull_off = options.with_stiffness = false;
  const CaseContact contact = contact_of_case(input, options);
  const Hertz hertz = hertz_of(input);
  const double load = input.experiment.normal_load, area = hertz.contact_area(load);
  EXPECT_NEAR(contact.shape.area / area, 1, 0.01);
  EXPECT_NEAR(contact.largest_pressure() / hertz.peak_pressure(load), 1, 0.01);
  EXPECT_NEAR(contact.mean_pressure() / (load / area), 1, 0.01);
  EXPECT_NEAR(contact.attracting / (held * area), 1, 0.03);
}

TEST(CaseContact_behaviour, refuses_what_is_no_half_space) {
  CaseInput input = sphere_on_silicon();
  CaseContactOptions options;
  options.half_width = 5e-6;
  EXPECT_NE(test::message_of<InputError>([&] { contact_of_case(input, options); }).find("half the Radius"),
            std::string::npos);
}

}  // namespace
}  // namespace asperity::half_space

// What a case file's entry Topography means: generator calls and scans.
#include "surfaces/surface_of_entry.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "surfaces/generate.h"
#include "surfaces/levelling.h"
#include "surfaces/read_topography.h"
#include "surfaces/sampler.h"
#include "surfaces/scan_spec.h"
#include "surfaces/statistics.h"
#include "tests/support/temporary_folder.h"

namespace asperity {

TEST(TopographySpec_behaviour, reads_the_generators_arguments) {
  const auto parameters =
      parse_generator(" generated( rms=1.5 nm, hurst = 0.7,rolloff=250 nm, cutoff=25 nm, seed=42) ");
  EXPECT_DOUBLE_EQ(parameters.spectrum.rms, 1.5e-9);
  EXPECT_DOUBLE_EQ(parameters.spectrum.hurst, 0.7);
  EXPECT_DOUBLE_EQ(parameters.spectrum.rolloff, 250e-9);
  EXPECT_DOUBLE_EQ(parameters.spectrum.cutoff, 25e-9);
  EXPECT_EQ(parameters.seed, 42u);
  EXPECT_EQ(parse_generator(parameters.text()).text(), parameters.text());
}

TEST(TopographySpec_behaviour, refuses_by_the_name_of_the_key) {
  const auto message = [](const std::string& spec) -> std::string {
    try {
      parse_generator(spec);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_NE(message("generated(rms=1.5 nm, hrust=0.8)").find("'hrust'"), std::string::npos);
  EXPECT_NE(message("generated(hurst=0.8)").find("lacks the entry 'rms'"), std::string::npos);
  EXPECT_NE(message("generated(rms=1.5 GPa)").find("'rms'"), std::string::npos);
  EXPECT_NE(message("generated(rms=1.5 nm, hurst=1.8)").find("hurst must lie"), std::string::npos);
  EXPECT_NE(message("generated(rms=1.5 nm, rolloff=10 nm)").find("rolloff (10 nm)"), std::string::npos);
  EXPECT_NE(message("generated(rms=1.5 nm, seed=-3)").find("'seed'"), std::string::npos);
  EXPECT_NE(message("generated(rms=1.5 nm, rms=1 nm)").find("twice"), std::string::npos);
  EXPECT_NE(message("generated(rms=1.5 nm").find("not a call"), std::string::npos);
}

TEST(TopographySpec_analytic, a_generated_surface_is_decided_by_its_entry_alone_and_repeats_beyond_its_size) {
  const std::string spec =
      "generated(rms=1.5 nm, hurst=0.8, rolloff=100 nm, cutoff=40 nm, size=1.6 um, seed=3)";
  // Regions that fit and that are five times as large.
  const HeightSampler small = heights_over(spec, 0.3e-6), large = heights_over(spec, 8e-6);
  for (const double x : {-0.11e-6, 0.0, 0.14e-6})
    for (const double y : {-0.13e-6, 0.02e-6}) {
      EXPECT_EQ(small.height(x, y), large.height(x, y));
      EXPECT_NEAR(large.height(x + 1.6e-6, y - 3.2e-6), small.height(x, y), 1e-20);
    }
  EXPECT_EQ(parse_generator(parse_generator(spec).text()).size, 1.6e-6);
  EXPECT_LE(topography_for(spec).dx(), 10e-9 * (1 + 1e-12));
  EXPECT_EQ(heights_over("smooth", 1e-6).height(1e-7, 3e-6), 0.0);
}

TEST(TopographySpec_analytic, the_size_of_a_generated_surface_follows_from_its_spectrum) {
  const auto period = [](const std::string& arguments) {
    return generator_grid(parse_generator("generated(rms=1 nm, " + arguments + ")")).period;
  };
  EXPECT_DOUBLE_EQ(period("rolloff=200 nm, cutoff=72 nm"), 64 * 200e-9);
  EXPECT_DOUBLE_EQ(period("rolloff=1.5 um, cutoff=72 nm"), 512 * 72e-9);  // 2048 pixels
  EXPECT_DOUBLE_EQ(period("rolloff=4 um, cutoff=10 nm"), 8 * 4e-6);
  EXPECT_DOUBLE_EQ(period("rolloff=200 nm, cutoff=72 nm, size=3 um"), 3e-6);
  EXPECT_THROW(parse_generator("generated(rms=1 nm, rolloff=200 nm, size=300 nm)"), InputError);
  EXPECT_THROW(
      generator_grid(parse_generator("generated(rms=1 nm, rolloff=200 nm, cutoff=20 nm, size=1 mm)")),
      InputError);
}

TEST(TopographySpec_analytic, an_rms_with_a_window_is_a_measured_one) {
  const auto measured = parse_generator("generated(rms=1.5 nm, window=2.5 um, rolloff=1 um, cutoff=40 nm)");
  EXPECT_DOUBLE_EQ(measured.window, 2.5e-6);
  EXPECT_EQ(parse_generator(measured.text()).text(), measured.text());
  // Scans lose long waves to levelling, so that the surface itself is rougher than they show.
  EXPECT_GT(surface_spectrum(measured).rms, 1.02 * 1.5e-9);
  const auto whole = parse_generator("generated(rms=1.5 nm, rolloff=1 um, cutoff=40 nm)");
  EXPECT_DOUBLE_EQ(surface_spectrum(whole).rms, 1.5e-9);
  EXPECT_THROW(parse_generator("generated(rms=1.5 nm, window=0 um)"), InputError);
}

TEST(TopographySpec_analytic,
     scans_cut_from_surfaces_as_a_case_gets_them_show_the_measured_rms_within_a_percent) {
  // The period of these surfaces is 8 roll-offs, four scans. Levelling takes several per cent from scans of
  // two roll-offs.
  constexpr double rms = 1.5e-9;
  constexpr int surfaces = 30, scans_across = 4;
  double sum = 0, squares = 0;
  for (int seed = 1; seed <= surfaces; ++seed) {
    const Topography surface = topography_for(
        "generated(rms=1.5 nm, window=1.2 um, hurst=0.8, rolloff=600 nm, cutoff=75 nm, size=4.8 um, seed=" +
        std::to_string(seed) + ")");
    const int pixels = surface.nx / scans_across;
    ASSERT_NEAR(pixels * surface.dx(), 1.2e-6, 1e-15);
    double mean_of_surface = 0;
    for (int window = 0; window < scans_across * scans_across; ++window)
      mean_of_surface += height_moments(levelled(cut_window(surface, window % scans_across * pixels,
                                                            window / scans_across * pixels, pixels, pixels),
                                                 Level::plane))
                             .Sq /
                         (scans_across * scans_across);
    sum += mean_of_surface;
    squares += mean_of_surface * mean_of_surface;
  }
  const double mean = sum / surfaces, error = std::sqrt((squares / surfaces - mean * mean) / surfaces);
  EXPECT_LT(error, 0.005 * rms);  // else the mean says nothing
  EXPECT_NEAR(mean, rms, 0.01 * rms) << "standard error " << error;
  // The same entry without a window is another surface: its scans show less than 0.97 of its rms.
  EXPECT_GT(
      surface_spectrum(parse_generator("generated(rms=1.5 nm, window=1.2 um, rolloff=600 nm, cutoff=75 nm)"))
          .rms,
      rms / 0.97);
}

namespace {

/// A scan of 0.8 x 0.6 um whose heights tell where they lie.
Topography written_scan() {
  Topography map;
  map.nx = 80, map.ny = 60, map.lx = 0.8e-6, map.ly = 0.6e-6;
  map.heights.resize(80 * 60);
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
      map.at(ix, iy) = 2e-9 * std::sin(2 * M_PI * (ix + 0.5) / 40) * std::sin(2 * M_PI * (iy + 0.5) / 30) +
                       1e-9 + 3e-11 * ix;
  return map;
}

TEST(GeneratedSpec_analytic,
     a_wave_as_long_as_the_cutoff_belongs_to_the_surface_however_its_length_was_computed) {
  SelfAffineSpectrum spectrum;
  spectrum.rms = 1.5e-9;
  spectrum.hurst = 0.8;
  spectrum.rolloff = 200e-9;
  for (const double cutoff : {20e-9, 40e-9, 128e-9}) {
    spectrum.cutoff = cutoff;
    for (int waves = 1; waves <= 700; ++waves) {
      const double period = waves * cutoff;
      EXPECT_GT(spectrum(2 * M_PI * waves / period), 0) << waves;
      EXPECT_EQ(spectrum(2 * M_PI * (waves + 0.01) / period), 0) << waves;
    }
  }
}

}  // namespace

TEST(ScanSpec_behaviour, a_file_alone_or_with_what_it_does_not_say) {
  EXPECT_EQ(parse_scan("afm/surface 1.gsf").file, "afm/surface 1.gsf");
  EXPECT_EQ(parse_scan("scan(1).gsf").file, "scan(1).gsf");
  const ScanParameters scan = parse_scan(
      "scan(a.txt, size=2.5 um, channel=Height, unit=nm, level=rows1, cutoff=80 nm, outside=mirror)");
  EXPECT_EQ(scan.file, "a.txt");
  EXPECT_DOUBLE_EQ(*scan.options.size_x_m, 2.5e-6);
  EXPECT_EQ(*scan.options.channel, "Height");
  EXPECT_EQ(*scan.options.height_unit, "nm");
  EXPECT_EQ(scan.level, Level::rows1);
  EXPECT_EQ(scan.outside, Outside::mirror);
  EXPECT_EQ(scan.text(),
            "scan(a.txt, size=2.5 um, channel=Height, unit=nm, level=rows1, cutoff=80 nm, outside=mirror)");
  EXPECT_EQ(parse_scan("scan(a.gsf)").text(), "a.gsf");
  for (const std::string& wrong : std::vector<std::string>{
           "scan()", "scan(a.gsf, b.gsf)", "scan(a.gsf, size=3 GPa)", "scan(a.gsf, unit=GPa)",
           "scan(a.gsf, outside=periodic)", "scan(a.gsf, level=best)", "scan(a.gsf, offset=1)"})
    EXPECT_THROW(parse_scan(wrong), InputError) << wrong;
}

TEST(ScanSpec_analytic, the_centre_of_the_scan_is_the_centre_of_contact_and_its_plane_is_taken_off) {
  const test::TemporaryFolder folder;
  const Topography scan = written_scan();
  write_gsf(folder.path / "scan.gsf", scan);
  const HeightSampler sampler = heights_over((folder.path / "scan.gsf").string(), 0.5e-6);
  const Topography expected = levelled(scan, Level::plane);
  EXPECT_NEAR(sampler.height(scan.dx() / 2, scan.dy() / 2), expected.at(40, 30), 1e-15);
  EXPECT_NEAR(sampler.height(-10.5 * scan.dx(), 7.5 * scan.dy()), expected.at(29, 37), 1e-15);
}

TEST(ScanSpec_behaviour, a_scan_smaller_than_the_region_is_refused_with_a_remedy_or_mirrored) {
  const test::TemporaryFolder folder;
  const Topography scan = written_scan();
  write_gsf(folder.path / "scan.gsf", scan);
  const std::string file = (folder.path / "scan.gsf").string();
  const auto message = test::message_of<ScanError>([&] { heights_over(file, 0.7e-6); });
  for (const auto& part :
       {file, std::string("800 nm x 600 nm"), std::string("square of 700 nm"), std::string("outside=mirror")})
    EXPECT_NE(message.find(part), std::string::npos) << message;

  const HeightSampler inside = heights_over(file, 0.5e-6),
                      everywhere = heights_over("scan(" + file + ", outside=mirror)", 2e-6);
  EXPECT_NEAR(everywhere.height(0.05e-6, -0.12e-6), inside.height(0.05e-6, -0.12e-6), 1e-13);
  EXPECT_NEAR(everywhere.height(0.45e-6, 0.1e-6), everywhere.height(0.35e-6, 0.1e-6), 1e-15);
  EXPECT_NEAR(everywhere.height(0.1e-6, -0.35e-6), everywhere.height(0.1e-6, -0.25e-6), 1e-15);
  EXPECT_NEAR(everywhere.height(-0.9e-6, 0.1e-6), everywhere.height(0.7e-6, 0.1e-6), 1e-15);
}

TEST(ScanSpec_analytic, a_cutoff_takes_out_shorter_waves_and_leaves_longer_ones) {
  // Cosines that end with zero slope at the edges, so that their mirror images continue them.
  const test::TemporaryFolder folder;
  Topography map;
  map.nx = map.ny = 100, map.lx = map.ly = 1e-6;
  map.heights.resize(100 * 100);
  const auto cosine = [](int i, int waves) { return std::cos(2 * M_PI * waves * (i + 0.5) / 100); };
  for (int iy = 0; iy < 100; ++iy)
    for (int ix = 0; ix < 100; ++ix) map.at(ix, iy) = 2e-9 * cosine(ix, 4) + 1e-9 * cosine(iy, 25);
  write_gsf(folder.path / "scan.gsf", map);
  const std::string file = (folder.path / "scan.gsf").string();
  const Topography smoothed = topography_for("scan(" + file + ", level=mean, cutoff=100 nm)");
  ASSERT_EQ(smoothed.nx, 100);
  for (const int ix : {0, 13, 50, 99})
    for (const int iy : {0, 31, 99}) EXPECT_NEAR(smoothed.at(ix, iy), 2e-9 * cosine(ix, 4), 1e-15);
}

TEST(TopographySpec_behaviour, says_how_rough_and_how_fine_a_surface_is_before_its_region_is_known) {
  EXPECT_EQ(topography_scales("smooth").rms, 0);
  EXPECT_TRUE(std::isinf(topography_scales("smooth").shortest_wave));
  const TopographyScales generated =
      topography_scales("generated(rms=1.5 nm, window=2.5 um, rolloff=500 nm, cutoff=72 nm)");
  EXPECT_DOUBLE_EQ(generated.rms, 1.5e-9);
  EXPECT_DOUBLE_EQ(generated.shortest_wave, 72e-9);
  const test::TemporaryFolder folder;
  write_gsf(folder.path / "scan.gsf", written_scan());
  const std::string file = (folder.path / "scan.gsf").string();
  EXPECT_NEAR(topography_scales(file).rms, 1e-9, 1e-12);  // 2 nm sin sin, whole periods
  // Waves of 400 and 300 nm, crossed: 240 nm, which the window spreads over two rings of 600 nm on this small
  // scan.
  EXPECT_LE(topography_scales(file).shortest_wave, 240e-9);
  EXPECT_GE(topography_scales(file).shortest_wave, 1 / (1 / 240e-9 + 2 / 600e-9));
  EXPECT_DOUBLE_EQ(topography_scales("scan(" + file + ", cutoff=90 nm)").shortest_wave, 90e-9);
}

TEST(ScanSpec_analytic, an_odd_number_of_pixels_moves_no_height_where_mirror_images_begin_to_be_needed) {
  const test::TemporaryFolder folder;
  Topography scan = written_scan();
  scan.nx = 79, scan.heights.resize(79 * 60);
  write_gsf(folder.path / "scan.gsf", scan);
  const std::string entry = "scan(" + (folder.path / "scan.gsf").string() + ", outside=mirror)";
  const HeightSampler inside = heights_over(entry, 0.5e-6), beyond = heights_over(entry, 2e-6);
  for (const double x : {-0.2e-6, 0.07e-6}) EXPECT_EQ(inside.height(x, 0.1e-6), beyond.height(x, 0.1e-6));
}

/// Waves of 100 nm carry four times the slope variance of waves of 40 nm with a fifth of their height.
TEST(ScanSpec_analytic, a_scan_tells_the_mesh_down_to_which_wave_its_slopes_lie) {
  const test::TemporaryFolder folder;
  const auto shortest = [&](double height_of_short_waves, double pixel) {
    Topography map;
    map.nx = map.ny = 256, map.lx = map.ly = 256 * pixel;
    map.heights.resize(256 * 256);
    for (int iy = 0; iy < 256; ++iy)
      for (int ix = 0; ix < 256; ++ix)
        map.at(ix, iy) = 1e-9 * std::sin(2 * M_PI * iy * pixel / 100e-9) +
                         height_of_short_waves * std::sin(2 * M_PI * ix * pixel / 40e-9);
    write_gsf(folder.path / "scan.gsf", map);
    return topography_scales((folder.path / "scan.gsf").string());
  };
  const double resolution = 0.1;  // the window spreads a wave over a ring or two of 1.28 um
  EXPECT_NEAR(shortest(0.2e-9, 5e-9).shortest_wave, 40e-9, resolution * 40e-9);
  EXPECT_LT(shortest(0.2e-9, 5e-9).unresolved, 0.01);
  EXPECT_NEAR(shortest(0.02e-9, 5e-9).shortest_wave, 100e-9,
              resolution * 100e-9);  // 0.25 % of the slope variance
  // Waves of 40 nm on pixels of 15 nm are measured by fewer than four heights.
  const TopographyScales coarse = shortest(0.2e-9, 15e-9);
  EXPECT_GE(coarse.shortest_wave, 60e-9);
  EXPECT_NEAR(coarse.unresolved, 0.2, 0.03);
}

TEST(TopographySpec_behaviour, a_flat_surface_in_a_window_stays_flat) {
  const auto flat = parse_generator("generated(rms=0 nm, window=2.5 um)");
  EXPECT_EQ(surface_spectrum(flat).rms, 0);
  EXPECT_EQ(topography_scales("generated(rms=0 nm)").rms, 0);
}

TEST(ScanSpec_analytic, a_cutoff_keeps_long_waves_in_any_direction_of_a_map_that_is_not_square) {
  const test::TemporaryFolder folder;
  Topography map;
  map.nx = 48, map.ny = 30, map.lx = 0.96e-6, map.ly = 0.3e-6;  // pixels of 20 nm x 10 nm
  map.heights.resize(48 * 30);
  const auto x = [](int i, int half_waves) { return std::cos(M_PI * half_waves * (i + 0.5) / 48); };
  const auto y = [](int i, int half_waves) { return std::cos(M_PI * half_waves * (i + 0.5) / 30); };
  const auto kept = [&](int ix, int iy) {  // waves of 192 nm, 120 nm, and 192 and 200 nm crossed (138 nm)
    return 2e-9 * x(ix, 10) + 1.5e-9 * y(iy, 5) + 1e-9 * x(ix, 10) * y(iy, 3);
  };
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx;
         ++ix)  // and waves of 80 nm, of 75 nm, and of 128 and 150 nm crossed (97 nm)
      map.at(ix, iy) = kept(ix, iy) + 3e-9 * x(ix, 24) + 2e-9 * y(iy, 8) + 1e-9 * x(ix, 15) * y(iy, 4);
  write_gsf(folder.path / "scan.gsf", map);
  const std::string file = (folder.path / "scan.gsf").string();
  const Topography smoothed = topography_for("scan(" + file + ", level=mean, cutoff=110 nm)");
  ASSERT_EQ(smoothed.nx, 48);
  ASSERT_EQ(smoothed.ny, 30);
  EXPECT_DOUBLE_EQ(smoothed.lx, map.lx);
  EXPECT_DOUBLE_EQ(smoothed.ly, map.ly);
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
      ASSERT_NEAR(smoothed.at(ix, iy), kept(ix, iy), 2e-15) << ix << " " << iy;
  EXPECT_NE(smoothed.source.find(", levelled: mean, without waves shorter than 110 nm"), std::string::npos)
      << smoothed.source;
}

TEST(ScanSpec_analytic, a_cutoff_works_on_an_odd_number_of_pixels_and_on_missing_ones) {
  const test::TemporaryFolder folder;
  Topography map;
  map.nx = 45, map.ny = 33, map.lx = 0.45e-6, map.ly = 0.33e-6;
  map.heights.resize(45 * 33);
  const auto kept = [](int ix, int iy) {
    return 2e-9 * std::cos(M_PI * 3 * (ix + 0.5) / 45) * std::cos(M_PI * 2 * (iy + 0.5) / 33);
  };
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
      map.at(ix, iy) = kept(ix, iy) + 1e-9 * std::cos(M_PI * 20 * (iy + 0.5) / 33);
  write_gsf(folder.path / "scan.gsf", map);
  const Topography smoothed =
      topography_for("scan(" + (folder.path / "scan.gsf").string() + ", level=mean, cutoff=60 nm)");
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
      ASSERT_NEAR(smoothed.at(ix, iy), kept(ix, iy), 2e-15) << ix << " " << iy;
  map.at(20, 16) = std::nan("");
  write_gsf(folder.path / "holes.gsf", map);
  const Topography filled =
      topography_for("scan(" + (folder.path / "holes.gsf").string() + ", level=mean, cutoff=60 nm)");
  for (const double height : filled.heights) ASSERT_TRUE(std::isfinite(height));
  EXPECT_NEAR(filled.at(3, 3), kept(3, 3), 2e-10);
}

TEST(ScanSpec_behaviour, each_argument_that_is_wrong_is_named_with_the_reason) {
  const auto message = [](const std::string& spec) {
    return test::message_of<InputError>([&] { parse_scan(spec); });
  };
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"scan()", "names no file; write for example scan(FILE, size=2.5 um"},
      {"scan(size=1 um)", "names no file"},
      {"scan(a.gsf, b.gsf)",
       "at 'b.gsf': a file is named already, and other arguments are written key=value"},
      {"scan(a.gsf, size=)", "at 'size': there is no value"},
      {"scan(a.gsf, size=0 um)", "'0 um' is no length above 0"},
      {"scan(a.gsf, size=-1 um)", "'-1 um' is no length above 0"},
      {"scan(a.gsf, cutoff=0 nm)", "'0 nm' is no wavelength above 0"},
      {"scan(a.gsf, cutoff=-5 nm)", "'-5 nm' is no wavelength above 0"},
      {"scan(a.gsf, outside=periodic)", "'periodic' is neither refuse nor mirror"},
      {"scan(a.gsf, unit=V)", "at 'unit': unit 'V' does not fit"},
      {"scan(a.gsf, depth=1 nm)", "those known are size, channel, unit, level, cutoff, outside"},
      {"scan(a.gsf, size=1 um, size=2 um)", "the entry 'size' stands twice"}};
  for (const auto& [spec, reason] : wrong)
    EXPECT_NE(message(spec).find(reason), std::string::npos) << message(spec);
}

TEST(ScanSpec_behaviour, its_text_holds_what_is_not_the_usual) {
  EXPECT_EQ(parse_scan(" a.gsf ").text(), "a.gsf");
  EXPECT_EQ(parse_scan("scan(a.gsf, level=plane, outside=refuse)").text(), "a.gsf");
  for (const std::string only :
       {"size=2.5 um", "channel=Height", "unit=nm", "level=mean", "cutoff=80 nm", "outside=mirror"})
    EXPECT_EQ(parse_scan("scan(a.gsf, " + only + ")").text(), "scan(a.gsf, " + only + ")");
  EXPECT_DOUBLE_EQ(parse_scan("scan(a.gsf, cutoff=80 nm)").cutoff, 80e-9);
  EXPECT_EQ(parse_scan("scan(a.gsf, outside=refuse)").outside, Outside::refuse);
}

TEST(ScanSpec_behaviour, a_scan_covers_a_square_up_to_its_narrower_side) {
  Topography map = written_scan();  // 0.8 x 0.6 um
  EXPECT_NO_THROW(require_cover(parse_scan("a.gsf"), map, 0.6e-6));
  EXPECT_THROW(require_cover(parse_scan("a.gsf"), map, 0.6001e-6), ScanError);
  EXPECT_NO_THROW(require_cover(parse_scan("scan(a.gsf, outside=mirror)"), map, 5e-6));
  std::swap(map.lx, map.ly);
  EXPECT_NO_THROW(require_cover(parse_scan("a.gsf"), map, 0.6e-6));
  EXPECT_THROW(require_cover(parse_scan("a.gsf"), map, 0.7e-6), ScanError);
  map.periodic = true;
  EXPECT_NO_THROW(require_cover(parse_scan("a.gsf"), map, 5e-6));
  map.periodic = false;
  const auto message = test::message_of<ScanError>(
      [&] { require_cover(parse_scan("scan(a.gsf, size=0.8 um)"), map, 0.7e-6); });
  EXPECT_NE(message.find("Topography = scan(a.gsf, size=800 nm, outside=mirror)"), std::string::npos)
      << message;
}

TEST(ScanSpec_behaviour, a_text_file_without_scale_is_refused_until_size_and_unit_are_given) {
  const test::TemporaryFolder folder;
  std::string rows;
  for (int iy = 0; iy < 8; ++iy) {
    for (int ix = 0; ix < 8; ++ix) rows += std::to_string((ix * 3 + iy * 5) % 7) + " ";
    rows += "\n";
  }
  const std::string file = folder.write("heights.txt", rows).string();
  const auto message = test::message_of<ScanError>([&] { topography_for(file); });
  EXPECT_NE(message.find("scan(FILE, size=2.5 um"), std::string::npos) << message;
  const Topography map = topography_for("scan(" + file + ", size=1 um, unit=nm, level=mean)");
  EXPECT_DOUBLE_EQ(map.lx, 1e-6);
  EXPECT_DOUBLE_EQ(map.ly, 1e-6);
  EXPECT_NEAR(height_moments(map).Sz, 6e-9, 1e-18);
}

}  // namespace asperity

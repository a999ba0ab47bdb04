#include "surfaces/surface_report.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "core/atomic_file.h"
#include "core/error.h"
#include "surfaces/generate.h"
#include "surfaces/read_topography.h"
#include "surfaces/sampler.h"
#include "surfaces/surface_of_entry.h"
#include "tests/support/shared_files.h"

namespace asperity {
namespace {

Topography scan() {
  GenerateOptions options;
  options.nx = options.ny = 128;
  options.lx = options.ly = 1e-6;
  options.rms = 2e-9;
  return generate_window(SelfAffineSpectrum{2e-9, 0.8, 150e-9, 30e-9}, 150e-9, options);
}

std::filesystem::path scratch(const std::string& name) {
  return std::filesystem::temp_directory_path() / ("asperity-" + std::to_string(getpid()) + "-" + name);
}

}  // namespace

TEST(SurfaceReport_behaviour, has_the_keys_that_other_programs_rely_on) {
  const auto json = to_json(measure_surface(scan(), Level::plane));
  for (const char* key : {"pixels", "size_m", "Sq_m", "Sa_m", "Sz_m", "Ssk", "Sku", "rms_slope",
                          "correlation_length_m", "missing", "channel", "level"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json["pixels"], nlohmann::ordered_json({128, 128}));
  EXPECT_EQ(json["level"], "plane");
  EXPECT_EQ(json["missing"], 0);
  EXPECT_NEAR(json["Sq_m"].get<double>(), 2e-9, 0.4e-9);
}

TEST(SurfaceReport_behaviour, of_a_flat_or_tiny_map_says_null_instead_of_a_number) {
  Topography flat;
  flat.nx = flat.ny = 8;
  flat.lx = flat.ly = 1e-6;
  flat.heights.assign(64, 1e-9);
  const auto measurement = measure_surface(flat, Level::mean);
  const auto json = nlohmann::json::parse(to_json(measurement).dump());
  EXPECT_EQ(json["Sq_m"], 0.0);
  EXPECT_TRUE(json["correlation_length_m"].is_null());
  EXPECT_TRUE(json["spectrum"].is_null());
  EXPECT_NE(to_text(measurement).find("cannot be judged"), std::string::npos);
}

TEST(SurfaceReport_behaviour, reads_back_the_spectrum_it_wrote) {
  const RadialSpectrum spectrum = radial_spectrum(scan());
  const auto file = scratch("psd.csv");
  write_file_atomically(file, spectrum_csv(spectrum));
  const TabulatedSpectrum table = read_spectrum_csv(file.string());
  ASSERT_EQ(table.q.size(), spectrum.table().q.size());
  EXPECT_NEAR(table.C[5] / spectrum.C[5], 1, 1e-7);
  write_file_atomically(file, "wave_number [rad/m],psd [m^4]\n2e6,1e-30\n1e6,1e-30\n");
  EXPECT_THROW(read_spectrum_csv(file.string()), InputError);
  std::filesystem::remove(file);
}

TEST(TopographySpec_behaviour, of_a_file_is_levelled_and_must_be_large_enough) {
  const auto file = scratch("scan.gsf");
  Topography tilted = scan();
  for (int iy = 0; iy < tilted.ny; ++iy)
    for (int ix = 0; ix < tilted.nx; ++ix) tilted.at(ix, iy) += 1e-9 * ix;
  write_gsf(file, tilted);
  EXPECT_LT(height_moments(topography_for(file.string())).Sq, 3e-9);
  EXPECT_NO_THROW(heights_over(file.string(), 0.9e-6).height(0.45e-6, -0.45e-6));
  EXPECT_THROW(heights_over(file.string(), 1.5e-6), InputError);
  EXPECT_THROW(topography_for("no such file"), InputError);
  std::filesystem::remove(file);
}

namespace {

double Sq(const std::filesystem::path& file, Level level) {
  return height_moments(levelled(read_topography(file), level)).Sq;
}

}  // namespace

// values by the scans' owners and by Gwyddion
TEST(Levelling_other_code, leaves_the_known_Sq_of_a_bruker_scan) {
  ASPERITY_SHARED_FILE_OR_SKIP(path, "topographies/di-5_1um_512.gsf");
  EXPECT_NEAR(Sq(path, Level::mean), 5.831926e-9, 1e-15);
  EXPECT_NEAR(Sq(path, Level::plane), 1.536e-9, 0.0005e-9);
  EXPECT_NEAR(Sq(path, Level::quadratic), 1.310e-9, 0.0005e-9);
}

TEST(Levelling_other_code, leaves_the_known_Sq_of_a_diamond_film) {
  ASPERITY_SHARED_FILE_OR_SKIP(path, "topographies/UNCD_100nm_512.gsf");
  EXPECT_NEAR(Sq(path, Level::plane), 4.688e-9, 0.0005e-9);
  EXPECT_NEAR(Sq(path, Level::quadratic), 3.763e-9, 0.0005e-9);
}

}  // namespace asperity

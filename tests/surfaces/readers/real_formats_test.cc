// Real files of instruments against the values that their owners' tests hold (shared/topographies/formats).
#include <fstream>

#include "surfaces/readers/format.h"
#include "surfaces/statistics.h"
#include "tests/support/shared_files.h"
#include "tests/surfaces/readers/stored_files.h"

using namespace asperity;
using namespace asperity::test;

namespace {

/// Raw root mean square about the mean [m].
double raw_rms(const Topography& map) { return height_moments(map).Sq; }

Topography channel_of(const std::filesystem::path& path, const std::string& channel) {
  ReadOptions options;
  options.channel = channel;
  return read_topography(path, options);
}

}  // namespace

TEST(Real_formats_other_code, nanosurf_scan_has_the_rms_of_its_owners_in_all_four_channels) {
  ASPERITY_SHARED_FILE_OR_SKIP(path, "topographies/formats/nid-1.nid");
  const double rms_nm[] = {239.5896706764167, 302.6701737129839, 239.41867686171115, 302.9781629305204};
  const std::string names[] = {"Scan forward (Z-Axis)", "Scan forward (Z-AxisSensor)",
                               "Scan backward (Z-Axis)", "Scan backward (Z-AxisSensor)"};
  for (int i = 0; i < 4; ++i) {
    const Topography map = channel_of(path, names[i]);
    EXPECT_EQ(map.nx, 256);
    EXPECT_EQ(map.ny, 256);
    EXPECT_NEAR(map.lx, 20e-6, 1e-12);
    EXPECT_NEAR(map.ly, 20e-6, 1e-12);
    EXPECT_NEAR(raw_rms(map), rms_nm[i] * 1e-9, 1e-9 * rms_nm[i] * 1e-9) << names[i];
  }
}

TEST(Real_formats_other_code, alicona_map_has_the_size_and_rms_of_its_owners) {
  ASPERITY_SHARED_FILE_OR_SKIP(path, "topographies/formats/al3d-1.al3d");
  const Topography map = read_topography(path);
  EXPECT_EQ(map.nx, 200);
  EXPECT_EQ(map.ny, 296);
  EXPECT_NEAR(map.lx, 87.6054e-6, 1e-15);
  EXPECT_NEAR(map.ly, 129.655992e-6, 1e-15);
  EXPECT_NEAR(raw_rms(map), 7.688266102603082e-6, 1e-12);  // theirs is summed in 32 bits
}

TEST(Real_formats_other_code, x3p_map_has_the_size_and_rms_of_its_owners) {
  ASPERITY_SHARED_FILE_OR_SKIP(path, "topographies/formats/x3p-2.x3p");
  const Topography map = read_topography(path);
  EXPECT_EQ(map.nx, 650);
  EXPECT_NEAR(map.lx, 82.9767313942749e-6, 1e-15);
  EXPECT_NEAR(map.ly, 204.4783737930349e-6, 1e-15);
  EXPECT_NEAR(raw_rms(map), 77.28033273597876e-9, 1e-18);
}

TEST(Real_formats_other_code, wyko_map_has_the_size_and_scale_of_its_owners) {
  ASPERITY_SHARED_FILE_OR_SKIP(path, "topographies/formats/opd-1.opd");
  const Topography map = read_topography(path);
  EXPECT_EQ(map.nx, 640);
  EXPECT_EQ(map.ny, 480);
  EXPECT_NEAR(map.lx, 0.125909140e-3, 1e-12);
  EXPECT_NEAR(map.ly, 0.094431855e-3, 1e-12);
  EXPECT_SAYS(map.source, "heights in 577.295 nm");  // 0.0005772949829101563 mm
  EXPECT_EQ(map.missing_count(), 116u);
}

TEST(Real_formats_other_code, digital_surf_map_has_the_size_of_its_owners) {
  ASPERITY_SHARED_FILE_OR_SKIP(path, "topographies/formats/sur-3.sur");
  const Topography map = read_topography(path);
  EXPECT_EQ(map.nx, 512);
  EXPECT_EQ(map.ny, 512);
  EXPECT_NEAR(map.lx, 0.151319552, 1e-8);
}

TEST(Real_formats_other_code, picoview_scan_has_the_channels_and_size_of_its_owners) {
  ASPERITY_SHARED_FILE_OR_SKIP(path, "topographies/formats/mi-1.mi");
  const Topography map = read_topography(path);
  EXPECT_EQ(map.channel, "Topography");
  EXPECT_SAYS(map.source, "channel 0 of 4");
  EXPECT_EQ(map.nx, 256);
  EXPECT_NEAR(map.lx, 20e-6, 1e-15);
}

// 226.425396685 nm and the range are Gwyddion's.
TEST(Real_formats_other_code, nanoscope_scan_has_the_rms_of_its_owners) {
  ASPERITY_SHARED_FILE_OR_SKIP(path, "topographies/formats/di-3.di");
  EXPECT_NEAR(raw_rms(read_topography(path)), 226.4e-9, 0.05e-9);
  EXPECT_NEAR(raw_rms(read_topography(path)), 226.425396685e-9, 1e-17);
}

TEST(Real_formats_other_code, igor_wave_without_names_and_units_asks_for_its_size) {
  ASPERITY_SHARED_FILE_OR_SKIP(path, "topographies/formats/10x10-one_channel_without_name.ibw");
  EXPECT_SAYS(refusal(path), "names no unit of length");
  ReadOptions options;
  options.size_x_m = 10e-6;
  options.height_unit = "nm";
  const Topography map = read_topography(path, options);
  EXPECT_EQ(map.nx, 10);
  EXPECT_EQ(map.ny, 10);
  EXPECT_EQ(map.channel, "layer 0");
}

TEST(Real_formats_other_code, packed_text_with_a_factor_of_heights_has_the_size_and_rms_of_its_owners) {
  ASPERITY_SHARED_FILE_OR_SKIP(path, "topographies/formats/matrix-4.txt.gz");
  const Topography map = read_topography(path);
  EXPECT_EQ(map.nx, 75);
  EXPECT_EQ(map.ny, 305);
  EXPECT_NEAR(map.lx, 2.773965e-05, 1e-16);
  EXPECT_NEAR(map.ly, 0.00011280791, 1e-16);
  EXPECT_NEAR(raw_rms(map), 1.1745891510991089e-07, 1e-20);
}

TEST(Real_formats_other_code, gwyddion_exports_in_english_and_german_are_the_same_map) {
  for (const std::string language : {"english", "german"}) {
    ASPERITY_SHARED_FILE_OR_SKIP(path, "topographies/formats/gwyddion-export-" + language + ".txt");
    const Topography map = read_topography(path);
    EXPECT_EQ(map.channel, "My Channel Name");
    EXPECT_NEAR(map.lx, 12.34e-6, 1e-18);
    EXPECT_NEAR(map.ly, 5678.9e-9, 1e-18);
    EXPECT_DOUBLE_EQ(map.at(1, 3), 1.5);  // the first row is the top
  }
}

TEST(Real_formats_other_code, numpy_array_of_two_by_two_is_read_once_sized) {
  ASPERITY_SHARED_FILE_OR_SKIP(path, "topographies/formats/example-2d.npy");
  EXPECT_SAYS(refusal(path), "does not say how wide the map is");
  ReadOptions options;
  options.size_x_m = 1e-6;
  options.height_unit = "nm";
  EXPECT_EQ(read_topography(path, options).nx, 2);
}

TEST(Real_formats_behaviour, the_documentation_lists_every_format) {
  std::ifstream stream(reference_folder() / ".." / ".." / ".." / "docs" / "surfaces.md");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  for (const auto& format : topography_formats()) {
    if (format.name.find("own") != std::string::npos) continue;  // of these tests (own_format.cc)
    EXPECT_NE(text.find(format.name), std::string::npos) << format.name;
  }
}

#include "surfaces/levelling.h"
#include "surfaces/statistics.h"
#include "tests/support/shared_files.h"
#include "tests/surfaces/readers/stored_files.h"

using namespace asperity;
using namespace asperity::test;

namespace {

/// One part of a zip archive, unpacked into a file of this test's own.
std::filesystem::path unpacked(const std::filesystem::path& archive_path, const std::string& part) {
  int error = 0;
  zip_t* archive = zip_open(archive_path.c_str(), ZIP_RDONLY, &error);
  EXPECT_NE(archive, nullptr);
  zip_stat_t about;
  EXPECT_EQ(zip_stat(archive, part.c_str(), 0, &about), 0);
  std::string bytes(about.size, '\0');
  zip_file_t* file = zip_fopen(archive, part.c_str(), 0);
  EXPECT_EQ(zip_fread(file, bytes.data(), bytes.size()), static_cast<zip_int64_t>(bytes.size()));
  zip_fclose(file);
  zip_discard(archive);
  return write_bytes(part, bytes);
}

double mean(const Topography& map) {
  double sum = 0;
  for (const double height : map.heights) sum += height;
  return sum / map.heights.size();
}

/// Largest difference of heights counted from their means, after mirroring `other` up and down.
double difference_to_mirrored(const Topography& map, const Topography& other) {
  const double shift = mean(map) - mean(other);
  double largest = 0;
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
      largest = std::max(largest, std::abs(map.at(ix, iy) - other.at(ix, map.ny - 1 - iy) - shift));
  return largest;
}

}  // namespace

TEST(Nanoscope_file_behaviour, of_16_bit_is_scaled_and_its_first_row_is_the_bottom) {
  const Topography map = read_topography(write_bytes("a.001", nanoscope_bytes({{}}, 2)));
  expect_common_map(map);
  EXPECT_EQ(map.channel, "Height Sensor");
  EXPECT_SAYS(map.source, "16.00000 nm/V x 4.096000 V over 2^16 steps");
  EXPECT_SAYS(map.source, "first row stored is the bottom");
}

TEST(Nanoscope_file_behaviour, of_32_bit_is_scaled_over_all_its_steps) {
  NanoscopeImage image;
  image.bytes_per_pixel = 4;
  expect_common_map(read_topography(write_bytes("a.spm", nanoscope_bytes({image}, 4, "0x09300000"))));
}

TEST(Nanoscope_file_behaviour, of_32_bit_that_says_16_keeps_the_scale_of_16) {
  expect_common_map(read_topography(write_bytes("a.spm", nanoscope_bytes({{}}, 4, "0x09300000"))));
}

TEST(Nanoscope_file_behaviour, gives_the_height_channel_unless_another_is_wished) {
  NanoscopeImage phase, height, retrace;
  phase.name = "Phase";
  phase.sensitivity = "Sens. Phase";
  height.name = retrace.name = "Height";
  const auto path = write_bytes("a.001", nanoscope_bytes({phase, height, retrace}, 2));
  const Topography map = read_topography(path);
  EXPECT_EQ(map.channel, "Height");
  EXPECT_SAYS(map.source, "channel 1 of 3");
  ReadOptions options;
  options.channel = "2";
  EXPECT_SAYS(read_topography(path, options).source, "channel 2 of 3");
  options.channel = "Phase";
  EXPECT_SAYS(refusal(path, options), "holds no heights");
  options.channel = "Modulus";
  EXPECT_SAYS(refusal(path, options), "has no channel 'Modulus'");
}

TEST(Nanoscope_file_behaviour, with_one_scan_size_is_square) {
  NanoscopeImage image;
  image.scan_size = "500 nm";
  const Topography map = read_topography(write_bytes("a.001", nanoscope_bytes({image}, 2)));
  EXPECT_DOUBLE_EQ(map.lx, 500e-9);
  EXPECT_DOUBLE_EQ(map.ly, 500e-9);
}

TEST(Nanoscope_file_behaviour, cut_off_is_refused) {
  const std::string bytes = nanoscope_bytes({{}}, 2);
  const std::string sentence = refusal(write_bytes("a.001", bytes.substr(0, bytes.size() - 1)));
  EXPECT_SAYS(sentence,
              "has " + std::to_string(bytes.size() - 1) + " of at least " + std::to_string(bytes.size()));
  EXPECT_SAYS(sentence, "cut off");
  EXPECT_SAYS(refusal(write_bytes("b.001", bytes.substr(0, 300))), "ends inside its NanoScope header");
}

TEST(Nanoscope_file_behaviour, before_version_4_3_is_refused_with_a_way_out) {
  const std::string old =
      "\\*File list\r\n\\Version: 0x04220200\r\n\\*NCAFM image list\r\n\\Z scale height: 12\r\n\\*File list "
      "end\r\n";
  EXPECT_SAYS(refusal(write_bytes("a.001", old)), "before 4.3; open it in Gwyddion");
}

TEST(Nanoscope_file_behaviour, without_images_or_entries_is_refused) {
  EXPECT_SAYS(refusal(write_bytes("a.001", "\\*File list\r\n\\*File list end\r\n")), "without images");
  std::string bytes = nanoscope_bytes({{}}, 2);
  bytes.replace(bytes.find("\\Samps/line"), 11, "\\Simps/line");
  EXPECT_SAYS(refusal(write_bytes("b.001", bytes)), "lacks 'samps/line'");
}

// The raw RMS is what the owners of the file test their own reader for.
TEST(Nanoscope_real_other_code, bruker_scan_has_the_rms_of_its_owners) {
  ASPERITY_SHARED_FILE_OR_SKIP(path, "topographies/SurfaceTopography_di-5.di");
  const Topography map = read_topography(path);
  EXPECT_EQ(map.nx, 512);
  EXPECT_EQ(map.ny, 512);
  EXPECT_DOUBLE_EQ(map.lx, 1e-6);
  EXPECT_DOUBLE_EQ(map.ly, 1e-6);
  EXPECT_EQ(map.channel, "Height Sensor");
  EXPECT_NEAR(height_statistics(map).Sq, 5.831926e-9, 0.0000005e-9);
  EXPECT_NEAR(height_statistics(levelled(map, Level::plane)).Sq, 1.536e-9, 0.0005e-9);
  EXPECT_NEAR(height_statistics(levelled(map, Level::quadratic)).Sq, 1.310e-9, 0.0005e-9);
}

// The .gsf beside it was written in the order of the instrument's rows, bottom first, while the format says
// top first: a viewer shows one as the mirror image of the other, and so do the readers. Heights agree to
// 32-bit rounding.
TEST(Nanoscope_real_other_code, agrees_with_its_conversion_up_to_the_order_of_rows) {
  ASPERITY_SHARED_FILE_OR_SKIP(path, "topographies/SurfaceTopography_di-5.di");
  const auto converted = shared_file("topographies/di-5_1um_512.gsf");
  if (!converted)
    GTEST_SKIP() << "no "
                    "topographies/di-5_1um_512.gsf"
                    " on this machine";
  EXPECT_LT(difference_to_mirrored(read_topography(path), read_topography(*converted)), 1e-15);
}

TEST(Nanoscope_real_other_code, diamond_scan_of_the_container_agrees_with_its_conversion) {
  const auto container = shared_file("topographies/SurfaceTopography_container-2.zip");
  if (!container)
    GTEST_SKIP() << "no "
                    "topographies/SurfaceTopography_container-2.zip"
                    " on this machine";
  const auto converted = shared_file("topographies/UNCD_100nm_512.gsf");
  if (!converted)
    GTEST_SKIP() << "no "
                    "topographies/UNCD_100nm_512.gsf"
                    " on this machine";
  const Topography map = read_topography(unpacked(*container, "gain_control_uncd_35_z03tr3R.001"));
  EXPECT_DOUBLE_EQ(map.lx, 1e-7);
  EXPECT_EQ(map.channel, "Height");
  EXPECT_NEAR(height_statistics(levelled(map, Level::plane)).Sq, 4.688e-9, 0.0005e-9);
  EXPECT_NEAR(height_statistics(levelled(map, Level::quadratic)).Sq, 3.763e-9, 0.0005e-9);
  EXPECT_LT(difference_to_mirrored(map, read_topography(*converted)), 5e-15);
}

// A conversion of our own keeps the orientation.
TEST(Nanoscope_real_behaviour, written_as_gsf_and_read_again_has_the_same_orientation) {
  ASPERITY_SHARED_FILE_OR_SKIP(path, "topographies/SurfaceTopography_di-5.di");
  const Topography map = read_topography(path);
  const auto copy = write_bytes("copy.gsf", "");
  write_gsf(copy, map);
  const Topography again = read_topography(copy);
  double largest = 0;
  for (std::size_t i = 0; i < map.heights.size(); ++i)
    largest = std::max(largest, std::abs(map.heights[i] - again.heights[i]));
  EXPECT_LT(largest, 1e-13);  // 32-bit rounding of heights of some 100 nm
}

TEST(Nanoscope_real_behaviour, profiles_of_the_container_are_refused_as_profiles) {
  const auto container = shared_file("topographies/SurfaceTopography_container-2.zip");
  if (!container)
    GTEST_SKIP() << "no "
                    "topographies/SurfaceTopography_container-2.zip"
                    " on this machine";
  EXPECT_SAYS(refusal(unpacked(*container, "80_Scale10.472_FIXEDv2p1_D7eHXiT.asc")),
              "a profile and not a map");
  EXPECT_SAYS(refusal(unpacked(*container, "uncd_stylus_300um_5mar_3_k0HpKJt.txt")),
              "a profile and not a map");
  EXPECT_SAYS(refusal(*container), "unpack it");
}

namespace {

std::string with(std::string bytes, const std::string& from, const std::string& to) {
  const auto at = bytes.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  std::string changed = to;
  changed.resize(from.size(), ' ');  // data stay where the header says
  return bytes.replace(at, from.size(), changed);
}

}  // namespace

TEST(Nanoscope_analytic, volts_of_scale_and_sensitivity_may_have_prefixes) {
  const std::string bytes = nanoscope_bytes({{}}, 2);
  // 4.096 V with 16 nm/V each, in other words.
  expect_common_map(read_topography(write_bytes("a.001", with(bytes, "4.096000 V", "4096.0 mV"))));
  expect_common_map(read_topography(write_bytes("a.001", with(bytes, "4.096000 V", "4096e3 uV"))));
  expect_common_map(read_topography(write_bytes("a.001", with(bytes, "4.096000 V", ".0040960kV"))));
  expect_common_map(read_topography(write_bytes("a.001", with(bytes, "16.00000 nm/V", "0.016 nm/mV"))));
  expect_common_map(read_topography(write_bytes("a.001", with(bytes, "16.00000 nm/V", "0.016 ~m/V"))));
}

TEST(Nanoscope_file_behaviour, without_a_scale_to_lengths_holds_no_heights) {
  const std::string bytes = nanoscope_bytes({{}}, 2);
  for (const auto& [from, to] :
       std::vector<std::pair<std::string, std::string>>{{"16.00000 nm/V", "16.00000 pA/V"},
                                                        {"16.00000 nm/V", "16.00000 nm/A"},
                                                        {"4.096000 V", "4.096000 A"},
                                                        {"\\@Sens. Zsens", "\\@Sens. Ysens"}})
    EXPECT_SAYS(refusal(write_bytes("a.001", with(bytes, from, to))), "holds no heights") << to;
}

TEST(Nanoscope_analytic, a_scale_of_lengths_needs_no_sensitivity) {
  // 65.536 nm over 2^16 steps: 1 nm per 1000 steps.
  const std::string bytes = with(nanoscope_bytes({{}}, 2), "V [Sens. Zsens] (0.0000625 V/LSB) 4.096000 V",
                                 "V (0.001 nm/LSB) 65.536 nm");
  const Topography map = read_topography(write_bytes("a.001", bytes));
  expect_common_map(map);
  EXPECT_SAYS(map.source, "heights 65.536 nm over 2^16 steps");
}

TEST(Nanoscope_file_behaviour, names_the_line_direction_if_it_is_said) {
  const std::string bytes = nanoscope_bytes({{}}, 2);
  EXPECT_SAYS(read_topography(write_bytes("a.001", bytes)).source, "channel 0 of 1, trace");
  const Topography silent = read_topography(
      write_bytes("a.001", with(bytes, "\\Line Direction: Trace", "\\Lone Direction: Trace")));
  EXPECT_EQ(silent.source.find(", trace"), std::string::npos) << silent.source;
}

TEST(Nanoscope_file_behaviour, numbers_that_cannot_be_are_refused_by_their_entry) {
  const std::string bytes = nanoscope_bytes({{}}, 2);
  EXPECT_SAYS(refusal(write_bytes("a.001", with(bytes, "\\Samps/line: 3", "\\Samps/line: x"))),
              "has 'x' for 'samps/line'");
  EXPECT_SAYS(refusal(write_bytes("a.001", with(bytes, "\\Number of lines: 2", "\\Number of lines: -"))),
              "has '-' for 'number of lines'");
  EXPECT_SAYS(refusal(write_bytes("a.001", with(bytes, "\\Number of lines: 2", "\\Number of lines: 9"))),
              "keeps 12 bytes for 27 pixels, which is too few");
}

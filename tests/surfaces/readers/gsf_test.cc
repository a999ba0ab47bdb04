#include "surfaces/levelling.h"
#include "surfaces/statistics.h"
#include "tests/support/shared_files.h"
#include "tests/surfaces/readers/stored_files.h"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::string fields =
    "XRes = 3\nYRes = 2\nXReal = 3e-6\nYReal = 2e-6\nXYUnits = m\nZUnits = m\nTitle = Height Sensor\n";

std::vector<float> metres() { return {1e-9f, 2e-9f, 3e-9f, 4e-9f, 5e-9f, 6e-9f}; }

double sq(const Topography& map, Level level) { return height_statistics(levelled(map, level)).Sq; }

}  // namespace

TEST(Gsf_file_behaviour, is_read_with_its_top_row_on_top) {
  const Topography map = read_topography(write_bytes("a.gsf", gsf_bytes(fields, metres())));
  expect_common_map(map);
  EXPECT_EQ(map.channel, "Height Sensor");
  EXPECT_SAYS(map.source, "first row stored is the top");
}

TEST(Gsf_file_behaviour, is_recognised_by_its_content_whatever_its_name) {
  expect_common_map(read_topography(write_bytes("a.dat", gsf_bytes(fields, metres()))));
}

TEST(Gsf_file_behaviour, header_padding_of_every_length_is_skipped) {
  for (const std::string title : {"a", "ab", "abc", "abcd"}) {
    const std::string padded = fields.substr(0, fields.find("Title")) + "Title = " + title + "\n";
    expect_common_map(read_topography(write_bytes("a.gsf", gsf_bytes(padded, metres()))));
  }
}

TEST(Gsf_file_behaviour, nan_is_a_missing_point_and_not_zero) {
  auto heights = metres();
  heights[0] = std::nanf("");
  const Topography map = read_topography(write_bytes("a.gsf", gsf_bytes(fields, heights)));
  EXPECT_EQ(map.missing_count(), 1u);
  EXPECT_TRUE(map.missing[3]);  // left end of the upper row
  EXPECT_TRUE(std::isnan(map.at(0, 1)));
  EXPECT_SAYS(describe(map), "1 missing points");
}

TEST(Gsf_file_behaviour, without_size_asks_for_it) {
  const auto path = write_bytes("a.gsf", gsf_bytes("XRes = 3\nYRes = 2\nZUnits = m\n", metres()));
  EXPECT_SAYS(refusal(path), "--size \"2.5 um\"");
  ReadOptions options;
  options.size_x_m = 3e-6;
  expect_common_map(read_topography(path, options));
}

TEST(Gsf_file_behaviour, size_passed_wins_and_is_said_back) {
  ReadOptions options;
  options.size_x_m = 6e-6;
  options.size_y_m = 1e-6;
  const Topography map = read_topography(write_bytes("a.gsf", gsf_bytes(fields, metres())), options);
  EXPECT_DOUBLE_EQ(map.lx, 6e-6);
  EXPECT_DOUBLE_EQ(map.ly, 1e-6);
  EXPECT_SAYS(map.source, "size as passed instead of the file's 3 um x 2 um");
}

TEST(Gsf_file_behaviour, cut_off_is_refused_with_both_sizes) {
  const std::string bytes = gsf_bytes(fields, metres());
  const std::string sentence = refusal(write_bytes("a.gsf", bytes.substr(0, bytes.size() - 5)));
  EXPECT_SAYS(sentence, "cut off");
  EXPECT_SAYS(sentence, std::to_string(bytes.size() - 5) + " of the " + std::to_string(bytes.size()));
  EXPECT_SAYS(refusal(write_bytes("b.gsf", bytes.substr(0, 40))), "cut off");
  EXPECT_SAYS(refusal(write_bytes("c.gsf", bytes + "more")), "more bytes");
}

TEST(Gsf_file_behaviour, of_voltages_is_refused) {
  const std::string volts = "XRes = 3\nYRes = 2\nXReal = 3e-6\nYReal = 2e-6\nXYUnits = m\nZUnits = V\n";
  EXPECT_SAYS(refusal(write_bytes("a.gsf", gsf_bytes(volts, metres()))), "'V', which is no length");
}

TEST(Gsf_file_behaviour, of_wrong_pixel_numbers_is_refused) {
  for (const std::string number : {"0", "-3", "2.5", "many", "1e300"})
    EXPECT_SAYS(refusal(write_bytes("a.gsf", gsf_bytes("XRes = " + number + "\nYRes = 2\n", metres()))),
                "'XRes'");
}

TEST(Gsf_file_behaviour, without_unit_of_height_is_metres_if_that_is_plausible) {
  const std::string bare = "XRes = 3\nYRes = 2\nXReal = 3e-6\nYReal = 2e-6\nXYUnits = m\n";
  const Topography map = read_topography(write_bytes("a.gsf", gsf_bytes(bare, metres())));
  expect_common_map(map);
  EXPECT_SAYS(map.source, "metres taken");
  EXPECT_SAYS(refusal(write_bytes("b.gsf", gsf_bytes(bare, {1, 2, 3, 4, 5, 6}))), "higher than wide");
}

TEST(Gsf_file_behaviour, written_and_read_again_is_the_same_map) {
  Topography map;
  map.nx = 4;
  map.ny = 3;
  map.lx = 0.1 + 0.2;  // needs all digits
  map.ly = 1e-7;
  map.channel = "Height";
  map.missing.assign(12, 0);
  for (int i = 0; i < 12; ++i) map.heights.push_back(static_cast<float>(1e-9 * std::sin(i)));
  map.missing[5] = 1;
  map.heights[5] = std::nan("");
  const auto path = write_bytes("a.gsf", "");
  write_gsf(path, map);
  const Topography again = read_topography(path);
  EXPECT_EQ(again.lx, map.lx);
  EXPECT_EQ(again.ly, map.ly);
  EXPECT_EQ(again.channel, map.channel);
  EXPECT_EQ(again.missing, map.missing);
  for (int i = 0; i < 12; ++i) {
    if (i == 5) continue;
    EXPECT_EQ(again.heights[i], map.heights[i]);
  }
}

TEST(Gsf_written_file_behaviour, is_byte_for_byte_what_the_format_says) {
  Topography map;
  map.nx = 3;
  map.ny = 2;
  map.lx = 0.5;
  map.ly = 0.25;
  for (const double nm : {4, 5, 6, 1, 2, 3}) map.heights.push_back(nm * 1e-9);
  const auto path = write_bytes("a.gsf", "");
  write_gsf(path, map);
  EXPECT_EQ(bytes_of(path),
            gsf_bytes("XRes = 3\nYRes = 2\nXReal = 0.5\nYReal = 0.25\nXYUnits = m\nZUnits = m\n", metres()));
}

// Sq as stated beside the files, computed by other code.
TEST(Gsf_real_other_code, bruker_scan_has_its_known_roughness) {
  ASPERITY_SHARED_FILE_OR_SKIP(path, "topographies/di-5_1um_512.gsf");
  const Topography map = read_topography(path);
  EXPECT_EQ(map.nx, 512);
  EXPECT_EQ(map.ny, 512);
  EXPECT_DOUBLE_EQ(map.lx, 1e-6);
  EXPECT_NEAR(sq(map, Level::plane), 1.536e-9, 0.0005e-9);
  EXPECT_NEAR(sq(map, Level::quadratic), 1.310e-9, 0.0005e-9);
}

TEST(Gsf_real_other_code, diamond_scan_has_its_known_roughness) {
  ASPERITY_SHARED_FILE_OR_SKIP(path, "topographies/UNCD_100nm_512.gsf");
  const Topography map = read_topography(path);
  EXPECT_DOUBLE_EQ(map.lx, 1e-7);
  EXPECT_NEAR(sq(map, Level::plane), 4.688e-9, 0.0005e-9);
  EXPECT_NEAR(sq(map, Level::quadratic), 3.763e-9, 0.0005e-9);
}

TEST(Gsf_analytic, heights_and_sizes_are_scaled_by_their_units) {
  const std::string other = "XRes = 3\nYRes = 2\nXReal = 3\nYReal = 2\nXYUnits = um\nZUnits = nm\n";
  const Topography map = read_topography(write_bytes("a.gsf", gsf_bytes(other, {1, 2, 3, 4, 5, 6})));
  expect_common_map(map);
  EXPECT_SAYS(map.source, "heights in nm");
}

TEST(Gsf_file_behaviour, with_one_side_only_asks_for_the_size) {
  for (const std::string side : {"XReal = 3e-6\n", "YReal = 2e-6\n"})
    EXPECT_SAYS(refusal(write_bytes(
                    "a.gsf", gsf_bytes("XRes = 3\nYRes = 2\nXYUnits = m\nZUnits = m\n" + side, metres()))),
                "pass its size");
  // A unit of length that is none is refused with either side.
  for (const std::string side : {"XReal = 3e-6\n", "YReal = 2e-6\n"})
    EXPECT_SAYS(refusal(write_bytes(
                    "a.gsf", gsf_bytes("XRes = 3\nYRes = 2\nXYUnits = V\nZUnits = m\n" + side, metres()))),
                "has XYUnits 'V', which is no length");
}

TEST(Gsf_file_behaviour, without_unit_of_length_is_metres_if_that_is_plausible) {
  const std::string sized = "XRes = 3\nYRes = 2\nZUnits = m\n";
  const Topography map =
      read_topography(write_bytes("a.gsf", gsf_bytes(sized + "XReal = 3e-6\nYReal = 2e-6\n", metres())));
  expect_common_map(map);
  EXPECT_SAYS(map.source, "XYUnits not given, metres taken");
  EXPECT_SAYS(refusal(write_bytes("b.gsf", gsf_bytes(sized + "XReal = 3\nYReal = 2\n", metres()))),
              "names no unit of length");
}

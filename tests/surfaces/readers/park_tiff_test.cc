#include "tests/surfaces/readers/stored_files.h"

using namespace asperity;
using namespace asperity::test;

namespace {

/// Stored numbers 1..6, bottom row first; with the default gain 1 is 1 nm.
template <class T>
std::string stored() {
  std::string data;
  for (const int value : {4, 5, 6, 1, 2, 3}) data += raw<T>(value);
  return data;
}

ParkImage of_16_bit() {
  ParkImage image;
  image.data = stored<std::int16_t>();
  return image;
}

}  // namespace

TEST(Park_tiff_behaviour, of_each_number_type_is_read_with_its_first_row_at_the_bottom) {
  ParkImage image = of_16_bit();
  expect_common_map(read_topography(write_bytes("a.tiff", park_bytes(image))));
  image.data_type = 1;
  image.data = stored<std::int32_t>();
  expect_common_map(read_topography(write_bytes("b.tiff", park_bytes(image))));
  image.data_type = 2;
  image.data = stored<float>();
  const Topography map = read_topography(write_bytes("c.tiff", park_bytes(image)));
  expect_common_map(map);
  EXPECT_EQ(map.channel, "ZHeight");
}

TEST(Park_tiff_behaviour, of_version_1_has_16_bit) {
  ParkImage image = of_16_bit();
  image.version = 0x01000001;
  expect_common_map(read_topography(write_bytes("a.tiff", park_bytes(image))));
}

TEST(Park_tiff_behaviour, gain_multiplies_scale_and_offset) {
  ParkImage image = of_16_bit();
  image.gain = 2e-3;
  image.scale = 0.5;
  image.offset = 3;
  const Topography map = read_topography(write_bytes("a.tiff", park_bytes(image)));
  EXPECT_NEAR(map.at(0, 0), 2e-9 * (0.5 * 4 + 3), 1e-18);
}

TEST(Park_tiff_behaviour, scale_of_zero_and_missing_unit_mean_one_and_micrometres) {
  ParkImage image = of_16_bit();
  image.scale = 0;
  image.unit = "";
  expect_common_map(read_topography(write_bytes("a.tiff", park_bytes(image))));
}

TEST(Park_tiff_behaviour, of_volts_is_refused) {
  ParkImage image = of_16_bit();
  image.unit = "V";
  EXPECT_SAYS(refusal(write_bytes("a.tiff", park_bytes(image))), "holds no heights, only 0: 'ZHeight' in V");
}

TEST(Park_tiff_behaviour, of_a_line_profile_is_refused) {
  ParkImage image = of_16_bit();
  image.image_type = 1;
  EXPECT_SAYS(refusal(write_bytes("a.tiff", park_bytes(image))), "a line profile");
}

TEST(Park_tiff_behaviour, picture_without_heights_is_refused_with_a_reason) {
  EXPECT_SAYS(refusal(write_bytes("a.tiff", park_bytes(of_16_bit(), 7))), "holds colours");
  EXPECT_SAYS(refusal(write_bytes("b.tiff", std::string("MM\0*\0\0\0\x08", 8))), "big-endian TIFF picture");
}

TEST(Park_tiff_behaviour, cut_off_anywhere_is_refused) {
  const std::string bytes = park_bytes(of_16_bit());
  for (std::size_t length = 4; length + 4 < bytes.size();
       ++length)  // the last four bytes say that no picture follows
    EXPECT_SAYS(refusal(write_bytes("a.tiff", bytes.substr(0, length))), "cut off");
}

TEST(Park_tiff_behaviour, with_too_few_data_is_refused) {
  ParkImage image = of_16_bit();
  image.data.resize(10);
  EXPECT_SAYS(refusal(write_bytes("a.tiff", park_bytes(image))), "keeps 10 bytes for 3 x 2 pixels");
}

#include "tests/surfaces/readers/stored_files.h"

using namespace asperity;
using namespace asperity::test;

namespace {

std::vector<double> metres() {
  std::vector<double> heights;
  for (const double nm : heights_nm()) heights.push_back(nm * 1e-9);
  return heights;
}

/// Components that a real file also has and a height map does not need.
std::string clutter() {
  return gwy_component("/filename", 's', std::string("/home/a/b.gwy") + '\0') +
         gwy_component("/0/base/range-type", 'i', raw<std::int32_t>(2)) +
         gwy_component("/0/data/visible", 'b', std::string(1, '\1')) +
         gwy_component("/big", 'q', raw<std::int64_t>(7)) + gwy_component("/one", 'c', "x") +
         gwy_component("/raw", 'C', raw<std::uint32_t>(3) + "abc") +
         gwy_component("/ints", 'I', raw<std::uint32_t>(1) + raw<std::int32_t>(5)) +
         gwy_component("/longs", 'Q', raw<std::uint32_t>(1) + raw<std::int64_t>(5)) +
         gwy_component("/names", 'S', raw<std::uint32_t>(2) + std::string("a\0bc\0", 5)) +
         gwy_component("/objects", 'O', raw<std::uint32_t>(1) + gwy_unit("V")) +
         gwy_component("/0/meta", 'o',
                       gwy_object("GwyContainer", gwy_component("Date", 's', std::string("today") + '\0')));
}

std::string height_channel() {
  return gwy_component("/1/data", 'o', gwy_field(metres(), "m")) +
         gwy_component("/1/data/title", 's', std::string("Topography") + '\0');
}
std::string phase_channel() {
  return gwy_component("/0/data", 'o', gwy_field(metres(), "deg")) +
         gwy_component("/0/data/title", 's', std::string("Phase") + '\0');
}

}  // namespace

TEST(Gwy_file_behaviour, gives_its_height_channel_among_others) {
  const Topography map =
      read_topography(write_bytes("a.gwy", gwy_bytes(clutter() + phase_channel() + height_channel())));
  expect_common_map(map);
  EXPECT_EQ(map.channel, "Topography");
}

TEST(Gwy_file_behaviour, points_under_the_mask_are_missing) {
  const auto mask = gwy_component("/1/mask", 'o', gwy_field({0, 1, 0, 0, 0, 0}, ""));
  const Topography map = read_topography(write_bytes("a.gwy", gwy_bytes(height_channel() + mask)));
  EXPECT_EQ(map.missing_count(), 1u);
  EXPECT_TRUE(std::isnan(map.at(1, 1)));
  EXPECT_SAYS(map.source, "1 points under the file's mask taken as missing");
}

TEST(Gwy_file_behaviour, channel_is_chosen_by_name_or_number) {
  const auto path = write_bytes("a.gwy", gwy_bytes(phase_channel() + height_channel()));
  ReadOptions options;
  for (const std::string wish : {"topography", "1"}) {
    options.channel = wish;
    expect_common_map(read_topography(path, options));
  }
  options.channel = "Phase";
  EXPECT_SAYS(refusal(path, options), "holds no heights");
  options.channel = "Friction";
  EXPECT_SAYS(refusal(path, options), "0: 'Phase' in deg, 1: 'Topography' in m");
}

TEST(Gwy_file_behaviour, without_heights_is_refused_with_what_it_holds) {
  EXPECT_SAYS(refusal(write_bytes("a.gwy", gwy_bytes(phase_channel()))),
              "holds no heights, only 0: 'Phase' in deg");
  EXPECT_SAYS(refusal(write_bytes("b.gwy", gwy_bytes(clutter()))), "no image channel");
}

TEST(Gwy_file_behaviour, cut_off_anywhere_is_refused) {
  const std::string bytes = gwy_bytes(clutter() + phase_channel() + height_channel());
  for (std::size_t length = 4; length < bytes.size(); ++length) {
    const std::string sentence = refusal(write_bytes("a.gwy", bytes.substr(0, length)));
    EXPECT_TRUE(sentence.find("cut off") != std::string::npos) << length << ": " << sentence;
  }
}

TEST(Gwy_file_behaviour, with_wrong_bytes_is_refused_or_read_but_never_crashes) {
  const std::string bytes = gwy_bytes(clutter() + height_channel());
  for (std::size_t at = 4; at < bytes.size(); ++at) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(0xFF);
    EXPECT_NO_FATAL_FAILURE(refusal(write_bytes("a.gwy", changed)));
  }
}

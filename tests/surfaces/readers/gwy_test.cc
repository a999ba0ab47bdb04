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

namespace {

/// A field of 3 x 2 points with the given parts in the place of the usual ones.
std::string field_with(const std::string& parts, const std::string& unit = "m",
                       const std::vector<double>& heights = metres()) {
  return gwy_object("GwyDataField", parts + gwy_component("si_unit_z", 'o', gwy_unit(unit)) +
                                        gwy_component("data", 'D', gwy_doubles(heights)));
}
std::string pixels(double columns, double rows) {
  return gwy_component("xres", 'd', raw(columns)) + gwy_component("yres", 'd', raw(rows));
}
std::string extent(double x, double y, const std::string& unit) {
  return gwy_component("xreal", 'd', raw(x)) + gwy_component("yreal", 'd', raw(y)) +
         gwy_component("si_unit_xy", 'o', gwy_unit(unit));
}
std::filesystem::path file_of(const std::string& field) {
  return write_bytes("a.gwy", gwy_bytes(gwy_component("/0/data", 'o', field)));
}

}  // namespace

TEST(Gwy_file_behaviour, only_a_data_field_under_a_channels_name_is_a_channel) {
  // Masks and presentations are fields, too, and names alone are none.
  EXPECT_SAYS(
      refusal(write_bytes("a.gwy", gwy_bytes(gwy_component("/0/mask", 'o', gwy_field(metres(), "m"))))),
      "no image channel");
  EXPECT_SAYS(
      refusal(write_bytes("b.gwy", gwy_bytes(gwy_component("/0/data", 's', std::string("text") + '\0')))),
      "no image channel");
  EXPECT_SAYS(refusal(write_bytes("c.gwy", gwy_bytes(gwy_component("/0/data", 'o', gwy_unit("m"))))),
              "no image channel");
  for (const std::string name : {"/x/data", "/data", "0/data", "/-1/data", "/0/data/title"})
    EXPECT_SAYS(refusal(write_bytes("d.gwy", gwy_bytes(gwy_component(name, 'o', gwy_field(metres(), "m"))))),
                "no image channel");
}

TEST(Gwy_file_behaviour, channels_are_ordered_by_number_and_titled_by_it_where_they_have_no_name) {
  const auto path = write_bytes("a.gwy", gwy_bytes(gwy_component("/10/data", 'o', gwy_field(metres(), "m")) +
                                                   gwy_component("/2/data", 'o', gwy_field(metres(), "m"))));
  EXPECT_EQ(read_topography(path).channel, "channel 2");
  ReadOptions options;
  options.channel = "1";
  EXPECT_EQ(read_topography(path, options).channel, "channel 10");
  options.channel = "2";
  EXPECT_SAYS(
      refusal(path, options),
      "has no channel '2'; pass the name or number of one of 0: 'channel 2' in m, 1: 'channel 10' in m");
}

TEST(Gwy_analytic, heights_and_sizes_are_scaled_by_their_units) {
  std::vector<double> heights;
  for (const double nm : heights_nm()) heights.push_back(nm);
  const Topography map =
      read_topography(file_of(field_with(pixels(3, 2) + extent(3, 2, "um"), "nm", heights)));
  expect_common_map(map);
  EXPECT_SAYS(map.source, "heights in nm");
}

TEST(Gwy_file_behaviour, without_size_or_its_unit_asks_for_it) {
  for (const std::string& parts :
       {pixels(3, 2), pixels(3, 2) + extent(0, 2e-6, "m"), pixels(3, 2) + extent(3e-6, 0, "m"),
        pixels(3, 2) + extent(-3e-6, 2e-6, "m"), pixels(3, 2) + extent(3e-6, 2e-6, "V")})
    EXPECT_SAYS(refusal(file_of(field_with(parts))), "pass its size");
}

TEST(Gwy_file_behaviour, whose_data_do_not_fit_its_pixels_is_damaged) {
  for (const auto& [columns, rows] :
       std::vector<std::pair<double, double>>{{3, 3}, {2, 2}, {0, 2}, {3, 0}, {-3, -2}, {1.5, 4}, {4, 1.5}})
    EXPECT_SAYS(refusal(file_of(field_with(pixels(columns, rows) + extent(3e-6, 2e-6, "m")))),
                "data do not fit its pixels")
        << columns;
  EXPECT_SAYS(refusal(file_of(field_with(pixels(6, 1) + extent(3e-6, 2e-6, "m")))),
              "a profile and not a map");
}

TEST(Gwy_file_behaviour, half_masked_points_are_missing_and_masks_of_another_size_are_none) {
  const auto with_mask = [](const std::vector<double>& marks) {
    return read_topography(write_bytes(
        "a.gwy", gwy_bytes(height_channel() + gwy_component("/1/mask", 'o', gwy_field(marks, "")))));
  };
  const Topography map = with_mask({0, 0.5, 0.49, 1, 0, 2});
  EXPECT_EQ(map.missing_count(), 3u);
  EXPECT_TRUE(std::isnan(map.at(1, 1)) && std::isnan(map.at(0, 0)) && std::isnan(map.at(2, 0)));
  EXPECT_SAYS(map.source, "3 points under");
  EXPECT_EQ(with_mask({1, 1}).missing_count(), 0u);
  EXPECT_EQ(with_mask({0, 0, 0, 0, 0, 0}).source.find("mask"), std::string::npos);
}

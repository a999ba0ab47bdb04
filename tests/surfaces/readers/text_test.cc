#include "tests/surfaces/readers/stored_files.h"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::string gwyddion_header = "# Channel: Height\n# Width: 3 µm\n# Height: 2 µm\n# Value units: nm\n";
const std::string rows = "1\t2\t3\n4\t5\t6\n";

Topography read_text(const std::string& content, const ReadOptions& options = {}) {
  return read_topography(write_bytes("a.txt", content), options);
}
std::string text_refusal(const std::string& content, const ReadOptions& options = {}) {
  return refusal(write_bytes("a.txt", content), options);
}

/// The common map as points; the order of lines does not matter.
std::string points(const std::string& header = "# Lateral units: um\n# Value units: nm\n") {
  return header + "0.5 0.5 4\n2.5 1.5 3\n1.5 0.5 5\n2.5 0.5 6\n0.5 1.5 1\n1.5 1.5 2\n";
}

}  // namespace

TEST(Text_matrix_behaviour, of_gwyddion_is_read_with_its_first_line_on_top) {
  const Topography map = read_text(gwyddion_header + rows);
  expect_common_map(map);
  EXPECT_EQ(map.channel, "Height");
  EXPECT_SAYS(map.source, "heights in nm");
  EXPECT_SAYS(map.source, "first row stored is the top");
}

TEST(Text_matrix_behaviour, headers_of_other_writers_are_understood) {
  for (const std::string header :
       {"size: 3 um x 2 um\nunit: nm\n", "# size = 3 x 2 um\n# unit = nm\n",
        "% pixel size: 1 um\n% height unit: nm\n",
        "# Kanal: Topographie\r\n# Breite: 3 \xB5m\r\n# H\xF6he: 2 \xB5m\r\n# Werteinheiten: nm\r\n",
        "width: 3000 nm\nz-unit: nm\n", "xy unit: um\nlx: 3\nly: 2\nvalue unit: nm\n",
        "\xEF\xBB\xBF# Width: 3 ~m\n# Height: 2 ~m\n# Value units: nanometer\n"})
    expect_common_map(read_text(header + rows));
}

TEST(Text_matrix_behaviour, separators_and_decimal_commas_are_understood) {
  for (const std::string body : {"1 2 3\n4 5 6\n", "1,2,3\n4,5,6\n", "1, 2, 3\n4, 5, 6\n", "1;2;3;\n4;5;6;\n",
                                 "1,0\t2,0\t3,0\n4,0\t5,0\t6,0\n", "1,0;2,0;3,0\n4,0;5,0;6,0\n",
                                 "\n1 2 3\r\n\r\n4 5 6", "1e0 +2 3.0\n# remark\n4 5 6\n"})
    expect_common_map(read_text(gwyddion_header + body));
}

TEST(Text_matrix_behaviour, words_for_missing_points_are_a_mask) {
  const Topography map = read_text(gwyddion_header + "nan 2 BAD\n4 --- 6\n");
  EXPECT_EQ(map.missing_count(), 3u);
  EXPECT_TRUE(std::isnan(map.at(0, 1)));
  EXPECT_TRUE(std::isnan(map.at(2, 1)));
  EXPECT_TRUE(std::isnan(map.at(1, 0)));
  EXPECT_NEAR(map.at(2, 0), 6e-9, 1e-18);
}

TEST(Text_matrix_behaviour, without_size_asks_for_it) {
  const std::string content = "# Value units: nm\n1 2 3 4\n4 5 6 7\n";
  EXPECT_SAYS(text_refusal(content),
              "does not say how wide the map is; pass its size, for example --size \"2.5 um\"");
  ReadOptions options;
  options.size_x_m = 4e-6;
  EXPECT_DOUBLE_EQ(read_text(content, options).ly, 2e-6);  // square pixels
}

TEST(Text_matrix_behaviour, without_unit_is_metres_only_if_plausible) {
  ReadOptions options;
  options.size_x_m = 4e-6;
  EXPECT_SAYS(text_refusal("1 2 3 4\n4 5 6 7\n", options), "a first line such as '# Value units: nm'");
  const Topography map = read_text("1e-9 2e-9 3e-9 4e-9\n4e-9 5e-9 6e-9 7e-9\n", options);
  EXPECT_DOUBLE_EQ(map.at(0, 0), 4e-9);
  EXPECT_SAYS(map.source, "no unit of height given, metres taken");
  options.height_unit = "nm";
  EXPECT_NEAR(read_text("1 2 3 4\n4 5 6 7\n", options).at(0, 0), 4e-9, 1e-18);
}

TEST(Text_matrix_behaviour, of_size_without_unit_asks_for_the_size) {
  EXPECT_SAYS(text_refusal("# Width: 3\n# Height: 2\n# Value units: nm\n" + rows), "names no unit of length");
}

TEST(Text_matrix_behaviour, of_other_values_is_refused) {
  EXPECT_SAYS(text_refusal("# Width: 3 um\n# Value units: V\n" + rows), "'V', which is no length");
}

TEST(Text_matrix_behaviour, cut_off_in_a_line_is_refused_with_the_line) {
  EXPECT_SAYS(text_refusal(gwyddion_header + "1 2 3\n4 5"), "line 6 of");
  EXPECT_SAYS(text_refusal(gwyddion_header + "1 2 3\n4 5"),
              "has 2 numbers where the first row has 3: it is cut off");
  EXPECT_SAYS(text_refusal(gwyddion_header + "1 2 3\n4 5 six\n"), "line 6 of");
}

TEST(Text_matrix_behaviour, of_one_row_or_two_columns_is_a_profile) {
  EXPECT_SAYS(text_refusal(gwyddion_header + "1 2 3\n"), "a profile and not a map");
  EXPECT_SAYS(text_refusal("0 1\n1 2\n2 3\n"), "a profile and not a map");
}

TEST(Text_matrix_behaviour, without_any_valid_height_is_refused) {
  EXPECT_SAYS(text_refusal(gwyddion_header + "nan nan nan\nnan nan nan\n"), "holds no valid height");
}

TEST(Xyz_file_behaviour, is_put_on_its_grid_with_y_upwards) {
  expect_common_map(read_topography(write_bytes("a.xyz", points())));
}

TEST(Xyz_file_behaviour, units_of_column_titles_are_understood) {
  expect_common_map(read_topography(write_bytes("a.xyz", points("x [um]  y [um]  z [nm]\n"))));
  expect_common_map(read_topography(write_bytes("b.csv", points("# X (µm), Y (µm), Z (nm)\n"))));
}

TEST(Xyz_file_behaviour, without_units_is_metres_only_if_plausible) {
  EXPECT_SAYS(refusal(write_bytes("a.xyz", points(""))), "names no unit of length");
  const Topography map = read_topography(write_bytes(
      "b.xyz", "0 0 4e-9\n1e-6 0 5e-9\n2e-6 0 6e-9\n0 1e-6 1e-9\n1e-6 1e-6 2e-9\n2e-6 1e-6 3e-9\n"));
  expect_common_map(map);
  EXPECT_SAYS(map.source, "metres taken");
}

TEST(Xyz_file_behaviour, places_without_a_point_are_missing) {
  std::string content = points();
  content.erase(content.find("1.5 0.5 5\n"), 10);
  const Topography map = read_topography(write_bytes("a.xyz", content));
  EXPECT_EQ(map.missing_count(), 1u);
  EXPECT_TRUE(std::isnan(map.at(1, 0)));
  EXPECT_NEAR(map.at(2, 0), 6e-9, 1e-18);
}

TEST(Xyz_file_behaviour, off_a_grid_is_refused) {
  const std::string header = "# unit: um\n";
  EXPECT_SAYS(
      refusal(write_bytes("a.xyz", header + "0 0 0\n1 0 0\n2 0 0\n3.5 0 0\n0 1 0\n1 1 0\n2 1 0\n3.5 1 0\n")),
      "no regular grid");
  EXPECT_SAYS(refusal(write_bytes("b.xyz", points() + "0.5 0.5 9\n")), "two points at one place");
  EXPECT_SAYS(refusal(write_bytes("c.xyz", header + "0 0 0\n1 0 0\n2 0 0\n3 0 0\n")),
              "a profile and not a map");
}

TEST(Any_file_behaviour, empty_is_refused) {
  EXPECT_SAYS(refusal(write_bytes("a.gsf", "")), "is empty");
  EXPECT_SAYS(refusal(write_bytes("b.txt", " \n\n")), "is empty");
}

TEST(Any_file_behaviour, of_another_kind_is_refused_with_what_is_read) {
  EXPECT_SAYS(refusal(write_bytes("a.pdf", "%PDF-1.4\nhello\n")),
              "is of a kind that is not read; pass one of Gwyddion Simple Field");
  EXPECT_SAYS(refusal(write_bytes("b.png", std::string("\x89PNG\r\n\x1a\n\0\0\0\0", 12))),
              "of a kind that is not read");
  EXPECT_SAYS(refusal(write_bytes("c.gsf", "hello")),
              "is named like Gwyddion Simple Field (.gsf) but does not begin with");
  EXPECT_SAYS(refusal(write_bytes("d.md", "# A title\n\nSome words of prose.\n")),
              "of a kind that is not read");
}

TEST(Any_file_behaviour, that_is_not_there_is_refused_by_name) {
  EXPECT_SAYS(refusal("no-such-folder/a.gsf"), "no-such-folder/a.gsf");
}

TEST(Any_file_behaviour, size_that_is_no_length_is_refused) {
  ReadOptions options;
  options.size_x_m = -1.0;
  EXPECT_SAYS(text_refusal(gwyddion_header + rows, options), "a length above 0");
}

TEST(Description_behaviour, says_pixels_size_orientation_channel_scale_and_missing_points) {
  const std::string line = describe(read_text(gwyddion_header + rows));
  for (const std::string part :
       {"3 x 2 pixels", "3 um x 2 um", "x right, y up", "heights from 1 nm to 6 nm", "channel 'Height'",
        "no missing points", "text matrix", "heights in nm", "first row stored is the top"})
    EXPECT_SAYS(line, part);
}

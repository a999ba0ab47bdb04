#include "surfaces/readers/text_parts.h"
#include "tests/support/utf16.h"
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

TEST(Trimmed_text_behaviour, takes_no_break_spaces_for_blanks_and_those_at_the_ends_away) {
  EXPECT_EQ(trimmed_text("2.5\u00a0um"), "2.5 um");
  EXPECT_EQ(trimmed_text("\u00a0 \t2.5\u00a0\u00a0um\u00a0"), "2.5  um");
  EXPECT_EQ(trimmed_text("\u00a0"), "");
}

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

TEST(Text_matrix_behaviour, of_16_bit_characters_is_read_and_said) {
  const std::u16string text =
      u"# Width: 3 µm\r\n# Height: 2 µm\r\n# Value units: nm\r\n1\t2\t3\r\n4\t5\t6\r\n";
  for (const Order order : {Order::little, Order::big}) {
    const Topography map = read_text(utf16_bytes(text, order));
    expect_common_map(map);
    EXPECT_SAYS(map.source, "text in UTF-16");
  }
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
              "is of a kind that is not read; pass one of Alicona (.al3d), Gwyddion Simple Field (.gsf)");
  EXPECT_SAYS(refusal(write_bytes("b.png", std::string("\x89PNG\r\n\x1a\n\0\0\0\0", 12))),
              "is a picture (.png), which is not read");
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

TEST(Any_file_behaviour, size_passed_is_compared_with_the_files) {
  const auto source = [](std::optional<double> x, std::optional<double> y) {
    ReadOptions options;
    options.size_x_m = x, options.size_y_m = y;
    return read_text(gwyddion_header + rows, options).source;
  };
  const std::string instead = "size as passed instead of the file's 3 um x 2 um";
  EXPECT_SAYS(source(6e-6, 2e-6), instead);
  EXPECT_SAYS(source(1e-6, 2e-6), instead);
  EXPECT_SAYS(source(3e-6, 5e-6), instead);
  EXPECT_SAYS(source(3e-6, 1e-6), instead);
  EXPECT_SAYS(source(4e-6, std::nullopt), instead);
  for (const std::string& same :
       {source(3e-6, std::nullopt), source(std::nullopt, 2e-6), source(3e-6, 2e-6)}) {
    EXPECT_SAYS(same, "size as passed");
    EXPECT_EQ(same.find("instead"), std::string::npos) << same;
  }
}

TEST(Any_file_analytic, one_side_passed_gives_the_other_by_square_pixels) {
  ReadOptions options;
  options.size_y_m = 4e-6;
  EXPECT_DOUBLE_EQ(read_text(gwyddion_header + rows, options).lx, 6e-6);
  EXPECT_DOUBLE_EQ(read_text(gwyddion_header + rows, options).ly, 4e-6);
  options = {};
  options.size_x_m = 9e-6;
  EXPECT_DOUBLE_EQ(read_text(gwyddion_header + rows, options).ly, 6e-6);
}

TEST(Any_file_behaviour, a_size_of_no_length_is_refused_whoever_gives_it) {
  for (const double wrong : {0.0, -1e-6, std::nan(""), double{INFINITY}}) {
    ReadOptions x, y;
    x.size_x_m = wrong, y.size_y_m = wrong;
    EXPECT_SAYS(text_refusal(gwyddion_header + rows, x), "the size of a topography is a length above 0");
    EXPECT_SAYS(text_refusal(gwyddion_header + rows, y), "the size of a topography is a length above 0");
  }
  for (const std::string wrong : {"0 um", "-3 um", "inf um", "nan um"}) {
    EXPECT_SAYS(text_refusal("# Width: " + wrong + "\n# Height: 2 um\n# Value units: nm\n" + rows),
                "gives a size that is no length above 0");
    EXPECT_SAYS(text_refusal("# Width: 3 um\n# Height: " + wrong + "\n# Value units: nm\n" + rows),
                "gives a size that is no length above 0");
  }
}

TEST(Any_file_behaviour, metres_are_taken_for_a_scan_of_a_tenth_of_one_and_heights_up_to_the_narrower_side) {
  const auto sized = [](const std::string& width, const std::string& heights) {
    return "# Width: " + width + "\n# Height: 0.05\n" + heights;
  };
  const Topography map = read_text(sized("0.1", "0.05 0 0\n0 0 0\n"));
  EXPECT_DOUBLE_EQ(map.lx, 0.1);
  EXPECT_SAYS(map.source, "no unit of height given, metres taken; no unit of size given, metres taken");
  EXPECT_SAYS(text_refusal(sized("0.11", "0.05 0 0\n0 0 0\n")), "in metres the map would be 110 mm wide");
  EXPECT_SAYS(text_refusal(sized("0.1", "0.03 -0.03 0\n0 0 0\n")), "higher than wide (60 mm)");
  EXPECT_SAYS(text_refusal(sized("0.04", "0.045 0 0\n0 0 0\n")), "higher than wide (45 mm)");
}

TEST(Any_file_behaviour, heights_that_are_not_finite_are_missing) {
  const Topography map = read_text(gwyddion_header + "inf 2 3\n-inf 5 nan\n");
  EXPECT_EQ(map.missing_count(), 3u);
  for (const auto& [ix, iy] : std::vector<std::pair<int, int>>{{0, 1}, {0, 0}, {2, 0}})
    EXPECT_TRUE(std::isnan(map.at(ix, iy)));
  EXPECT_SAYS(describe(map), "heights from 2 nm to 5 nm");
  EXPECT_SAYS(describe(map), "3 missing points");
}

TEST(Description_behaviour, leaves_out_what_a_map_has_not) {
  Topography map;
  map.nx = 2, map.ny = 2, map.lx = 2e-6, map.ly = 1e-6;
  map.heights = {1e-9, -2e-9, 0, 3e-9};
  EXPECT_EQ(describe(map),
            "2 x 2 pixels, 2 um x 1 um (x right, y up), heights from -2 nm to 3 nm, no missing points");
  map.periodic = true;
  map.source = "somewhere";
  EXPECT_EQ(describe(map),
            "2 x 2 pixels, 2 um x 1 um (x right, y up), heights from -2 nm to 3 nm, no missing points, "
            "periodic; from somewhere");
}

TEST(Text_matrix_analytic, scales_of_its_header_are_lengths) {
  const auto size = [](const std::string& header) {
    const Topography map = read_text(header + "# Value units: nm\n1 2 3 4\n5 6 7 8\n");
    return std::make_pair(map.lx, map.ly);
  };
  const auto expect = [&](const std::string& header, double x, double y) {
    EXPECT_NEAR(size(header).first / x, 1, 1e-12) << header;
    EXPECT_NEAR(size(header).second / y, 1, 1e-12) << header;
  };
  expect("# Width: 3 um\n# Height: 2 um\n", 3e-6, 2e-6);
  expect("# Width: 3 um\n", 3e-6, 1.5e-6);  // square pixels
  expect("# Height: 3 um\n", 6e-6, 3e-6);
  expect("# size: 3 um x 200 nm\n", 3e-6, 200e-9);
  expect("# size: 3 x 2 um\n", 3e-6, 2e-6);
  expect("# size: 3 um\n", 3e-6, 1.5e-6);
  expect("# pixel size: 5 nm\n", 20e-9, 10e-9);
  expect("# dx: 5\n# xy unit: nm\n", 20e-9, 10e-9);
  expect("# lx: 3\n# ly: 200 nm\n# lateral units: um\n", 3e-6, 200e-9);  // a unit of its own wins
  expect("# Width: 3 um\n# pixel size: 5 nm\n", 3e-6, 1.5e-6);           // and a size over a pixel
  EXPECT_SAYS(text_refusal("# Width: 3 V\n# Value units: nm\n" + rows), "does not say how wide");
  EXPECT_SAYS(text_refusal("# Width: wide\n# Value units: nm\n" + rows), "does not say how wide");
}

TEST(Text_matrix_analytic, heights_are_in_any_unit_of_length) {
  for (const auto& [unit, factor] : std::vector<std::pair<std::string, double>>{
           {"m", 1},          {"mm", 1e-3},         {"um", 1e-6},          {"~m", 1e-6},
           {"\xB5m", 1e-6},   {"\u00b5m", 1e-6},    {"\u03bcm", 1e-6},     {"micron", 1e-6},
           {"microns", 1e-6}, {"micrometer", 1e-6}, {"micrometers", 1e-6}, {"micrometre", 1e-6},
           {"nm", 1e-9},      {"nanometer", 1e-9},  {"nanometers", 1e-9},  {"nanometre", 1e-9},
           {"A", 1e-10},      {"Ang", 1e-10},       {"Angstrom", 1e-10},   {"angstrom", 1e-10},
           {"\u00c5", 1e-10}, {"\xC5", 1e-10},      {"pm", 1e-12},         {"meter", 1},
           {"meters", 1},     {"metre", 1},         {"millimeter", 1e-3},  {"millimetre", 1e-3}})
    EXPECT_NEAR(read_text("# Width: 3 um\n# Value units: " + unit + "\n" + rows).at(0, 0) / (4 * factor), 1,
                1e-12)
        << unit;
}

TEST(Text_matrix_behaviour, a_unit_of_the_file_wins_over_one_that_is_passed) {
  ReadOptions options;
  options.height_unit = "um";
  const Topography map = read_text(gwyddion_header + rows, options);
  EXPECT_NEAR(map.at(0, 0), 4e-9, 1e-18);
  EXPECT_EQ(map.source.find("as passed"), std::string::npos) << map.source;
  const Topography bare = read_text("# Width: 30 um\n" + rows, options);
  EXPECT_NEAR(bare.at(0, 0), 4e-6, 1e-15);
  EXPECT_SAYS(bare.source, "heights in um");
  EXPECT_SAYS(bare.source, "unit of height as passed");
}

TEST(Text_matrix_behaviour, each_word_for_a_missing_point_is_understood_and_no_other) {
  for (const std::string word :
       {"nan", "NaN", "na", "n/a", "bad", "missing", "void", "null", "-", "--", "---", "***"})
    EXPECT_EQ(read_text(gwyddion_header + "1 " + word + " 3\n4 5 6\n").missing_count(), 1u) << word;
  EXPECT_SAYS(text_refusal(gwyddion_header + "1 2 3\n4 none 6\n"), "line 6 of");
  EXPECT_SAYS(text_refusal(gwyddion_header + "1 2 3\n4 5 6 and here are many more words\n"),
              "('4 5 6 and here are m...')");
}

TEST(Text_matrix_behaviour, decimal_commas_are_told_from_commas_between_numbers) {
  EXPECT_NEAR(read_text(gwyddion_header + "1,5 2,5 3,5\n4,5 5,5 6,5\n").at(0, 0), 4.5e-9, 1e-18);
  EXPECT_NEAR(read_text(gwyddion_header + "-1,5;2,5;3\n-4,5;5;6\n").at(0, 0), -4.5e-9, 1e-18);
  EXPECT_NEAR(read_text(gwyddion_header + "1.5,2.5,3.5\n4.5,5.5,6.5\n").at(0, 0), 4.5e-9, 1e-18);
}

namespace {

/// Points of a grid, listed by the given order of columns and rows; the height at (ix, iy) is 1 + ix + 10 iy
/// nm.
std::string grid_points(const std::vector<double>& x, const std::vector<double>& y) {
  std::string text = "# unit: nm\n";
  for (std::size_t iy = 0; iy < y.size(); ++iy)
    for (std::size_t ix = 0; ix < x.size(); ++ix)
      text +=
          std::to_string(x[ix]) + " " + std::to_string(y[iy]) + " " + std::to_string(1 + ix + 10 * iy) + "\n";
  return text;
}

}  // namespace

TEST(Xyz_file_analytic, axes_may_begin_anywhere_and_fall) {
  const std::vector<double> x{-250, -200, -150, -100}, y{700, 730, 760};
  const Topography map = read_topography(write_bytes("a.xyz", grid_points(x, y)));
  ASSERT_EQ(map.nx, 4);
  ASSERT_EQ(map.ny, 3);
  EXPECT_NEAR(map.lx, 200e-9, 1e-18);  // each point has a pixel of its own around it
  EXPECT_NEAR(map.ly, 90e-9, 1e-18);
  for (int iy = 0; iy < 3; ++iy)
    for (int ix = 0; ix < 4; ++ix) EXPECT_NEAR(map.at(ix, iy), (1 + ix + 10 * iy) * 1e-9, 1e-18);
  const std::vector<double> falling_x(x.rbegin(), x.rend()), falling_y(y.rbegin(), y.rend());
  const Topography fallen = read_topography(write_bytes("b.xyz", grid_points(falling_x, falling_y)));
  for (int iy = 0; iy < 3; ++iy)
    for (int ix = 0; ix < 4; ++ix) EXPECT_EQ(fallen.at(ix, iy), map.at(3 - ix, 2 - iy));
}

TEST(Xyz_file_behaviour, coordinates_may_be_rounded_by_a_quarter_of_the_spacing_to_either_side) {
  for (const double off : {-0.2, 0.2}) {
    const Topography map =
        read_topography(write_bytes("a.xyz", grid_points({0, 1, 2 + off, 3, 4}, {0, 1, 2})));
    ASSERT_EQ(map.nx, 5);
    EXPECT_NEAR(map.at(2, 0), 3e-9, 1e-18);
  }
  for (const double off : {-0.3, 0.3}) {
    EXPECT_SAYS(refusal(write_bytes("a.xyz", grid_points({0, 1, 2 + off, 3, 4}, {0, 1, 2}))),
                "no regular grid");
    EXPECT_SAYS(refusal(write_bytes("a.xyz", grid_points({0, 1, 2}, {0, 1, 2 + off, 3, 4}))),
                "no regular grid");
  }
}

TEST(Xyz_file_behaviour, points_that_fill_less_than_a_quarter_of_their_grid_are_scattered) {
  std::string diagonal = "# unit: nm\n", filled = diagonal;
  for (int i = 0; i < 5; ++i) diagonal += std::to_string(i) + " " + std::to_string(i) + " 1\n";
  for (int i = 0; i < 4; ++i) filled += std::to_string(i) + " " + std::to_string(i) + " 1\n";
  EXPECT_SAYS(refusal(write_bytes("a.xyz", diagonal)), "no regular grid");        // 5 of 25
  EXPECT_EQ(read_topography(write_bytes("b.xyz", filled)).missing_count(), 12u);  // 4 of 16
}

TEST(Xyz_file_behaviour, what_is_wrong_with_a_point_is_said_with_its_row) {
  EXPECT_SAYS(refusal(write_bytes("a.xyz", "# unit: um\n0 0 1\n1 nan 2\n0 1 3\n1 1 4\n")),
              "has a point without x or y (row 2 of numbers)");
  EXPECT_SAYS(refusal(write_bytes("a.xyz", "# unit: um\n0 0 1\n1 0 2\n0 1 3\ninf 1 4\n")),
              "has a point without x or y (row 4 of numbers)");
  EXPECT_SAYS(refusal(write_bytes("a.xyz", points() + "0.5 0.5 9\n")),
              "two points at one place of its grid (row 7 of numbers)");
  EXPECT_SAYS(refusal(write_bytes("a.xyz", points("# Lateral units: V\n# Value units: nm\n"))),
              "coordinates in 'V', which is no length");
  EXPECT_SAYS(refusal(write_bytes("a.xyz", points("x [um] y [um] z [V]\n"))),
              "values in 'V', which is no length");
  EXPECT_SAYS(refusal(write_bytes("a.xyz", "# unit: um\n0 0 1\n0 1 2\n0 2 3\n")),
              "all its points on one line");
}

TEST(Xyz_file_behaviour, a_header_wins_over_the_titles_of_columns) {
  expect_common_map(
      read_topography(write_bytes("a.xyz", points("# Lateral units: um\nx [mm] y [mm] z [nm]\n"))));
  const Topography map =
      read_topography(write_bytes("b.xyz", points("x [um] y [um]\n# Value units: nm\n# xy unit: um\n")));
  expect_common_map(map);  // two titles tell nothing
}

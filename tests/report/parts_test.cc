// Before GoogleTest: <signal.h>, which it includes, has a macro si_value.
#include "report/fields/map_figure.h"
#include "report/fields/png.h"
#include "report/page/axis.h"
#include "report/page/chart.h"
#include "report/page/words.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace asperity::report {
namespace {

TEST(Png_behaviour, has_the_signature_and_size_of_its_image) {
  const std::string bytes = png_bytes(Image(7, 3));
  EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(bytes[19], 7);
  EXPECT_EQ(bytes[23], 3);
}

TEST(Axis_behaviour, covers_its_data_with_round_ticks) {
  const Axis axis = make_axis(0.13, 9.4, 0, 100, true, 5);
  EXPECT_LE(axis.low, 0.13);
  EXPECT_GE(axis.high, 9.4);
  ASSERT_GE(axis.ticks.size(), 4u);
  EXPECT_EQ(axis.ticks[1] - axis.ticks[0], 2);
  EXPECT_EQ(tick_label(axis.ticks[0], axis), "0");
  EXPECT_NEAR(axis.pixel(axis.high), 100, 1e-9);
}

TEST(Axis_behaviour, tick_labels_have_as_many_decimals_as_tell_them_apart) {
  const Axis axis = make_axis(0.9, 1.1, 0, 1, true, 4);
  EXPECT_EQ(tick_label(0.95, axis), "0.95");
  EXPECT_EQ(tick_label(1, axis), "1.00");
}

TEST(Axis_behaviour, a_single_value_still_has_a_range) {
  const Axis axis = make_axis(3, 3, 0, 1, true);
  EXPECT_LT(axis.low, 3);
  EXPECT_GT(axis.high, 3);
}

TEST(Chart_behaviour, breaks_its_lines_where_a_value_is_not_known_and_names_its_axes) {
  Chart chart;
  chart.x_label = "load [N]";
  chart.y_label = "approach <nm>";
  chart.series = {{"a & b", "#000000", Series::Style::line, {1, 2, 3, 4}, {1, NAN, 2, 3}, {}}};
  const std::string svg = to_svg(chart);
  EXPECT_NE(svg.find("a &amp; b"), std::string::npos);
  EXPECT_NE(svg.find("approach &lt;nm&gt;"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  const std::string path = svg.substr(svg.find("<path d='") + 9);
  const std::string drawn = path.substr(0, path.find('\''));
  EXPECT_EQ(std::count(drawn.begin(), drawn.end(), 'M'), 2);
}

TEST(Chart_behaviour, without_values_says_so) {
  EXPECT_NE(to_svg(Chart{}).find("nothing to draw"), std::string::npos);
}

TEST(Map_behaviour, colours_leave_out_outliers_and_unknown_points_are_grey) {
  Map map{10, 10, 0, 1, 0, 1, std::vector<double>(100, 0.0)};
  for (int i = 0; i < 100; ++i) map.values[i] = i;
  map.values[99] = 1e6;
  map.values[0] = NAN;
  const ColourRange range = colour_range(map, 0.02);
  EXPECT_LT(range.high, 100);
  const Image image = paint(map, ColourScale::viridis(), range);
  EXPECT_EQ(image.pixel(0, 9)[0], 225);  // the first value lies at the lower left
  EXPECT_EQ(map.largest(), 1e6);
}

TEST(ColourScale_behaviour, runs_from_its_first_to_its_last_colour) {
  EXPECT_EQ(hex(ColourScale::white_to_red().at(0)), "#ffffff");
  EXPECT_EQ(hex(ColourScale::viridis().at(2)), "#fde725");
}

TEST(Words_behaviour, numbers_read_as_people_write_them) {
  EXPECT_EQ(departure_text(0.888), "−11\u00a0%");
  EXPECT_EQ(departure_text(1.0001), "0.0\u00a0%");
  EXPECT_EQ(departure_text(1.023), "+2.3\u00a0%");
  EXPECT_EQ(departure_text(4.57), "4.6 times");
  EXPECT_EQ(in_units(7e-10, Dimension::length), "0.7 nm");
  EXPECT_EQ(imprint_text(-6e-15), "0.00 nm");
  EXPECT_EQ(percent_bound(1e-9), "0.001 %");
  EXPECT_EQ(duration_text(83.2), "1 min 23 s");
  EXPECT_EQ(duration_text(7260), "2 h 1 min");
  EXPECT_EQ(readable("from 125 uN, 2.5 um wide; umbrella 3 units"),
            "from 125 µN, 2.5 µm wide; umbrella 3 units");
  EXPECT_EQ(area_text(4.84e-13), "0.484 µm²");
}

TEST(Words_behaviour, a_material_is_told_with_the_entries_of_a_law_from_outside) {
  SolvedCase solved;
  std::map<std::string, std::string> entries{{"Particle/Radius", "8.5 um"}};
  for (const char* body : {"Particle/", "Substrate/"}) {
    entries[body + std::string("Young modulus")] = "71 GPa";
    entries[body + std::string("Poisson ratio")] = "0.17";
    entries[body + std::string("Swift strain")] = "0";
  }
  entries["Particle/Yield stress"] = "0.4 GPa";
  entries["Particle/Swift strain"] = "0.01", entries["Particle/Swift exponent"] = "0.3";
  solved.entries = CaseEntries(entries);
  const std::string asked = what_was_asked(solved);
  EXPECT_NE(asked.find("yields at 400 MPa, Swift exponent = 0.3, Swift strain = 0.01;"), std::string::npos)
      << asked;
  EXPECT_NE(asked.find("elastic; surface"), std::string::npos) << asked;
}

TEST(Words_behaviour, a_film_is_told_with_its_body) {
  SolvedCase solved;
  std::map<std::string, std::string> entries{{"Particle/Radius", "8.5 um"},
                                             {"Substrate/Film thickness", "5 nm"},
                                             {"Substrate/Film Young modulus", "70 GPa"},
                                             {"Substrate/Film Poisson ratio", "0.2"}};
  for (const char* body : {"Particle/", "Substrate/"}) {
    entries[body + std::string("Young modulus")] = "71 GPa";
    entries[body + std::string("Poisson ratio")] = "0.17";
  }
  solved.entries = CaseEntries(entries);
  const std::string elastic = what_was_asked(solved);
  EXPECT_NE(elastic.find("elastic; a film of 5 nm, E = 70 GPa, ν = 0.2, elastic"), std::string::npos)
      << elastic;
  EXPECT_EQ(elastic.find("film"), elastic.rfind("film")) << elastic;
  entries["Substrate/Yield stress"] = "1 GPa", entries["Substrate/Film yield stress"] = "2 GPa";
  solved.entries = CaseEntries(entries);
  const std::string yields = what_was_asked(solved);
  EXPECT_NE(yields.find("yields at 1 GPa; a film of 5 nm, E = 70 GPa, ν = 0.2, yields at 2 GPa"),
            std::string::npos)
      << yields;
}

TEST(Words_behaviour, a_topography_is_told_by_what_made_it) {
  EXPECT_EQ(topography_in_words("smooth"), "smooth");
  EXPECT_EQ(topography_in_words("/data/scan<1>.gsf"), "measured: scan&lt;1&gt;.gsf");
  EXPECT_EQ(topography_in_words("generated(rms=1.5 nm, hurst=0.8, rolloff=200 nm, cutoff=20 nm, seed=3)"),
            "generated roughness, RMS 1.5 nm (Hurst exponent 0.8, roll-off 200 nm, cut-off 20 nm)");
}

}  // namespace
}  // namespace asperity::report

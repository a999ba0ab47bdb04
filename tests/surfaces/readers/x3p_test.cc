#include "tests/surfaces/readers/stored_files.h"

using namespace asperity;
using namespace asperity::test;

namespace {

/// Stored numbers, top row first.
template <class T>
std::string stored(double unit) {
  std::string data;
  for (const int nm : {1, 2, 3, 4, 5, 6}) data += raw<T>(static_cast<T>(nm * unit));
  return data;
}

}  // namespace

TEST(X3p_file_behaviour, of_floats_is_read_in_metres_with_its_first_row_on_top) {
  const Topography map = read_topography(
      write_zip("a.x3p", {{"main.xml", x3p_main("D", "", "")}, {"bindata/data.bin", stored<double>(1e-9)}}));
  expect_common_map(map);
  expect_common_map(read_topography(
      write_zip("b.x3p", {{"main.xml", x3p_main("F", "", "")}, {"bindata/data.bin", stored<float>(1e-9)}})));
}

TEST(X3p_file_behaviour, of_integers_is_scaled_by_increment_and_offset) {
  const std::string scale = "<Increment>1e-10</Increment><Offset>-1e-9</Offset>";
  const auto integers = [&](auto zero) {
    std::string data;
    for (const int nm : {1, 2, 3, 4, 5, 6}) data += raw(static_cast<decltype(zero)>(10 * (nm + 1)));
    return data;
  };
  expect_common_map(read_topography(write_zip(
      "a.x3p", {{"main.xml", x3p_main("I", scale, "")}, {"bindata/data.bin", integers(std::int16_t{})}})));
  expect_common_map(read_topography(write_zip(
      "b.x3p", {{"main.xml", x3p_main("L", scale, "")}, {"bindata/data.bin", integers(std::int32_t{})}})));
}

TEST(X3p_file_behaviour, invalid_points_are_missing) {
  const std::string link = "<ValidPointsLink>bindata/valid.bin</ValidPointsLink>";
  const Topography map =
      read_topography(write_zip("a.x3p", {{"main.xml", x3p_main("D", "", link)},
                                          {"bindata/data.bin", stored<double>(1e-9)},
                                          {"bindata/valid.bin", std::string(1, '\x37')}}));  // not bit 3
  EXPECT_EQ(map.missing_count(), 1u);
  EXPECT_TRUE(std::isnan(map.at(0, 0)));
}

TEST(X3p_file_behaviour, without_spacing_asks_for_the_size) {
  const auto path = write_zip(
      "a.x3p", {{"main.xml", x3p_main("D", "", "", "")}, {"bindata/data.bin", stored<double>(1e-9)}});
  EXPECT_SAYS(refusal(path), "pass its size");
  ReadOptions options;
  options.size_x_m = 3e-6;
  expect_common_map(read_topography(path, options));
}

TEST(X3p_file_behaviour, with_too_few_data_is_refused) {
  const auto path = write_zip("a.x3p", {{"main.xml", x3p_main("D", "", "")},
                                        {"bindata/data.bin", stored<double>(1e-9).substr(0, 40)}});
  EXPECT_SAYS(refusal(path), "has 40 of the 48 bytes of heights");
}

TEST(X3p_file_behaviour, with_missing_parts_is_refused) {
  EXPECT_SAYS(refusal(write_zip("a.x3p", {{"main.xml", x3p_main("D", "", "")}})), "lacks 'bindata/data.bin'");
  EXPECT_SAYS(refusal(write_zip("b.x3p", {{"main.xml", "<a><b>"}})), "main.xml that cannot be read");
  EXPECT_SAYS(refusal(write_zip("c.zip", {{"scan.001", "x"}, {"meta.yml", "y"}})),
              "lacks main.xml; unpack it and pass one of its height maps (it holds 'scan.001', 'meta.yml')");
}

TEST(X3p_file_behaviour, with_a_number_of_points_that_is_none_is_refused) {
  for (const char* points : {"0", "-4", "2.5", "2000000", "x"}) {
    std::string main = x3p_main("D", "", "");
    const auto begin = main.find("<SizeX>") + 7;
    main.replace(begin, main.find("</SizeX>") - begin, points);
    EXPECT_SAYS(refusal(write_zip("a.x3p", {{"main.xml", main}, {"bindata/data.bin", stored<double>(1e-9)}})),
                "gives no valid number of points 'SizeX'");
  }
}

TEST(X3p_file_behaviour, of_a_profile_is_refused) {
  std::string main = x3p_main("D", "", "");
  main.replace(main.find(">SUR<"), 5, ">PRF<");
  EXPECT_SAYS(refusal(write_zip("a.x3p", {{"main.xml", main}, {"bindata/data.bin", stored<double>(1e-9)}})),
              "of type 'PRF' and not a surface");
}

TEST(X3p_file_behaviour, cut_off_is_refused) {
  const std::string bytes = bytes_of(
      write_zip("a.x3p", {{"main.xml", x3p_main("D", "", "")}, {"bindata/data.bin", stored<double>(1e-9)}}));
  EXPECT_SAYS(refusal(write_bytes("b.x3p", bytes.substr(0, bytes.size() / 2))), "cut off");
}

#include <netcdf.h>

#include "tests/surfaces/readers/stored_files.h"

using namespace asperity;
using namespace asperity::test;

namespace {

/// What differs from file to file; attributes are left out where their text is empty.
struct NetcdfContent {
  int format = NC_64BIT_OFFSET;
  std::string unit_name = "unit", unit = "um", heights_unit = "um";
  bool sizes = true, x_first = true;
  int periodic = 0;
  std::vector<double> heights{1e-3, 2e-3, 3e-3, 4e-3, 5e-3, 6e-3};  ///< top row first, in um
  std::string heights_name = "heights";
};

/// Through libnetcdf's own writer, laid out as SurfaceTopography's write_nc does.
std::filesystem::path write_netcdf(const std::string& name, const NetcdfContent& content) {
  const auto path = write_bytes(name, "");
  int file = 0, dims[2], x = 0, y = 0, heights = 0;
  EXPECT_EQ(nc_create(path.c_str(), NC_CLOBBER | content.format, &file), NC_NOERR);
  nc_def_dim(file, "x", 3, &dims[0]);
  nc_def_dim(file, "y", 2, &dims[1]);
  const int stored_dims[] = {dims[content.x_first ? 0 : 1], dims[content.x_first ? 1 : 0]};
  nc_def_var(file, content.heights_name.c_str(), NC_DOUBLE, 2, stored_dims, &heights);
  nc_def_var(file, "x", NC_DOUBLE, 1, &dims[0], &x);
  nc_def_var(file, "y", NC_DOUBLE, 1, &dims[1], &y);
  const double lengths[] = {3.0, 2.0};
  for (const int axis : {x, y}) {
    if (content.sizes) nc_put_att_double(file, axis, "length", NC_DOUBLE, 1, &lengths[axis == y]);
    nc_put_att_int(file, axis, "periodic", NC_INT, 1, &content.periodic);
    if (!content.unit.empty())
      nc_put_att_text(file, axis, content.unit_name.c_str(), content.unit.size(), content.unit.data());
  }
  if (!content.heights_unit.empty())
    nc_put_att_text(file, heights, content.unit_name.c_str(), content.heights_unit.size(),
                    content.heights_unit.data());
  nc_enddef(file);
  std::vector<double> stored(6);
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 3; ++column)
      stored[content.x_first ? column * 2 + row : row * 3 + column] = content.heights[row * 3 + column];
  EXPECT_EQ(nc_put_var_double(file, heights, stored.data()), NC_NOERR);
  EXPECT_EQ(nc_close(file), NC_NOERR);
  return path;
}

}  // namespace

TEST(Netcdf_file_behaviour, of_each_kind_is_read) {
  NetcdfContent content;
  for (const int format : {0, NC_64BIT_OFFSET, NC_64BIT_DATA, NC_NETCDF4}) {
    content.format = format;
    const Topography map = read_topography(write_netcdf("a.nc", content));
    expect_common_map(map);
    EXPECT_FALSE(map.periodic);
  }
}

TEST(Netcdf_file_behaviour, of_older_writers_with_length_unit_is_read) {
  NetcdfContent content;
  content.unit_name = "length_unit";
  content.heights_unit = "";
  expect_common_map(read_topography(write_netcdf("a.nc", content)));
}

TEST(Netcdf_file_behaviour, with_y_first_is_the_same_map) {
  NetcdfContent content;
  content.x_first = false;
  expect_common_map(read_topography(write_netcdf("a.nc", content)));
}

TEST(Netcdf_file_behaviour, periodicity_is_kept) {
  NetcdfContent content;
  content.periodic = 1;
  EXPECT_TRUE(read_topography(write_netcdf("a.nc", content)).periodic);
}

TEST(Netcdf_file_behaviour, nan_and_fill_values_are_missing) {
  NetcdfContent content;
  content.heights[0] = std::nan("");
  content.heights[4] = NC_FILL_DOUBLE;
  const Topography map = read_topography(write_netcdf("a.nc", content));
  EXPECT_EQ(map.missing_count(), 2u);
  EXPECT_TRUE(std::isnan(map.at(0, 1)));
  EXPECT_TRUE(std::isnan(map.at(1, 0)));
}

TEST(Netcdf_file_behaviour, without_size_asks_for_it) {
  NetcdfContent content;
  content.sizes = false;
  const auto path = write_netcdf("a.nc", content);
  EXPECT_SAYS(refusal(path), "pass its size");
  ReadOptions options;
  options.size_x_m = 3e-6;
  expect_common_map(read_topography(path, options));
}

TEST(Netcdf_file_behaviour, of_other_contents_is_refused) {
  NetcdfContent content;
  content.heights_name = "temperature";
  EXPECT_SAYS(refusal(write_netcdf("a.nc", content)), "without a variable 'heights'");
  content = {};
  content.heights_unit = "K";
  EXPECT_SAYS(refusal(write_netcdf("b.nc", content)), "'K', which is no length");
}

// Without a check of its length a cut-off classic file would be read with zeros for what is lost.
TEST(Netcdf_file_behaviour, cut_off_anywhere_is_refused) {
  NetcdfContent content;
  for (const int format : {0, NC_64BIT_OFFSET, NC_64BIT_DATA}) {
    content.format = format;
    const std::string bytes = bytes_of(write_netcdf("a.nc", content));
    for (std::size_t length = 4; length < bytes.size(); ++length)
      EXPECT_SAYS(refusal(write_bytes("b.nc", bytes.substr(0, length))), "cut off");
  }
}

TEST(Netcdf_file_behaviour, of_hdf5_cut_off_is_refused) {
  NetcdfContent content;
  content.format = NC_NETCDF4;
  const std::string bytes = bytes_of(write_netcdf("a.nc", content));
  for (const std::size_t length : {std::size_t{40}, bytes.size() / 2, bytes.size() - 1})
    EXPECT_SAYS(refusal(write_bytes("b.nc", bytes.substr(0, length))), "cut off");
}

TEST(Netcdf_file_behaviour, is_periodic_where_both_axes_are) {
  NetcdfContent content;
  content.periodic = 0;
  EXPECT_FALSE(read_topography(write_netcdf("a.nc", content)).periodic);
}

TEST(Netcdf_file_analytic, heights_and_axes_are_scaled_by_units_of_their_own) {
  NetcdfContent content;
  content.heights_unit = "nm";
  content.heights = {1, 2, 3, 4, 5, 6};
  const Topography map = read_topography(write_netcdf("a.nc", content));
  expect_common_map(map);
  EXPECT_SAYS(map.source, "heights in nm");
  EXPECT_EQ(map.channel, "heights");
}

TEST(Netcdf_file_behaviour, has_one_channel) {
  const auto path = write_netcdf("a.nc", {});
  ReadOptions options;
  for (const std::string wish : {"heights", "Heights", "0"}) {
    options.channel = wish;
    expect_common_map(read_topography(path, options));
  }
  options.channel = "phase";
  EXPECT_SAYS(refusal(path, options), "has no channel 'phase'; its only one is 'heights'");
}

TEST(Netcdf_file_behaviour, without_any_unit_is_metres_if_that_is_plausible) {
  NetcdfContent content;
  content.unit = content.heights_unit = "";
  ReadOptions options;
  options.size_x_m = 3e-6;
  EXPECT_SAYS(refusal(write_netcdf("a.nc", content), options), "higher than wide");
  for (double& height : content.heights) height *= 1e-6;
  const Topography map = read_topography(write_netcdf("a.nc", content), options);
  expect_common_map(map);
  EXPECT_SAYS(map.source, "no unit of height given, metres taken");
}

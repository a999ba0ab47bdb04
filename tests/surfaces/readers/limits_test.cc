// Small files that announce much: what docs/surfaces.md states about memory, measured in a process of its
// own.
#include <netcdf.h>

#include "core/read_limits.h"
#include "surfaces/readers/netcdf_classic.h"
#include "tests/support/peak_memory.h"
#include "tests/surfaces/readers/stored_files.h"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr std::uint64_t MiB = 1u << 20;
/// Of a file that is not packed: docs/surfaces.md.
constexpr std::uint64_t stated_multiple = 64;

ChildOutcome reading(const std::filesystem::path& path) {
  return measured_in_child([&] { read_topography(path); });
}

std::string replaced(std::string bytes, const std::string& from, const std::string& to) {
  for (auto at = bytes.find(from); at != std::string::npos; at = bytes.find(from, at + to.size()))
    bytes.replace(at, from.size(), to);
  return bytes;
}

std::string big_endian(std::uint32_t value) {
  return {static_cast<char>(value >> 24), static_cast<char>(value >> 16), static_cast<char>(value >> 8),
          static_cast<char>(value)};
}

std::string x3p_main_of(int columns, int rows, const std::string& type) {
  const std::string sized =
      replaced(x3p_main(type, "", ""), "<SizeX>3<", "<SizeX>" + std::to_string(columns) + "<");
  return replaced(sized, "<SizeY>2<", "<SizeY>" + std::to_string(rows) + "<");
}

/// NetCDF with `heights` of which nothing is written, in one of libnetcdf's formats.
std::filesystem::path unwritten_netcdf(const std::string& name, int format, std::size_t columns,
                                       std::size_t rows) {
  const auto path = write_bytes(name, "");
  int file = 0, dims[2], heights = 0;
  EXPECT_EQ(nc_create(path.c_str(), NC_CLOBBER | format, &file), NC_NOERR);
  nc_def_dim(file, "x", columns, &dims[0]);
  nc_def_dim(file, "y", rows, &dims[1]);
  EXPECT_EQ(nc_def_var(file, "heights", NC_DOUBLE, 2, dims, &heights), NC_NOERR);
  if (format == NC_NETCDF4) nc_def_var_deflate(file, heights, 0, 1, 9);
  nc_set_fill(file, NC_NOFILL, nullptr);
  EXPECT_EQ(nc_close(file), NC_NOERR);
  return path;
}

}  // namespace

TEST(Limits_of_x3p_analytic, a_size_announced_by_the_archive_alone_is_not_allocated) {
  const auto honest = write_zip(
      "a.x3p", {{"main.xml", x3p_main_of(23000, 23000, "D")}, {"bindata/data.bin", std::string(777, '\0')}});
  const auto lying = write_bytes(
      "b.x3p", replaced(bytes_of(honest), raw<std::uint32_t>(777), raw<std::uint32_t>(4232000000)));
  ASSERT_LT(std::filesystem::file_size(lying), 2000u);
  EXPECT_SAYS(refusal(lying), "b.x3p' holds 23000 x 23000 points that is too large for a file of");
  expect_refused_within(reading(lying), 32 * MiB);
  const auto few_points =
      write_zip("c.x3p", {{"main.xml", x3p_main("D", "", "")}, {"bindata/data.bin", std::string(777, '\0')}});
  const auto lying_part = write_bytes(
      "d.x3p", replaced(bytes_of(few_points), raw<std::uint32_t>(777), raw<std::uint32_t>(4232000000)));
  EXPECT_SAYS(refusal(lying_part), "d.x3p' holds a part 'bindata/data.bin' that is too large");
  expect_refused_within(reading(lying_part), 32 * MiB);
}

TEST(Limits_of_x3p_analytic, what_unpacks_to_a_thousand_times_its_size_is_refused_whatever_it_says) {
  const std::uint32_t size = 160 * MiB;
  const auto path = write_zip(
      "a.x3p", {{"main.xml", x3p_main("D", "", "")}, {"bindata/data.bin", std::string(size, '\0')}});
  ASSERT_LT(std::filesystem::file_size(path), 300000u);
  EXPECT_SAYS(refusal(path), "too large");
  expect_refused_within(reading(path), 32 * MiB);
  // The archive says 48 bytes and goes on for 160 MiB.
  const auto lying = write_bytes("b.x3p", replaced(bytes_of(path), raw(size), raw<std::uint32_t>(48)));
  EXPECT_SAYS(refusal(lying), "cannot be unpacked");
  expect_refused_within(reading(lying), 32 * MiB);
}

TEST(Limits_of_x3p_analytic, a_flat_map_packed_a_thousand_times_is_read) {
  const int n = 2048;
  const auto path = write_zip("a.x3p", {{"main.xml", x3p_main_of(n, n, "D")},
                                        {"bindata/data.bin", std::string(std::size_t{8} * n * n, '\0')}});
  ASSERT_LT(std::filesystem::file_size(path), 60000u);
  EXPECT_EQ(read_topography(path).nx, n);
  EXPECT_LT(reading(path).peak_bytes, 3 * read_limits::most_unpacked(0));
}

TEST(Limits_of_x3p_analytic, xml_nested_300000_deep_or_of_many_megabytes_is_refused) {
  std::string nested;
  for (int i = 0; i < 300000; ++i) nested += "<a>";
  EXPECT_EQ(reading(write_zip("a.x3p", {{"main.xml", nested}})).end, ChildOutcome::End::refused);
  std::string wide = "<a>";
  for (int i = 0; i < 2000000; ++i) wide += "<a/>";
  expect_refused_within(reading(write_zip("b.x3p", {{"main.xml", wide + "</a>"}})), 32 * MiB);
}

TEST(Limits_of_netcdf_analytic, a_header_says_how_long_its_file_is_once_it_is_whole) {
  const auto number = [](std::uint32_t value) {
    std::string bytes(4, 0);
    for (int i = 0; i < 4; ++i) bytes[static_cast<std::size_t>(i)] = static_cast<char>(value >> (24 - 8 * i));
    return bytes;
  };
  const std::string none = number(0) + number(0), x = number(1) + std::string("x\0\0\0", 4);
  // No records; one dimension x of 3; no attributes; one variable x(x) of doubles that begins at byte
  // 0x5a5b5c.
  const std::string header = "CDF\x01" + number(0) + number(10) + number(1) + x + number(3) + none +
                             number(11) + number(1) + x + number(1) + number(0) + none + number(6) +
                             number(24) + number(0x5a5b5c);
  EXPECT_EQ(netcdf_classic_length(header), 0x5a5b5cu + 24);
  for (std::size_t length = 4; length < header.size(); ++length)
    EXPECT_FALSE(netcdf_classic_length(header.substr(0, length))) << length;
}

TEST(Limits_of_netcdf_analytic, announced_records_are_not_allocated) {
  const auto path = unwritten_netcdf("a.nc", 0, NC_UNLIMITED, 40000);
  std::string bytes = bytes_of(path);
  bytes.replace(4, 4, big_endian(40000));
  bytes.resize(960);
  const auto lying = write_bytes("b.nc", bytes);
  EXPECT_SAYS(refusal(lying), "b.nc' has 960 of its 128000");
  expect_refused_within(reading(lying), 32 * MiB);
}

TEST(Limits_of_netcdf_analytic, a_number_of_points_that_overflows_is_refused) {
  const std::string bytes = bytes_of(unwritten_netcdf("a.nc", NC_64BIT_OFFSET, 3, 2));
  const auto dimension = [](char name, std::uint32_t points) {
    return big_endian(1) + name + std::string(3, '\0') + big_endian(points);
  };
  const std::string wide = replaced(bytes, dimension('x', 3), dimension('x', 1u << 30));
  const auto path = write_bytes("b.nc", replaced(wide, dimension('y', 2), dimension('y', 1u << 31)));
  EXPECT_SAYS(refusal(path), "b.nc' has");
  expect_refused_within(reading(path), 32 * MiB);
}

TEST(Limits_of_netcdf_analytic, of_hdf5_may_announce_what_it_can_hold_packed) {
  const auto path = unwritten_netcdf("a.nc", NC_NETCDF4, 40000, 40000);
  EXPECT_SAYS(refusal(path), "a.nc' announces 40000 x 40000 points, too many for a file of");
  expect_refused_within(reading(path), 64 * MiB);
  // Not written: all points are missing, but that is found out by reading them.
  EXPECT_SAYS(refusal(unwritten_netcdf("b.nc", NC_NETCDF4, 500, 500)), "does not say how wide");
}

TEST(Limits_of_every_map_analytic, memory_stays_below_the_stated_multiple_of_the_file) {
  std::string points = "# size: 1 um\n", columns, components, sections = "\\*File list\n", titles;
  while (points.size() < MiB) points += "1 1 1 1 1 1 1 1\n";
  for (int y = 0; columns.size() < MiB; ++y)
    for (int x = 0; x < 9; ++x) columns += std::to_string(x) + " " + std::to_string(y) + " 1\n";
  for (int i = 0; components.size() < MiB; ++i) components += gwy_component(std::to_string(i), 'b', "x");
  while (sections.size() < MiB) sections += "\\*Ciao image list\n";
  sections += "\\*File list end\n";
  while (titles.size() < MiB) titles += "\n";
  const std::vector<std::pair<std::string, std::string>> files{
      {"matrix.txt", points},
      {"points.xyz", columns},
      {"map.gsf", gsf_bytes("XRes = 512\nYRes = 512\nXReal = 1e-6\nYReal = 1e-6\nZUnits = m\n",
                            std::vector<float>(512 * 512))},
      {"map.gwy", gwy_bytes(components)},
      {"scan.001", sections},
      {"empty.txt", titles}};
  for (const auto& [name, bytes] : files) {
    const ChildOutcome outcome = reading(write_bytes(name, bytes));
    EXPECT_TRUE(outcome.end == ChildOutcome::End::done || outcome.end == ChildOutcome::End::refused) << name;
    EXPECT_LT(outcome.peak_bytes, 8 * MiB + stated_multiple * bytes.size()) << name;
  }
}

TEST(Limits_of_every_map_analytic, gwyddion_objects_300000_deep_are_refused) {
  std::string tail(300000 * 9, '\0');
  for (std::size_t i = 0; i < 300000; ++i) {
    const std::uint32_t rest = static_cast<std::uint32_t>(tail.size() - 9 * i - 9);
    tail.replace(9 * i, 9, std::string("a\0oT\0", 5) + raw(rest));
  }
  EXPECT_EQ(reading(write_bytes("deep.gwy",
                                "GWYP" + std::string("T\0", 2) + raw<std::uint32_t>(tail.size()) + tail))
                .end,
            ChildOutcome::End::refused);
}

TEST(Limits_of_every_map_analytic, a_header_line_of_a_megabyte_is_no_crash) {
  const std::string long_text(MiB, 'a');
  const std::string scan = nanoscope_bytes({NanoscopeImage{}}, 2);
  const auto scale = scan.find("\\@2:Z scale: V [");
  const auto end = scan.find('\n', scale);
  EXPECT_EQ(reading(write_bytes("a.001", scan.substr(0, scale) + "\\@2:Z scale: V [" + long_text + "] (" +
                                             long_text + ") 4 V" + scan.substr(end)))
                .end,
            ChildOutcome::End::refused);
  EXPECT_EQ(reading(write_bytes("b.xyz", "x [" + long_text +
                                             "] y [um] z [nm]\n0 0 1\n1e-6 0 1\n0 1e-6 1\n1e-6 1e-6 1\n"))
                .end,
            ChildOutcome::End::done);
}

TEST(Limits_of_every_map_analytic, a_header_of_no_break_spaces_is_read_in_time) {
  std::string blanks;
  while (blanks.size() < MiB) blanks += "\xC2\xA0";
  EXPECT_SAYS(refusal(write_bytes("a.txt", blanks)), "is empty");
}

TEST(Limits_of_every_map_analytic, a_device_is_no_map) {
  EXPECT_SAYS(refusal("/dev/zero"), "'/dev/zero' is a device, not a file");
}

TEST(Names_of_channels_analytic, in_latin_1_are_utf8_afterwards) {
  const auto path = write_bytes(
      "a.gsf", gsf_bytes("XRes = 2\nYRes = 2\nXReal = 1e-6\nYReal = 1e-6\nZUnits = m\nTitle = H\xF6he\n",
                         {0, 1e-9f, 0, 1e-9f}));
  EXPECT_EQ(read_topography(path).channel, "Höhe");
}

// What is packed by zlib inside: gzip around any file, matrices of MATLAB; and arrays of other kinds.
#include "core/read_limits.h"
#include "tests/support/peak_memory.h"
#include "tests/surfaces/readers/instrument_files.h"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr std::uint64_t MiB = 1u << 20;

ReadOptions sized() {
  ReadOptions options;
  options.size_x_m = 3e-6;
  options.height_unit = "nm";
  return options;
}

std::string zeros_packed(std::size_t count, int window_bits) {
  return deflated(std::string(count, '\0'), window_bits);
}

}  // namespace

TEST(Gzip_analytic, of_two_members_is_one_file) {
  const std::string bytes = sdf_map();
  expect_common_map(read_topography(
      write_bytes("a.gz", deflated(bytes.substr(0, 50), gzip_bits) + deflated(bytes.substr(50), gzip_bits))));
}

TEST(Gzip_file_behaviour, cut_off_or_damaged_is_refused) {
  const std::string packed = deflated(sdf_map(), gzip_bits);
  for (std::size_t length = 3; length < packed.size(); ++length)
    EXPECT_SAYS(refusal(write_bytes("a.gz", packed.substr(0, length))), "cannot be unpacked");
  std::string wrong_sum = packed;
  wrong_sum[packed.size() - 6] ^= 1;
  EXPECT_SAYS(refusal(write_bytes("a.gz", wrong_sum)), "cannot be unpacked");
  EXPECT_SAYS(refusal(write_bytes("a.gz", deflated(packed, gzip_bits))), "is of a kind that is not read");
}

TEST(Limits_of_gzip_analytic, what_unpacks_without_end_is_refused_at_the_limit) {
  const auto path = write_bytes("a.gz", zeros_packed(70 * MiB, gzip_bits));
  ASSERT_LT(std::filesystem::file_size(path), MiB / 2);
  EXPECT_SAYS(refusal(path), "unpacks to more than");
  expect_refused_within(measured_in_child([&] { read_topography(path); }),
                        3 * read_limits::most_unpacked(std::filesystem::file_size(path)));
}

TEST(Matlab_analytic, a_packed_matrix_is_read_and_named) {
  const std::string plain = mat_map();
  const std::string packed = deflated(plain.substr(128), zlib_bits);
  const Topography map = read_topography(write_bytes("a.mat", plain.substr(0, 128) + raw<std::uint32_t>(15) +
                                                                  raw<std::uint32_t>(packed.size()) + packed),
                                         sized());
  expect_common_map(map);
  EXPECT_EQ(map.channel, "z");
}

TEST(Matlab_analytic, numbers_lists_and_complex_matrices_are_no_channels) {
  std::string doubles;
  for (const double nm : {1, 4, 2, 5, 3, 6}) doubles += raw(nm);
  const std::string others = mat_matrix("a", 1, 1, raw(1.0)) + mat_matrix("b", 6, 1, doubles) +
                             mat_matrix("c", 2, 3, doubles, 6 | 0x0800) + mat_matrix("d", 2, 3, doubles, 4);
  const Topography map =
      read_topography(write_bytes("a.mat", mat_bytes(others + mat_matrix("z", 2, 3, doubles))), sized());
  EXPECT_SAYS(map.source, "channel 0 of 1");
  EXPECT_SAYS(refusal(write_bytes("b.mat", mat_bytes(others))), "holds no matrix of real numbers");
}

TEST(Limits_of_matlab_analytic, packed_matrices_share_one_limit) {
  const std::string packed = zeros_packed(33 * MiB, zlib_bits);
  const std::string element = raw<std::uint32_t>(15) + raw<std::uint32_t>(packed.size()) + packed;
  const auto path = write_bytes("a.mat", mat_bytes(element + element));
  EXPECT_SAYS(refusal(path), "unpacks to more than 64 MiB");
  expect_refused_within(measured_in_child([&] { read_topography(path); }), 192 * MiB);
}

TEST(Npy_analytic, of_each_type_and_order_is_read) {
  const auto read = [](const std::string& type, bool columns_first, const std::string& data) {
    expect_common_map(read_topography(
        write_bytes("a.npy", npy_bytes("{'descr': '" + type + "', 'fortran_order': " +
                                           (columns_first ? "True" : "False") + ", 'shape': (2, 3), }",
                                       data)),
        sized()));
  };
  read("<f4", false, map_numbers<float>(1, true));
  read("|i1", false, map_numbers<std::int8_t>(1, true));
  read("|u1", false, map_numbers<std::uint8_t>(1, true));
  read("<i2", false, map_numbers<std::int16_t>(1, true));
  read("<u4", false, map_numbers<std::uint32_t>(1, true));
  read("<i8", false, map_numbers<std::int64_t>(1, true));
  std::string big, columns;
  for (const int nm : {1, 2, 3, 4, 5, 6}) big += raw_big<double>(nm);
  for (const double nm : {1, 4, 2, 5, 3, 6}) columns += raw(nm);
  read(">f8", false, big);
  read("<f8", true, columns);
}

TEST(Npy_file_behaviour, that_is_no_map_is_refused) {
  const auto said = [](const std::string& dictionary) {
    return refusal(write_bytes("a.npy", npy_bytes(dictionary, map_numbers<double>(1, true))), sized());
  };
  EXPECT_SAYS(said("{'descr': '<f8', 'fortran_order': False, 'shape': (6,), }"),
              "of 1 dimension(s) and no map");
  EXPECT_SAYS(said("{'descr': '<c16', 'fortran_order': False, 'shape': (2, 3), }"), "of type '<c16'");
  EXPECT_SAYS(said("{'descr': '<f8', 'fortran_order': False, 'shape': (-2, 3), }"), "cannot be read");
  EXPECT_SAYS(said("{'descr': '<f8', 'fortran_order': False, 'shape': (999999999, 3), }"),
              "so it is damaged");
  EXPECT_SAYS(said("{'shape': (2, 3)}"), "save the array again");
}

TEST(Npy_file_behaviour, says_that_metres_were_taken_and_how_it_lies) {
  ReadOptions options;
  options.size_x_m = 30;
  EXPECT_SAYS(read_topography(write_bytes("a.npy", npy_map()), options).source,
              "no unit of height given, metres taken; the array's first index runs down the image");
}

#include "surfaces/read_topography.h"

#include "tests/support/peak_memory.h"
#include "tests/surfaces/readers/instrument_list.h"

using namespace asperity;
using namespace asperity::test;

namespace {

ReadOptions options_for(const InstrumentFile& file) {
  ReadOptions options;
  if (!file.says_size) {
    options.size_x_m = 3e-6;
    options.height_unit = "nm";
  }
  return options;
}

class Instrument_formats_analytic : public testing::TestWithParam<InstrumentFile> {};
class Instrument_formats_behaviour : public testing::TestWithParam<InstrumentFile> {};

std::string as_text(const ReadOptions& options, const std::string& bytes) {
  try {
    const SourceFile file{"map.bin", bytes};
    const Topography map = topography_from(file, options);
    std::size_t known = 0;
    for (const double height : map.heights) known += std::isfinite(height);
    return known > 0 && map.nx >= 2 && map.ny >= 2 && map.lx > 0 && map.ly > 0 ? "read" : "read badly";
  } catch (const InputError& error) {
    return error.what();
  }
}

}  // namespace

TEST_P(Instrument_formats_analytic, the_common_map_is_read_with_size_unit_and_orientation) {
  const InstrumentFile& file = GetParam();
  const auto path = write_bytes("map.bin", file.bytes);
  expect_common_map(read_topography(path, options_for(file)));
}

TEST_P(Instrument_formats_analytic, packed_by_gzip_it_is_the_same) {
  const InstrumentFile& file = GetParam();
  const Topography map = read_topography(write_gzip("map.gz", file.bytes), options_for(file));
  expect_common_map(map);
  EXPECT_SAYS(map.source, "unpacked from gzip");
}

TEST_P(Instrument_formats_behaviour, cut_off_anywhere_it_is_refused) {
  const InstrumentFile& file = GetParam();
  for (std::size_t length = 0; length < file.bytes.size(); ++length) {
    const std::string said = as_text(options_for(file), file.bytes.substr(0, length));
    if (file.is_text && length > file.bytes.size() / 2) continue;
    EXPECT_NE(said, "read") << file.name << " of " << length << " bytes";
    EXPECT_NE(said, "read badly") << file.name << " of " << length << " bytes";
  }
}

TEST_P(Instrument_formats_behaviour, with_any_number_replaced_it_is_read_or_refused_in_little_memory) {
  const InstrumentFile& file = GetParam();
  const auto work = [&] {
    for (const std::string& number : {std::string(4, '\xFF'), std::string("\xFF\xFF\xFF\x7F", 4),
                                      std::string("\0\0\xC0\x7F", 4), std::string(4, '\0')})
      for (std::size_t at = 0; at + 4 <= std::min<std::size_t>(file.bytes.size(), 1200); ++at) {
        std::string bytes = file.bytes;
        bytes.replace(at, 4, number);
        if (as_text(options_for(file), bytes) == "read badly") throw std::runtime_error("a bad map");
      }
  };
  const ChildOutcome outcome = measured_in_child(work);
  EXPECT_EQ(outcome.end, ChildOutcome::End::done);
  EXPECT_LT(outcome.peak_bytes, 32u << 20);
}

std::string name_of(const testing::TestParamInfo<InstrumentFile>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Of, Instrument_formats_analytic, testing::ValuesIn(instrument_files()), name_of);
INSTANTIATE_TEST_SUITE_P(Of, Instrument_formats_behaviour, testing::ValuesIn(instrument_files()), name_of);

TEST(Instrument_channels_analytic, without_a_wish_the_first_of_lengths_is_taken_and_named) {
  EXPECT_EQ(read_topography(write_bytes("a.ibw", igor_map())).channel, "HeightRetrace");
  const Topography nid = read_topography(write_bytes("a.nid", nid_map()));
  EXPECT_EQ(nid.channel, "Scan forward (Z-Axis)");
  EXPECT_SAYS(nid.source, "channel 1 of 2");
  EXPECT_EQ(read_topography(write_bytes("a.mi", mi_map())).channel, "Topography (Retrace)");
  EXPECT_EQ(read_topography(write_bytes("a.jpk", jpk_map())).channel, "Height (measured) (retrace)");
  EXPECT_EQ(read_topography(write_bytes("a.sur", sur_map())).channel, "wafer");
}

TEST(Instrument_channels_behaviour, of_other_quantities_are_refused_with_those_there_are) {
  ReadOptions options;
  options.channel = "0";
  EXPECT_SAYS(
      refusal(write_bytes("a.nid", nid_map()), options),
      "channel 'Scan forward (Phase)' of '" + (scratch_folder() / "a.nid").string() + "' holds no heights");
  EXPECT_SAYS(refusal(write_bytes("a.mi", mi_map()), options), "among 0: 'Deflection' in V, 1: 'Topography");
  EXPECT_SAYS(refusal(write_bytes("a.jpk", jpk_map("V"))), "only 0: 'Height (measured) (retrace)' in V");
  std::string current = igor_map();
  current.replace(current.find("HeightRetrace"), 13, std::string("CurrentTrace\0", 13));
  EXPECT_SAYS(refusal(write_bytes("a.ibw", current)), "holds no heights");
}

TEST(Instrument_orientation_analytic, a_reflected_grid_of_jpk_begins_at_the_top) {
  expect_common_map(read_topography(write_bytes("a.jpk", jpk_map("m", true))));
}

TEST(Instrument_marks_analytic, of_points_that_were_not_measured_make_them_missing) {
  const auto lower_left_missing = [](const std::string& bytes) {
    const Topography map = read_topography(write_bytes("a.bin", bytes));
    return map.missing_count() == 1 && std::isnan(map.at(0, 0));
  };
  const auto with = [](std::string bytes, std::size_t from_end, const std::string& part) {
    return bytes.replace(bytes.size() - from_end, part.size(), part);
  };
  const std::string low_16 = raw<std::int16_t>(-32768), high_16 = raw<std::int16_t>(32767);
  EXPECT_TRUE(lower_left_missing(with(sur_map(), 6, raw<std::int16_t>(-102))));
  EXPECT_TRUE(lower_left_missing(with(opd_map(), 24, raw(1e38f))));
  EXPECT_TRUE(lower_left_missing(with(al3d_map(), 12, raw(3.0e15f))));
  EXPECT_TRUE(lower_left_missing(with(sdf_map(), 6, low_16)));
  EXPECT_TRUE(lower_left_missing(sdf_text("10 20 30 BAD 50 60")));
  EXPECT_TRUE(lower_left_missing(with(os3d_map(), 12, raw(-3.4028235e38f))));
  EXPECT_TRUE(lower_left_missing(with(metropro_map(), 12, raw_big<std::int32_t>(2147483640))));
  EXPECT_TRUE(lower_left_missing(with(bcr_map(1), 6, high_16)));
  EXPECT_FALSE(lower_left_missing(with(bcr_map(0), 6, high_16)));
  EXPECT_TRUE(lower_left_missing(with(bcrf_map(), 12, raw(std::nanf("")))));
  std::string frt = frt_map();
  frt.replace(frt.size() - 12, 2, raw<std::uint16_t>(1));
  EXPECT_TRUE(lower_left_missing(frt));
}

TEST(Limits_of_instruments_analytic, tags_that_pictures_share_without_end_are_not_kept) {
  std::string bytes = std::string("II*\0", 4) + raw<std::uint32_t>(8) + raw<std::uint16_t>(60000);
  for (std::uint32_t tag = 0; tag < 60000; ++tag)
    bytes += raw<std::uint16_t>(tag) + raw<std::uint16_t>(1) + raw<std::uint32_t>(1) + raw<std::uint32_t>(0);
  const auto path = write_bytes("a.jpk", bytes + raw<std::uint32_t>(8));  // the next is the same again
  EXPECT_SAYS(refusal(path), "share their tags without end");
  expect_refused_within(measured_in_child([&] { read_topography(path); }), 32u << 20);
}

TEST(Limits_of_instruments_analytic, layers_of_one_point_are_no_channels) {
  std::string wave = igor_map();
  put(wave, 64 + 68, raw<std::int32_t>(1) + raw<std::int32_t>(1) + raw<std::int32_t>(1 << 30));
  std::uint16_t sum = 0, word = 0;
  put(wave, 2, std::string(2, '\0'));
  for (std::size_t at = 0; at < 384; at += 2) {
    std::memcpy(&word, wave.data() + at, 2);
    sum = static_cast<std::uint16_t>(sum + word);
  }
  put(wave, 2, raw<std::uint16_t>(-sum));
  EXPECT_SAYS(refusal(write_bytes("a.ibw", wave)), "of 1073741824 layers");
}

TEST(Instrument_kinds_behaviour, that_are_not_read_are_refused_by_name_and_remedy) {
  EXPECT_SAYS(refusal(write_bytes("a.mdt", std::string("\x01\xb0\x93\xff", 4))),
              "is an NT-MDT file (.mdt), which is not read; open it in Gwyddion and export .gsf");
  EXPECT_SAYS(refusal(write_bytes("a.OPDx", "VCA DATA\1")), "Vision64 or Dektak (.OPDx)");
  EXPECT_SAYS(refusal(write_bytes("a.png", "\x89PNG\r\n")), "it holds colours and no lengths");
  EXPECT_SAYS(refusal(write_bytes("a.mat", "MATLAB 7.3 MAT-file, Platform")), "save(name, '-v7')");
  EXPECT_SAYS(refusal(write_bytes("a.vk6", "VK6\1\2")), "export .vk4");
  EXPECT_SAYS(refusal(write_bytes("a.sur", "DSCOMPRESSED")), "without compression");
  EXPECT_SAYS(refusal(write_bytes("a.bz2", "BZh91AY")), "packed by bzip2");
  std::string series = sur_map();
  put(series, 18, raw<std::uint16_t>(5));
  EXPECT_SAYS(refusal(write_bytes("b.sur", series)), "of type 5 and not a single surface (2)");
  std::string wave(126, '\0');
  put(wave, 0, raw<std::uint16_t>(2) + raw<std::uint16_t>(0xFFFE));
  EXPECT_SAYS(refusal(write_bytes("a.ibw", wave)), "of version 2, which has one dimension");
}

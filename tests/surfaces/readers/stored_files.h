// Small files of each format written byte by byte, so that the readers are judged by the formats'
// descriptions and not by code of their own. All hold the same map: 3 x 2 pixels, 3 um x 2 um, heights 1 2 3
// (top row) and 4 5 6 nm.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>
#include <zip.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "surfaces/read_topography.h"

namespace asperity::test {

/// A folder of this process, removed at its end.
inline const std::filesystem::path& scratch_folder() {
  struct Folder {
    std::filesystem::path path =
        std::filesystem::path(testing::TempDir()) / ("asperity_readers_" + std::to_string(::getpid()));
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() {
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
    }
  };
  static const Folder folder;
  return folder.path;
}

/// A file of that name in the folder of this process.
inline std::filesystem::path write_bytes(const std::string& name, const std::string& bytes) {
  const auto path = scratch_folder() / name;
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The value as it lies in memory of a little-endian machine.
template <class T>
std::string raw(T value) {
  return {reinterpret_cast<const char*>(&value), sizeof(T)};
}

/// The sentence with which a file is refused; empty if it is read.
inline std::string refusal(const std::filesystem::path& path, const ReadOptions& options = {}) {
  try {
    read_topography(path, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

#define EXPECT_SAYS(sentence, part) \
  EXPECT_NE((sentence).find(part), std::string::npos) << "in: " << (sentence)

inline const std::vector<double>& heights_nm() {
  static const std::vector<double> heights{1, 2, 3, 4, 5, 6};  // top row first
  return heights;
}

/// Heights of the common map as a Topography holds them: bottom row first.
inline void expect_common_map(const Topography& map, double relative = 1e-6) {
  ASSERT_EQ(map.nx, 3);
  ASSERT_EQ(map.ny, 2);
  EXPECT_NEAR(map.lx, 3e-6, 3e-6 * relative);
  EXPECT_NEAR(map.ly, 2e-6, 2e-6 * relative);
  const double expected[] = {4e-9, 5e-9, 6e-9, 1e-9, 2e-9, 3e-9};
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(map.heights[i], expected[i], 1e-9 * relative) << "pixel " << i;
  EXPECT_EQ(map.missing_count(), 0u);
}

// ---- Gwyddion Simple Field
// -------------------------------------------------------------------------------------------

inline std::string gsf_bytes(const std::string& fields, const std::vector<float>& heights) {
  std::string bytes = "Gwyddion Simple Field 1.0\n" + fields;
  bytes.append(4 - bytes.size() % 4, '\0');
  for (const float height : heights) bytes += raw(height);
  return bytes;
}

// ---- Gwyddion native
// -------------------------------------------------------------------------------------------------

inline std::string gwy_component(const std::string& name, char type, const std::string& data) {
  return name + '\0' + type + data;
}
inline std::string gwy_object(const std::string& type, const std::string& components) {
  return type + '\0' + raw<std::uint32_t>(components.size()) + components;
}
inline std::string gwy_unit(const std::string& unit) {
  return gwy_object("GwySIUnit", gwy_component("unitstr", 's', unit + '\0'));
}
inline std::string gwy_doubles(const std::vector<double>& values) {
  std::string bytes = raw<std::uint32_t>(values.size());
  for (const double value : values) bytes += raw(value);
  return bytes;
}
inline std::string gwy_field(const std::vector<double>& heights, const std::string& unit) {
  return gwy_object(
      "GwyDataField",
      gwy_component("xres", 'i', raw<std::int32_t>(3)) + gwy_component("yres", 'i', raw<std::int32_t>(2)) +
          gwy_component("xreal", 'd', raw(3e-6)) + gwy_component("yreal", 'd', raw(2e-6)) +
          gwy_component("si_unit_xy", 'o', gwy_unit("m")) + gwy_component("si_unit_z", 'o', gwy_unit(unit)) +
          gwy_component("data", 'D', gwy_doubles(heights)));
}
inline std::string gwy_bytes(const std::string& components) {
  return "GWYP" + gwy_object("GwyContainer", components);
}

// ---- NanoScope
// -------------------------------------------------------------------------------------------------------

struct NanoscopeImage {
  std::string name = "Height Sensor", sensitivity = "Sens. Zsens", scan_size = "3 2 ~m";
  int bytes_per_pixel = 2;
};

/// Stored integers 256, 512, ... with 16 nm/V and 4.096 V over 2^16 steps: 1 nm per 1000 steps.
inline std::string nanoscope_bytes(const std::vector<NanoscopeImage>& images, int stored_bytes,
                                   const std::string& version = "0x07200000") {
  constexpr std::size_t header_size = 4096;
  std::string header = "\\*File list\r\n\\Version: " + version +
                       "\r\n\\*Scanner list\r\n\\@Sens. Zsens: V 16.00000 nm/V\r\n" +
                       "\\*Ciao scan list\r\n\\Scan Size: 9000 nm\r\n\\@Sens. Phase: V 1.000000 \r\n";
  std::string data;
  for (const auto& image : images) {
    header += "\\*Ciao image list\r\n\\Data offset: " + std::to_string(header_size + data.size()) +
              "\r\n\\Data length: " + std::to_string(6 * stored_bytes) +
              "\r\n\\Bytes/pixel: " + std::to_string(image.bytes_per_pixel) +
              "\r\n\\Samps/line: 3\r\n\\Number of lines: 2\r\n\\Scan Size: " + image.scan_size +
              "\r\n\\Line Direction: Trace\r\n\\@2:Image Data: S [ZSensor] \"" + image.name +
              "\"\r\n\\@2:Z scale: V [" + image.sensitivity + "] (0.0000625 V/LSB) 4.096000 V\r\n";
    for (const int nanometres : {4, 5, 6, 1, 2, 3}) {  // bottom row first
      const double stored = nanometres * 1000 * (image.bytes_per_pixel == 4 ? 65536.0 : 1.0);
      data += stored_bytes == 2 ? raw<std::int16_t>(stored) : raw<std::int32_t>(stored);
    }
  }
  header += "\\*File list end\r\n";
  header.resize(header_size, '\0');
  return header + data;
}

// ---- Park TIFF
// -------------------------------------------------------------------------------------------------------

inline std::string utf16(const std::string& text, std::size_t characters) {
  std::string bytes;
  for (std::size_t i = 0; i < characters; ++i) bytes += raw<std::uint16_t>(i < text.size() ? text[i] : 0);
  return bytes;
}

struct ParkImage {
  std::uint32_t version = 0x01000002, image_type = 0, data_type = 0;
  double gain = 1e-3, scale = 1, offset = 0;  ///< heights = gain * (scale * stored + offset) um
  std::string unit = "um";
  std::string data;
};

inline std::string park_header(const ParkImage& image) {
  const auto u = [](std::uint32_t value) { return raw(value); };
  const auto d = [](double value) { return raw(value); };
  std::string header = u(image.image_type) + utf16("ZHeight", 32) + utf16("NCM", 8) + d(0) + u(0) + u(0) +
                       u(3) + u(2) + d(0) + u(0) + d(0) + u(1) + u(1) + u(0) + d(3.0) + d(2.0) + d(0) + d(0) +
                       d(1) + d(0) + utf16("um", 8) + d(0) + d(0) + d(image.gain) + d(image.scale) +
                       d(image.offset) + utf16(image.unit, 8) + u(0) + u(0) + u(0) + u(0) + u(0) + u(0);
  if (image.version == 0x01000002)
    header += d(1) + d(1) + utf16("", 8) + utf16("", 8) + utf16("", 8) + u(image.data_type) + u(0) + u(0) +
              d(0) + d(0) + utf16("", 16);
  return header;
}

inline std::string park_bytes(const ParkImage& image, std::uint32_t magic = 0x0E031301) {
  const std::string header = park_header(image);
  const std::uint32_t data_at = 8, header_at = data_at + image.data.size(),
                      directory_at = header_at + header.size();
  const auto tag = [](int number, int type, std::uint32_t count, std::uint32_t value) {
    return raw<std::uint16_t>(number) + raw<std::uint16_t>(type) + raw(count) + raw(value);
  };
  return std::string("II*\0", 4) + raw(directory_at) + image.data + header + raw<std::uint16_t>(5) +
         tag(256, 4, 1, 3) + tag(50432, 4, 1, magic) + tag(50433, 4, 1, image.version) +
         tag(50434, 1, image.data.size(), data_at) + tag(50435, 1, header.size(), header_at) +
         raw<std::uint32_t>(0);
}

// ---- x3p
// -----------------------------------------------------------------------------------------------------------

inline std::filesystem::path write_zip(const std::string& name,
                                       const std::vector<std::pair<std::string, std::string>>& parts) {
  const auto path = write_bytes(name, "");
  int error = 0;
  zip_t* archive = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &error);
  for (const auto& [part, content] : parts)
    zip_file_add(archive, part.c_str(), zip_source_buffer(archive, content.data(), content.size(), 0),
                 ZIP_FL_OVERWRITE);
  EXPECT_EQ(zip_close(archive), 0);
  return path;
}

inline std::string x3p_main(const std::string& type, const std::string& z_scale,
                            const std::string& valid_link, const std::string& x_increment = "1e-6") {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<p:ISO5436_2 "
         "xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\">"
         "<Record1><Revision>ISO5436 - 2000</Revision><FeatureType>SUR</FeatureType><Axes>"
         "<CX><AxisType>I</AxisType><DataType>D</DataType><Increment>" +
         x_increment +
         "</Increment><Offset>0</Offset></CX>"
         "<CY><AxisType>I</AxisType><DataType>D</DataType><Increment>1e-6</Increment><Offset>0</Offset></CY>"
         "<CZ><AxisType>A</AxisType><DataType>" +
         type + "</DataType>" + z_scale +
         "</CZ></Axes></Record1>"
         "<Record3><MatrixDimension><SizeX>3</SizeX><SizeY>2</SizeY><SizeZ>1</SizeZ></"
         "MatrixDimension><DataLink>"
         "<PointDataLink>bindata/data.bin</PointDataLink>" +
         valid_link + "</DataLink></Record3></p:ISO5436_2>";
}

}  // namespace asperity::test

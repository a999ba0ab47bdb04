// The common map of stored_files.h (3 x 2 pixels, 3 um x 2 um, 1 2 3 nm in the top row, 4 5 6 nm below) in
// the formats of more instruments and programs, written byte by byte from the formats' descriptions.
#pragma once

#include <zlib.h>

#include <cstring>

#include "surfaces/readers/format.h"
#include "tests/surfaces/readers/stored_files.h"

namespace asperity::test {

/// Numbers of the map, each times `unit`, the top or the bottom row first.
template <class T>
std::string map_numbers(double unit, bool top_first) {
  std::string bytes;
  for (const int nm : top_first ? std::vector<int>{1, 2, 3, 4, 5, 6} : std::vector<int>{4, 5, 6, 1, 2, 3})
    bytes += raw<T>(static_cast<T>(nm * unit));
  return bytes;
}

template <class T>
std::string raw_big(T value) {
  std::string bytes = raw(value);
  return {bytes.rbegin(), bytes.rend()};
}

inline void put(std::string& bytes, std::size_t at, const std::string& part) {
  if (bytes.size() < at + part.size()) bytes.resize(at + part.size(), '\0');
  bytes.replace(at, part.size(), part);
}

constexpr int zlib_bits = 15, gzip_bits = zlib_bits + 16;

/// Packed by zlib, in its own wrapping or that of gzip.
inline std::string deflated(const std::string& bytes, int window_bits) {
  z_stream stream{};
  EXPECT_EQ(deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, window_bits, 8, Z_DEFAULT_STRATEGY),
            Z_OK);
  std::string packed(deflateBound(&stream, bytes.size()) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

inline std::filesystem::path write_gzip(const std::string& name, const std::string& bytes) {
  return write_bytes(name, deflated(bytes, gzip_bits));
}

/// A text in a field of fixed length.
inline std::string field(std::string text, std::size_t length, char filling = '\0') {
  text.resize(length, filling);
  return text;
}

// ---- without sizes and units

inline std::string npy_bytes(const std::string& dictionary, const std::string& data) {
  const std::string header = field(dictionary, 117, ' ') + "\n";
  return "\x93NUMPY" + std::string("\x01\0", 2) + raw<std::uint16_t>(header.size()) + header + data;
}

inline std::string npy_map() {
  return npy_bytes("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }",
                   map_numbers<double>(1, true));
}

/// An element of a MATLAB file, filled up to eight bytes.
inline std::string mat_element(std::uint32_t type, const std::string& data) {
  const std::size_t filled = (data.size() + 7) / 8 * 8;
  return raw(type) + raw<std::uint32_t>(data.size()) + field(data, filled);
}

inline std::string mat_matrix(const std::string& name, std::int32_t rows, std::int32_t columns,
                              const std::string& doubles, std::uint32_t flags = 6) {
  return mat_element(14, mat_element(6, raw(flags) + raw<std::uint32_t>(0)) +
                             mat_element(5, raw(rows) + raw(columns)) + mat_element(1, name) +
                             mat_element(9, doubles));
}

inline std::string mat_bytes(const std::string& elements) {
  return field("MATLAB 5.0 MAT-file", 124, ' ') + raw<std::uint16_t>(0x0100) + "IM" + elements;
}

inline std::string mat_map() {
  std::string doubles;
  for (const double nm : {1, 4, 2, 5, 3, 6}) doubles += raw(nm);  // column by column
  return mat_bytes(mat_matrix("z", 2, 3, doubles));
}

// ---- with both

inline std::string igor_map(double nanometre = 1e-9) {
  std::string bytes(384, '\0');
  put(bytes, 0, raw<std::uint16_t>(5));
  put(bytes, 4, raw<std::uint32_t>(320 + 24));
  put(bytes, 36, raw<std::uint32_t>(0) + raw<std::uint32_t>(0) + raw<std::uint32_t>(64));  // two labels
  put(bytes, 64 + 16, raw<std::uint16_t>(2));
  put(bytes, 64 + 68, raw<std::int32_t>(3) + raw<std::int32_t>(2) + raw<std::int32_t>(1));
  put(bytes, 64 + 84, raw(1e-6) + raw(1e-6));
  put(bytes, 64 + 148, "m");
  put(bytes, 64 + 152, "m");
  std::uint16_t sum = 0;
  for (std::size_t at = 0; at < bytes.size(); at += 2) {
    std::uint16_t word;
    std::memcpy(&word, bytes.data() + at, 2);
    sum = static_cast<std::uint16_t>(sum + word);
  }
  put(bytes, 2, raw<std::uint16_t>(-sum));
  return bytes + map_numbers<float>(nanometre, false) + field("", 32) + field("HeightRetrace", 32);
}

inline std::string nid_map() {
  const std::string channel =
      "\r\nPoints=3\r\nLines=2\r\nFrame=Scan forward\r\nSaveMode=Binary\r\nSaveBits=16\r\nSaveSign=Signed\r\n"
      "SaveOrder=Intel\r\nDim0Range=3e-6\r\nDim0Unit=m\r\nDim1Range=2e-6\r\nDim1Unit=m\r\n";
  return "[DataSet]\r\nGroupCount=1\r\nGr0-Count=3\r\nGr0-Ch0=Set-0\r\nGr0-Ch2=Set-2\r\n[Set-0]" + channel +
         "Dim2Name=Phase\r\nDim2Unit=V\r\nDim2Range=1\r\nDim2Min=0\r\n[Set-2]" + channel +
         "Dim2Name=Z-Axis\r\nDim2Unit=m\r\nDim2Range=65.536e-9\r\nDim2Min=-32.768e-9\r\n\r\n#!" +
         std::string(12, '\1') + map_numbers<std::int16_t>(1000, false);
}

inline std::string sur_map() {
  std::string bytes = field("DIGITAL SURF", 512);
  put(bytes, 12,
      raw<std::uint16_t>(0) + raw<std::uint16_t>(1) + raw<std::uint16_t>(1) + raw<std::uint16_t>(2));
  put(bytes, 20, "wafer");
  put(bytes, 86, raw<std::uint16_t>(1));  // special points
  put(bytes, 98,
      raw<std::uint16_t>(16) + raw<std::int32_t>(-100) + raw<std::int32_t>(100) + raw<std::int32_t>(3) +
          raw<std::int32_t>(2) + raw<std::int32_t>(6));
  put(bytes, 120, raw(1.0f) + raw(1.0f) + raw(0.1f));
  put(bytes, 180, field("\xB5m", 16, ' ') + field("\xB5m", 16, ' ') + field("nm", 16, ' '));
  put(bytes, 334, raw<std::uint16_t>(5) + raw<std::uint16_t>(0));  // a comment of five bytes
  return bytes + "hello" + map_numbers<std::int16_t>(10, true);
}

inline std::string opd_block(const std::string& name, int type, std::size_t length) {
  return field(name, 16) + raw<std::int16_t>(type) + raw<std::int32_t>(length) + raw<std::uint16_t>(0xffff);
}

inline std::string opd_map() {
  std::string array = raw<std::uint16_t>(3) + raw<std::uint16_t>(2) + raw<std::uint16_t>(4);
  for (const float nm : {4, 1, 5, 2, 6, 3}) array += raw(nm / 500);  // column by column from the bottom up
  return std::string("\x01\0", 2) + opd_block("Directory", 1, 24 * 6) + opd_block("Title", 5, 5) +
         opd_block("Wavelength", 7, 4) + opd_block("Mult", 6, 2) + opd_block("Pixel_size", 7, 4) +
         opd_block("RAW_DATA", 3, array.size()) + "title" + raw(1000.0f) + raw<std::int16_t>(2) + raw(1e-3f) +
         array;
}

inline std::string al3d_map(const std::string& invalid = "3.0e+15") {
  const auto tag = [](const std::string& key, const std::string& value) {
    return field(key, 20) + field(value, 30) + "\r\n";
  };
  std::string bytes = std::string("AliconaImaging\0\r\n", 17) + tag("Version", "1") + tag("TagCount", "6") +
                      tag("Cols", "3") + tag("Rows", "2") + tag("PixelSizeXMeter", "1e-6") +
                      tag("PixelSizeYMeter", "1e-6") + tag("DepthImageOffset", "500") +
                      tag("InvalidPixelValue", invalid);
  bytes.resize(500, '\0');
  return bytes + raw(1e-9f) + raw(2e-9f) + raw(3e-9f) + raw(0.0f) + raw(4e-9f) + raw(5e-9f) + raw(6e-9f);
}

inline std::string mi_map() {
  return "fileType      Image\nxPixels       3\nyPixels       2\nxLength       3e-6\nyLength       2e-6\n"
         "bufferLabel   Deflection\nbufferRange   10\nbufferUnit    V\ntrace         Trace\n"
         "bufferLabel   Topography\nbufferRange   32.768\nbufferUnit    nm\ntrace         Retrace\n"
         "data          BINARY\n" +
         std::string(12, '\1') + map_numbers<std::int16_t>(1000, false);
}

inline std::string sdf_map() {
  return "bISO-1.0" + field("asperity", 34, ' ') + raw<std::uint16_t>(3) + raw<std::uint16_t>(2) + raw(1e-6) +
         raw(1e-6) + raw(1e-10) + raw(0.0) + std::string("\0\5\0", 3) + map_numbers<std::int16_t>(10, true);
}

inline std::string sdf_text(const std::string& heights = "10 20 30 40 50 60") {
  return "aISO-1.0\r\nManufacID   = asperity\r\nNumPoints   = 3\r\nNumProfiles = 2\r\nXscale      = 1e-6\r\n"
         "Yscale      = 1e-6\r\nZscale      = 1e-10\r\nCompression = 0\r\nDataType    = 5\r\n*\r\n" +
         heights + "\r\n*\r\n";
}

inline std::string os3d_map() {
  return "OmniSurf3D" + raw<std::int32_t>(1) + raw<std::int32_t>(1) + raw<std::int32_t>(5) + "wafer" +
         raw<std::int32_t>(0) + raw<std::int32_t>(3) + raw<std::int32_t>(2) + raw(1.0) + raw(1.0) + raw(0.0) +
         raw(0.0) + map_numbers<float>(1e-3, true);
}

inline std::string wsxm_map() {
  const std::string before =
      "WSxM file copyright Nanotec Electronica\r\nSxM Image file\r\nImage header size: ";
  const std::string after =
      "\r\n\r\n[Control]\r\n    X Amplitude: 3 um\r\n    Y Amplitude: 2 um\r\n[General Info]\r\n"
      "    Image Data Type: double\r\n    Number of columns: 3\r\n    Number of rows: 2\r\n"
      "    Z Amplitude: 5 nm\r\n[Header end]\r\n";
  std::string bytes = before + std::to_string(before.size() + 3 + after.size()) + after;
  for (const double nm : {6, 5, 4, 3, 2, 1}) bytes += raw(nm);  // from the lower right corner on
  return bytes;
}

inline std::string metropro_map() {
  std::string bytes = field("\x88\x1b\x03\x6f", 834);
  put(bytes, 4, raw_big<std::uint16_t>(1) + raw_big<std::uint32_t>(834));
  put(bytes, 68, raw_big<std::uint16_t>(3) + raw_big<std::uint16_t>(2));
  put(bytes, 164,
      raw_big(0.5f) + raw_big(4096e-9f) + raw_big(0.0f) + raw_big(1.0f) + raw_big(1.0f) + raw_big(1e-6f));
  for (const int nm : {1, 2, 3, 4, 5, 6}) bytes += raw_big<std::int32_t>(2 * nm);
  return bytes;
}

inline std::string vk4_map() {
  std::string bytes = field("VK4_", 388);
  put(bytes, 12 + 24, raw<std::uint32_t>(388));
  put(bytes, 84 + 168, raw<std::uint32_t>(1000000) + raw<std::uint32_t>(1000000) + raw<std::uint32_t>(100));
  bytes += raw<std::uint32_t>(3) + raw<std::uint32_t>(2) + raw<std::uint32_t>(32) + raw<std::uint32_t>(0) +
           raw<std::uint32_t>(24) + raw<std::uint32_t>(0) + raw<std::uint32_t>(100) + field("", 768);
  return bytes + map_numbers<std::uint32_t>(10, true);
}

inline std::string bcr_map(int voids = 0) {
  return field(
             "fileformat = bcrstm\nxpixels = 3\nypixels = 2\nxlength = 3\nylength = 2\nxunit = um\nyunit = "
             "um\n"
             "bit2nm = 0.1\nintelmode = 1\nvoidpixels = " +
                 std::to_string(voids) + "\n",
             2048, ' ') +
         map_numbers<std::int16_t>(10, true);
}

/// With a header in characters of 16 bit.
inline std::string bcrf_map() {
  const std::string text = field(
      "fileformat = bcrf_unicode\nheadersize = 300\nxpixels = 3\nypixels = 2\nxlength = 3000\n"
      "ylength = 2000\nzunit = um\n",
      299, ' ');
  return "\xFF\xFE" + utf16(text, text.size()) + map_numbers<float>(1e-3, true);
}

inline std::string frt_map(int first = 10) {
  const auto block = [](int tag, const std::string& data) {
    return raw<std::uint16_t>(tag) + raw<std::uint32_t>(data.size()) + data;
  };
  std::string heights = map_numbers<std::uint16_t>(10, false);
  put(heights, 6, raw<std::uint16_t>(first));
  return "FRTM_GLIDERV1.00" + raw<std::uint16_t>(4) +
         block(0x66, raw<std::uint32_t>(3) + raw<std::uint32_t>(2) + raw<std::uint32_t>(16)) +
         block(0x67, raw(3e-6) + raw(2e-6)) + block(0x6c, raw<std::uint32_t>(300) + raw(1e-10)) +
         block(0x0b, heights);
}

}  // namespace asperity::test

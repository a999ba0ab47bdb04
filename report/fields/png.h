// Pictures as pixels, as PNG, and as text for a page that needs no other file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace asperity::report {

/// Rows from top to bottom, three bytes (red, green, blue) per pixel.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
  Image() = default;
  Image(int w, int h) : width(w), height(h), rgb(static_cast<std::size_t>(w) * h * 3, 255) {}
  std::uint8_t* pixel(int x, int y) { return &rgb[3 * (static_cast<std::size_t>(y) * width + x)]; }
  const std::uint8_t* pixel(int x, int y) const {
    return &rgb[3 * (static_cast<std::size_t>(y) * width + x)];
  }
};

/// The bytes of a PNG file.
std::string png_bytes(const Image& image);
/// "data:image/png;base64,..."
std::string data_uri(const Image& image);

}  // namespace asperity::report

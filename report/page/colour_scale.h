// Colour scales that stay readable in print and for colour-blind readers: lightness grows or falls evenly.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace asperity::report {

using Colour = std::array<std::uint8_t, 3>;

class ColourScale {
 public:
  /// Blue to yellow ("viridis" of Smith and van der Walt, public domain): heights, stresses.
  static const ColourScale& viridis();
  /// White to dark red: what is zero nearly everywhere (pressure, plastic strain) leaves the paper white.
  static const ColourScale& white_to_red();

  /// t in [0, 1], clamped; NaN is light grey.
  Colour at(double t) const;

 private:
  explicit ColourScale(std::vector<Colour> anchors) : anchors_(std::move(anchors)) {}
  std::vector<Colour> anchors_;  ///< at equal distances, linear in between
};

/// "#rrggbb"
std::string hex(const Colour& colour);
/// Distinct colours for lines (Okabe and Ito 2008), repeated after seven.
std::string line_colour(std::size_t index);

}  // namespace asperity::report

#include "report/page/colour_scale.h"

#include <algorithm>
#include <cmath>

#include "core/printed.h"

namespace asperity::report {

const ColourScale& ColourScale::viridis() {
  static const ColourScale scale({{68, 1, 84},
                                  {72, 36, 117},
                                  {65, 68, 135},
                                  {53, 95, 141},
                                  {42, 120, 142},
                                  {33, 145, 140},
                                  {34, 168, 132},
                                  {68, 191, 112},
                                  {122, 209, 81},
                                  {189, 223, 38},
                                  {253, 231, 37}});
  return scale;
}

const ColourScale& ColourScale::white_to_red() {
  static const ColourScale scale({{255, 255, 255},
                                  {254, 224, 182},
                                  {253, 184, 99},
                                  {240, 120, 60},
                                  {214, 47, 39},
                                  {150, 10, 30},
                                  {80, 0, 20}});
  return scale;
}

Colour ColourScale::at(double t) const {
  if (std::isnan(t)) return {225, 225, 225};
  const double place = std::clamp(t, 0.0, 1.0) * static_cast<double>(anchors_.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(place), anchors_.size() - 2);
  const double share = place - static_cast<double>(low);
  Colour colour;
  for (int c = 0; c < 3; ++c)
    colour[c] =
        static_cast<std::uint8_t>(std::lround((1 - share) * anchors_[low][c] + share * anchors_[low + 1][c]));
  return colour;
}

std::string hex(const Colour& colour) { return printed("#%02x%02x%02x", colour[0], colour[1], colour[2]); }

std::string line_colour(std::size_t index) {
  static const char* const colours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                        "#e69f00", "#56b4e9", "#7a5195"};
  return colours[index % (sizeof colours / sizeof *colours)];
}

}  // namespace asperity::report

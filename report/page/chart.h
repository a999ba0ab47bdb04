// Curves over axes as inline SVG.
#pragma once

#include <string>
#include <vector>

namespace asperity::report {

/// One entry of the legend. Values that are not finite break the line.
struct Series {
  enum class Style { line, dashed, line_with_points, dashed_with_points, points };
  bool has_points() const {
    return style == Style::line_with_points || style == Style::dashed_with_points || style == Style::points;
  }
  bool is_dashed() const { return style == Style::dashed || style == Style::dashed_with_points; }
  std::string label;  ///< empty: not in the legend
  std::string colour;
  Style style = Style::line;
  std::vector<double> x{}, y{};
  std::vector<double> error{};  ///< half length of error bars; empty, or NaN where there is none
};

struct Chart {
  std::string x_label, y_label;  ///< with units
  std::vector<Series> series{};
  bool y_from_zero = true;
  bool x_from_zero = true;
  /// In the unit of y.
  double band_low = 0, band_high = 0;  ///< a shaded band of y, where band_high > band_low
  std::string band_label{};
  int width = 640, height = 420;
};

/// The chart as an inline SVG element.
std::string to_svg(const Chart& chart);

}  // namespace asperity::report

// Scale and ticks of one axis of a figure.
#pragma once

#include <string>
#include <vector>

namespace asperity::report {

/// A value range mapped to pixels, with round numbers as ticks (steps of 1, 2 or 5 times a power of ten).
struct Axis {
  double low = 0, high = 1;              ///< values
  double pixel_low = 0, pixel_high = 1;  ///< where they lie
  std::vector<double> ticks;

  /// Where a value of the axis' unit lies [pixel].
  double pixel(double value) const {
    return pixel_low + (value - low) / (high - low) * (pixel_high - pixel_low);
  }
};

/// Covers [low, high]; `widen` moves the ends out to the next ticks.
Axis make_axis(double low, double high, double pixel_low, double pixel_high, bool widen, int about_ticks = 6);

/// A tick's label, with as few digits as tell the ticks apart.
/// value in the axis' unit.
std::string tick_label(double value, const Axis& axis);

/// A number for SVG coordinates.
/// In pixels.
std::string coordinate(double value);

/// Text safe inside HTML and SVG.
std::string escaped(const std::string& text);

}  // namespace asperity::report

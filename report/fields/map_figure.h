// A picture over two lengths with axes and a colour bar, as inline SVG around an embedded PNG.
#pragma once

#include <string>
#include <vector>

#include "report/fields/png.h"
#include "report/page/colour_scale.h"

namespace asperity::report {

/// Values on a regular grid, the first row at the bottom; NaN where there is none.
struct Map {
  int nx = 0, ny = 0;
  double x_low = 0, x_high = 0, y_low = 0, y_high = 0;  ///< outer edges in the unit of the axes
  std::vector<double> values;                           ///< [iy * nx + ix]

  /// Largest value, in the map's unit.
  double largest() const;
};

/// Range of colours that leaves the lowest and highest `share` of the values outside of it.
struct ColourRange {
  double low = 0, high = 1;
};
ColourRange colour_range(const Map& map, double share);

struct MapFigure {
  std::string x_label, y_label, colour_label;           ///< with units
  double x_low = 0, x_high = 1, y_low = 0, y_high = 1;  ///< ends of the axes in their units
  const ColourScale* scale = &ColourScale::viridis();
  ColourRange range;
  std::vector<double> circles;  ///< radii around (0, 0), dashed
  std::string circle_label;
  int width = 430;
};

/// The map's pixels in the colours of a scale.
Image paint(const Map& map, const ColourScale& scale, const ColourRange& range);
/// Gives one colour to the pixels whose value is above `threshold`.
/// threshold in the map's unit.
void paint_over(Image& image, const Map& map, double threshold, const Colour& colour);
std::string to_svg(const MapFigure& figure, const Image& image);

}  // namespace asperity::report

#include "report/fields/map_figure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "report/page/axis.h"

namespace asperity::report {
namespace {

std::vector<double> known_values(const Map& map) {
  std::vector<double> known;
  for (const double value : map.values)
    if (std::isfinite(value)) known.push_back(value);
  return known;
}

std::string picture(const Image& image, double left, double top, double width, double height) {
  return "<image x='" + coordinate(left) + "' y='" + coordinate(top) + "' width='" + coordinate(width) +
         "' height='" + coordinate(height) + "' preserveAspectRatio='none' href='" + data_uri(image) + "'/>";
}

std::string frame(double left, double top, double width, double height) {
  return "<rect class='frame' x='" + coordinate(left) + "' y='" + coordinate(top) + "' width='" +
         coordinate(width) + "' height='" + coordinate(height) + "'/>";
}

std::string line_to(double x1, double y1, double x2, double y2) {
  return "<line class='frame' x1='" + coordinate(x1) + "' y1='" + coordinate(y1) + "' x2='" + coordinate(x2) +
         "' y2='" + coordinate(y2) + "'/>";
}

std::string map_text(double x, double y, const std::string& words, const std::string& attributes) {
  return "<text x='" + coordinate(x) + "' y='" + coordinate(y) + "' " + attributes + ">" + escaped(words) +
         "</text>";
}

constexpr double bar_width = 16;

/// The scale of colours with its ticks.
std::string colour_bar(const MapFigure& figure, double left, double top, double height) {
  const Axis bar = make_axis(figure.range.low, figure.range.high, top + height, top, false, 5);
  constexpr int bar_pixels = 128;
  Image shades(1, bar_pixels);
  for (int i = 0; i < bar_pixels; ++i) {
    const Colour colour = figure.scale->at(1 - (i + 0.5) / bar_pixels);
    std::copy(colour.begin(), colour.end(), shades.pixel(0, i));
  }
  std::string svg = picture(shades, left, top, bar_width, height) + frame(left, top, bar_width, height);
  for (const double tick : bar.ticks) {
    svg += line_to(left + bar_width, bar.pixel(tick), left + bar_width + 4, bar.pixel(tick));
    svg += map_text(left + bar_width + 7, bar.pixel(tick) + 4, tick_label(tick, bar), "class='tick'");
  }
  return svg;
}

}  // namespace

double Map::largest() const {
  const auto known = known_values(*this);
  return known.empty() ? std::numeric_limits<double>::quiet_NaN()
                       : *std::max_element(known.begin(), known.end());
}

ColourRange colour_range(const Map& map, double share) {
  auto known = known_values(map);
  if (known.empty()) return {};
  const auto quantile = [&](double q) {
    const auto at = known.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(known.size() - 1));
    std::nth_element(known.begin(), at, known.end());
    return *at;
  };
  const ColourRange range{quantile(share), quantile(1 - share)};
  // Equal heights (a smooth surface) would leave no range at all.
  return range.high > range.low ? range : ColourRange{range.low - 1, range.low + 1};
}

Image paint(const Map& map, const ColourScale& scale, const ColourRange& range) {
  Image image(map.nx, map.ny);
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix) {
      const double value = map.values[static_cast<std::size_t>(iy) * map.nx + ix];
      const Colour colour = scale.at((value - range.low) / (range.high - range.low));
      std::copy(colour.begin(), colour.end(), image.pixel(ix, map.ny - 1 - iy));
    }
  return image;
}

void paint_over(Image& image, const Map& map, double threshold, const Colour& colour) {
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
      if (map.values[static_cast<std::size_t>(iy) * map.nx + ix] > threshold)
        std::copy(colour.begin(), colour.end(), image.pixel(ix, map.ny - 1 - iy));
}

std::string to_svg(const MapFigure& figure, const Image& image) {
  constexpr double left = 58, top = 12, bottom = 46, bar_gap = 16, bar_labels = 62;
  const double width = figure.width - left - bar_gap - bar_width - bar_labels;
  const double height = width * (figure.y_high - figure.y_low) / (figure.x_high - figure.x_low);
  const double bottom_edge = top + height + bottom;
  const Axis x = make_axis(figure.x_low, figure.x_high, left, left + width, false, 5);
  const Axis y =
      make_axis(figure.y_low, figure.y_high, top + height, top, false, height < width * 0.7 ? 4 : 5);
  std::string svg = "<svg class='map' viewBox='0 0 " + std::to_string(figure.width) + " " +
                    coordinate(bottom_edge) + "' role='img' aria-label='" + escaped(figure.colour_label) +
                    "'>";
  svg += picture(image, left, top, width, height);
  for (const double radius : figure.circles)
    svg += "<ellipse cx='" + coordinate(x.pixel(0)) + "' cy='" + coordinate(y.pixel(0)) + "' rx='" +
           coordinate(std::abs(x.pixel(radius) - x.pixel(0))) + "' ry='" +
           coordinate(std::abs(y.pixel(radius) - y.pixel(0))) +
           "' fill='none' stroke='#333' stroke-width='1.3' stroke-dasharray='5 4'><title>" +
           escaped(figure.circle_label) + "</title></ellipse>";
  svg += frame(left, top, width, height);
  for (const double tick : x.ticks) {
    svg += line_to(x.pixel(tick), y.pixel_low, x.pixel(tick), y.pixel_low + 4);
    svg +=
        map_text(x.pixel(tick), y.pixel_low + 17, tick_label(tick, x), "class='tick' text-anchor='middle'");
  }
  for (const double tick : y.ticks) {
    svg += line_to(left - 4, y.pixel(tick), left, y.pixel(tick));
    svg += map_text(left - 7, y.pixel(tick) + 4, tick_label(tick, y), "class='tick' text-anchor='end'");
  }
  svg += map_text(left + width / 2, bottom_edge - 8, figure.x_label, "class='label' text-anchor='middle'");
  const double middle = top + height / 2;
  svg += map_text(13, middle, figure.y_label,
                  "class='label' text-anchor='middle' transform='rotate(-90 13 " + coordinate(middle) + ")'");
  svg += colour_bar(figure, left + width + bar_gap, top, height);
  const double label_x = figure.width - 7;
  svg += map_text(label_x, middle, figure.colour_label,
                  "class='label' text-anchor='middle' transform='rotate(-90 " + coordinate(label_x) + " " +
                      coordinate(middle) + ")'");
  return svg + "</svg>\n";
}

}  // namespace asperity::report

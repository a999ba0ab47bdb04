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
  constexpr double left = 58, top = 12, bottom = 46, bar_gap = 16, bar_width = 16, bar_labels = 62;
  const double picture_width = figure.width - left - bar_gap - bar_width - bar_labels;
  const double picture_height =
      picture_width * (figure.y_high - figure.y_low) / (figure.x_high - figure.x_low);
  const double height = top + picture_height + bottom;
  const auto line_to = [](double x1, double y1, double x2, double y2) {
    return "<line class='frame' x1='" + coordinate(x1) + "' y1='" + coordinate(y1) + "' x2='" +
           coordinate(x2) + "' y2='" + coordinate(y2) + "'/>";
  };
  const auto text = [](double x, double y, const std::string& words, const std::string& attributes) {
    return "<text x='" + coordinate(x) + "' y='" + coordinate(y) + "' " + attributes + ">" + escaped(words) +
           "</text>";
  };
  const Axis x = make_axis(figure.x_low, figure.x_high, left, left + picture_width, false, 5);
  const Axis y = make_axis(figure.y_low, figure.y_high, top + picture_height, top, false,
                           picture_height < picture_width * 0.7 ? 4 : 5);
  std::string svg = "<svg class='map' viewBox='0 0 " + std::to_string(figure.width) + " " +
                    coordinate(height) + "' role='img' aria-label='" + escaped(figure.colour_label) + "'>";
  svg += "<image x='" + coordinate(left) + "' y='" + coordinate(top) + "' width='" +
         coordinate(picture_width) + "' height='" + coordinate(picture_height) +
         "' preserveAspectRatio='none' href='" + data_uri(image) + "'/>";
  for (const double radius : figure.circles)
    svg += "<ellipse cx='" + coordinate(x.pixel(0)) + "' cy='" + coordinate(y.pixel(0)) + "' rx='" +
           coordinate(std::abs(x.pixel(radius) - x.pixel(0))) + "' ry='" +
           coordinate(std::abs(y.pixel(radius) - y.pixel(0))) +
           "' fill='none' stroke='#333' stroke-width='1.3' stroke-dasharray='5 4'><title>" +
           escaped(figure.circle_label) + "</title></ellipse>";
  svg += "<rect class='frame' x='" + coordinate(left) + "' y='" + coordinate(top) + "' width='" +
         coordinate(picture_width) + "' height='" + coordinate(picture_height) + "'/>";
  for (const double tick : x.ticks) {
    svg += line_to(x.pixel(tick), y.pixel_low, x.pixel(tick), y.pixel_low + 4);
    svg += text(x.pixel(tick), y.pixel_low + 17, tick_label(tick, x), "class='tick' text-anchor='middle'");
  }
  for (const double tick : y.ticks) {
    svg += line_to(left - 4, y.pixel(tick), left, y.pixel(tick));
    svg += text(left - 7, y.pixel(tick) + 4, tick_label(tick, y), "class='tick' text-anchor='end'");
  }
  svg += text(left + picture_width / 2, height - 8, figure.x_label, "class='label' text-anchor='middle'");
  const double middle = top + picture_height / 2;
  svg += text(13, middle, figure.y_label,
              "class='label' text-anchor='middle' transform='rotate(-90 13 " + coordinate(middle) + ")'");

  const double bar_left = left + picture_width + bar_gap;
  const Axis bar = make_axis(figure.range.low, figure.range.high, top + picture_height, top, false, 5);
  constexpr int bar_pixels = 128;
  Image shades(1, bar_pixels);
  for (int i = 0; i < bar_pixels; ++i) {
    const Colour colour = figure.scale->at(1 - (i + 0.5) / bar_pixels);
    std::copy(colour.begin(), colour.end(), shades.pixel(0, i));
  }
  svg += "<image x='" + coordinate(bar_left) + "' y='" + coordinate(top) + "' width='" +
         coordinate(bar_width) + "' height='" + coordinate(picture_height) +
         "' preserveAspectRatio='none' href='" + data_uri(shades) + "'/>";
  svg += "<rect class='frame' x='" + coordinate(bar_left) + "' y='" + coordinate(top) + "' width='" +
         coordinate(bar_width) + "' height='" + coordinate(picture_height) + "'/>";
  for (const double tick : bar.ticks) {
    svg += line_to(bar_left + bar_width, bar.pixel(tick), bar_left + bar_width + 4, bar.pixel(tick));
    svg += text(bar_left + bar_width + 7, bar.pixel(tick) + 4, tick_label(tick, bar), "class='tick'");
  }
  const double label_x = figure.width - 7;
  svg += text(label_x, middle, figure.colour_label,
              "class='label' text-anchor='middle' transform='rotate(-90 " + coordinate(label_x) + " " +
                  coordinate(middle) + ")'");
  return svg + "</svg>\n";
}

}  // namespace asperity::report

#include "report/page/chart.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "report/page/axis.h"

namespace asperity::report {
namespace {

constexpr double left_margin = 74, right_margin = 16, top_margin = 14, bottom_margin = 52;
constexpr double legend_line = 20, legend_mark = 28;

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

double error_of(const Series& series, std::size_t i) {
  return i < series.error.size() && std::isfinite(series.error[i]) ? series.error[i] : 0;
}

std::string line(double x1, double y1, double x2, double y2, const std::string& attributes) {
  return "<line x1='" + coordinate(x1) + "' y1='" + coordinate(y1) + "' x2='" + coordinate(x2) + "' y2='" +
         coordinate(y2) + "' " + attributes + "/>";
}

std::string text(double x, double y, const std::string& words, const std::string& attributes) {
  return "<text x='" + coordinate(x) + "' y='" + coordinate(y) + "' " + attributes + ">" + escaped(words) +
         "</text>";
}

std::string frame(const Chart& chart, const Axis& x, const Axis& y) {
  std::string svg;
  for (const double tick : x.ticks) {
    svg += line(x.pixel(tick), y.pixel_low, x.pixel(tick), y.pixel_high, "class='grid'");
    svg += text(x.pixel(tick), y.pixel_low + 19, tick_label(tick, x), "class='tick' text-anchor='middle'");
  }
  for (const double tick : y.ticks) {
    svg += line(x.pixel_low, y.pixel(tick), x.pixel_high, y.pixel(tick), "class='grid'");
    svg += text(x.pixel_low - 8, y.pixel(tick) + 4.5, tick_label(tick, y), "class='tick' text-anchor='end'");
  }
  svg += "<rect class='frame' x='" + coordinate(x.pixel_low) + "' y='" + coordinate(y.pixel_high) +
         "' width='" + coordinate(x.pixel_high - x.pixel_low) + "' height='" +
         coordinate(y.pixel_low - y.pixel_high) + "'/>";
  svg += text((x.pixel_low + x.pixel_high) / 2, chart.height - 10, chart.x_label,
              "class='label' text-anchor='middle'");
  const double middle = (y.pixel_low + y.pixel_high) / 2;
  svg += text(18, middle, chart.y_label,
              "class='label' text-anchor='middle' transform='rotate(-90 18 " + coordinate(middle) + ")'");
  return svg;
}

std::string stroke(const Series& series) {
  return "fill='none' stroke='" + series.colour + "' stroke-width='2' stroke-linejoin='round'" +
         (series.is_dashed() ? " stroke-dasharray='7 5'" : "");
}

std::string dot(double x, double y, const std::string& colour) {
  return "<circle cx='" + coordinate(x) + "' cy='" + coordinate(y) + "' r='3.4' fill='" + colour +
         "' stroke='white' stroke-width='0.8'/>";
}

std::string curve(const Series& series, const Axis& x, const Axis& y) {
  std::string svg, path;
  bool pen_down = false;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    const bool known = std::isfinite(series.x[i]) && std::isfinite(series.y[i]);
    if (known)
      path +=
          (pen_down ? "L" : "M") + coordinate(x.pixel(series.x[i])) + " " + coordinate(y.pixel(series.y[i]));
    pen_down = known;
  }
  if (series.style != Series::Style::points) svg += "<path d='" + path + "' " + stroke(series) + "/>";
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) continue;
    const double px = x.pixel(series.x[i]), error = error_of(series, i);
    if (error > 0) {
      const double up = y.pixel(series.y[i] + error), down = y.pixel(series.y[i] - error);
      const std::string bar = "stroke='" + series.colour + "' stroke-width='1.4'";
      svg += line(px, up, px, down, bar) + line(px - 4, up, px + 4, up, bar) +
             line(px - 4, down, px + 4, down, bar);
    }
    if (series.has_points()) svg += dot(px, y.pixel(series.y[i]), series.colour);
  }
  return svg;
}

constexpr double letter_width = 6.5, padding = 8;

/// Entries of a legend and the room they take.
struct Legend {
  std::vector<const Series*> shown;
  bool has_band = false;
  double entry_width = 0;
  std::size_t size() const { return shown.size() + (has_band ? 1 : 0); }
};

Legend legend_of(const Chart& chart) {
  Legend legend;
  std::size_t longest = 0;
  const auto letters = [](const std::string& label) {  // UTF-8
    return static_cast<std::size_t>(
        std::count_if(label.begin(), label.end(), [](char c) { return (c & 0xC0) != 0x80; }));
  };
  for (const auto& series : chart.series)
    if (!series.label.empty())
      legend.shown.push_back(&series), longest = std::max(longest, letters(series.label));
  legend.has_band = chart.band_high > chart.band_low && !chart.band_label.empty();
  if (legend.has_band) longest = std::max(longest, letters(chart.band_label));
  legend.entry_width = legend_mark + 3 * padding + letter_width * static_cast<double>(longest);
  return legend;
}

/// Points of curves that lie in a rectangle, those between the given ones and the ends of error bars
/// included.
int covered_points(const Chart& chart, const Axis& x, const Axis& y, double left, double top, double width,
                   double height) {
  constexpr int pieces = 8;
  int covered = 0;
  const auto count = [&](double px, double py) {
    covered += px > left - padding && px < left + width + padding && py > top - padding &&
               py < top + height + padding;
  };
  for (const auto& series : chart.series)
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      for (const double sign : {-1.0, 1.0})
        count(x.pixel(series.x[i]), y.pixel(series.y[i] + sign * error_of(series, i)));
      for (int piece = 0; piece < (i + 1 < series.x.size() ? pieces : 1); ++piece) {
        const std::size_t next = std::min(i + 1, series.x.size() - 1);
        const double share = static_cast<double>(piece) / pieces;
        count(x.pixel(series.x[i] + share * (series.x[next] - series.x[i])),
              y.pixel(series.y[i] + share * (series.y[next] - series.y[i])));
      }
    }
  return covered;
}

/// The corner of the frame in which a legend covers nothing; none if there is no such corner.
struct Place {
  double left = 0, top = 0;
};
std::optional<Place> free_corner(const Chart& chart, const Legend& legend, const Axis& x, const Axis& y) {
  const double width = legend.entry_width,
               height = legend_line * static_cast<double>(legend.size()) + padding;
  for (const double top : {y.pixel_high + padding, y.pixel_low - height - padding})
    for (const double left : {x.pixel_low + padding, x.pixel_high - width - padding})
      if (covered_points(chart, x, y, left, top, width, height) == 0) return Place{left, top};
  return std::nullopt;
}

std::string legend_entry(const Series& series, double left, double middle) {
  std::string svg;
  if (series.style != Series::Style::points)
    svg += "<path d='M" + coordinate(left) + " " + coordinate(middle) + "h" + coordinate(legend_mark) + "' " +
           stroke(series) + "/>";
  if (series.has_points()) svg += dot(left + legend_mark / 2, middle, series.colour);
  return svg + text(left + legend_mark + padding, middle + 4.5, series.label, "class='tick'");
}

std::string band_entry(const std::string& label, double left, double middle) {
  return "<rect class='band' x='" + coordinate(left) + "' y='" + coordinate(middle - 6) + "' width='" +
         coordinate(legend_mark) + "' height='12'/>" +
         text(left + legend_mark + padding, middle + 4.5, label, "class='tick'");
}

/// In rows of `columns` entries.
std::string legend_svg(const Chart& chart, const Legend& legend, const Place& place, std::size_t columns) {
  std::string svg;
  for (std::size_t i = 0; i < legend.size(); ++i) {
    const double left = place.left + padding + legend.entry_width * static_cast<double>(i % columns);
    const std::size_t row = i / columns;
    const double middle = place.top + padding / 2 + legend_line * (0.5 + static_cast<double>(row));
    svg += i < legend.shown.size() ? legend_entry(*legend.shown[i], left, middle)
                                   : band_entry(chart.band_label, left, middle);
  }
  return svg;
}

}  // namespace

std::string to_svg(const Chart& chart) {
  Range x_range, y_range;
  for (const auto& series : chart.series)
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      if (!std::isfinite(series.y[i])) continue;
      x_range.add(series.x[i]);
      y_range.add(series.y[i] - error_of(series, i));
      y_range.add(series.y[i] + error_of(series, i));
    }
  if (!std::isfinite(x_range.low) || !std::isfinite(y_range.low))
    return "<p class='note'>There is nothing to draw yet.</p>";
  if (chart.x_from_zero) x_range.add(0);
  if (chart.y_from_zero) y_range.add(0);
  const bool has_band = chart.band_high > chart.band_low;
  if (has_band) y_range.add(chart.band_low), y_range.add(chart.band_high);
  constexpr double room = 0.03;  // curves and bars keep off the frame
  const double margin = room * (y_range.high - y_range.low);
  if (!chart.y_from_zero) y_range.low -= margin;
  y_range.high += margin;
  const Axis x = make_axis(x_range.low, x_range.high, left_margin, chart.width - right_margin, true, 7);
  const Axis y = make_axis(y_range.low, y_range.high, chart.height - bottom_margin, top_margin, true, 6);
  // A legend that would hide curves stands below the chart.
  const Legend legend = legend_of(chart);
  const auto corner = legend.size() ? free_corner(chart, legend, x, y) : std::nullopt;
  const auto columns = std::max<std::size_t>(
      1, static_cast<std::size_t>((chart.width - 2 * padding) / std::max(1.0, legend.entry_width)));
  const std::size_t rows_below = legend.size() && !corner ? (legend.size() + columns - 1) / columns : 0;
  const double height = chart.height + legend_line * static_cast<double>(rows_below);

  std::string svg = "<svg class='chart' viewBox='0 0 " + std::to_string(chart.width) + " " +
                    coordinate(height) + "' role='img' aria-label='" +
                    escaped(chart.y_label + " against " + chart.x_label) + "'>";
  if (has_band)
    svg += "<rect class='band' x='" + coordinate(x.pixel_low) + "' y='" +
           coordinate(y.pixel(chart.band_high)) + "' width='" + coordinate(x.pixel_high - x.pixel_low) +
           "' height='" + coordinate(y.pixel(chart.band_low) - y.pixel(chart.band_high)) + "'/>";
  svg += frame(chart, x, y);
  for (const auto& series : chart.series) svg += curve(series, x, y);
  if (corner) {
    svg += "<rect class='legend' x='" + coordinate(corner->left) + "' y='" + coordinate(corner->top) +
           "' width='" + coordinate(legend.entry_width) + "' height='" +
           coordinate(legend_line * static_cast<double>(legend.size()) + padding) + "' rx='4'/>";
    svg += legend_svg(chart, legend, *corner, 1);
  } else if (legend.size()) {
    svg += legend_svg(chart, legend, {padding, static_cast<double>(chart.height) - padding / 2}, columns);
  }
  return svg + "</svg>\n";
}

}  // namespace asperity::report

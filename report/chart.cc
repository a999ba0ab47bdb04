#include "report/chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "report/axis.h"

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
  return "<text x='" + coordinate(x) + "' y='" + coordinate(y) + "' " + attributes + ">" + escaped(words) + "</text>";
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
  svg += "<rect class='frame' x='" + coordinate(x.pixel_low) + "' y='" + coordinate(y.pixel_high) + "' width='" +
         coordinate(x.pixel_high - x.pixel_low) + "' height='" + coordinate(y.pixel_low - y.pixel_high) + "'/>";
  svg += text((x.pixel_low + x.pixel_high) / 2, chart.height - 10, chart.x_label, "class='label' text-anchor='middle'");
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
      path += (pen_down ? "L" : "M") + coordinate(x.pixel(series.x[i])) + " " + coordinate(y.pixel(series.y[i]));
    pen_down = known;
  }
  if (series.style != Series::Style::points) svg += "<path d='" + path + "' " + stroke(series) + "/>";
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) continue;
    const double px = x.pixel(series.x[i]), error = error_of(series, i);
    if (error > 0) {
      const double up = y.pixel(series.y[i] + error), down = y.pixel(series.y[i] - error);
      const std::string bar = "stroke='" + series.colour + "' stroke-width='1.4'";
      svg += line(px, up, px, down, bar) + line(px - 4, up, px + 4, up, bar) + line(px - 4, down, px + 4, down, bar);
    }
    if (series.has_points()) svg += dot(px, y.pixel(series.y[i]), series.colour);
  }
  return svg;
}

/// The corner of the frame that covers the fewest points.
std::string legend(const Chart& chart, const Axis& x, const Axis& y) {
  std::vector<const Series*> shown;
  std::size_t longest = 0;
  const auto letters = [](const std::string& label) {  // UTF-8
    return static_cast<std::size_t>(std::count_if(label.begin(), label.end(), [](char c) { return (c & 0xC0) != 0x80; }));
  };
  for (const auto& series : chart.series)
    if (!series.label.empty()) shown.push_back(&series), longest = std::max(longest, letters(series.label));
  const bool has_band = chart.band_high > chart.band_low && !chart.band_label.empty();
  if (has_band) longest = std::max(longest, letters(chart.band_label));
  const std::size_t rows = shown.size() + (has_band ? 1 : 0);
  if (rows == 0) return "";
  constexpr double letter_width = 6.9, padding = 8;
  const double width = legend_mark + 3 * padding + letter_width * static_cast<double>(longest);
  const double height = legend_line * static_cast<double>(rows) + padding;
  double best_left = 0, best_top = 0;
  int fewest = std::numeric_limits<int>::max();
  for (const double left : {x.pixel_low + padding, x.pixel_high - width - padding})
    for (const double top : {y.pixel_high + padding, y.pixel_low - height - padding}) {
      int covered = 0;
      for (const auto& series : chart.series)
        for (std::size_t i = 0; i < series.x.size(); ++i) {
          const double px = x.pixel(series.x[i]), py = y.pixel(series.y[i]);
          covered += px > left - padding && px < left + width + padding && py > top - padding && py < top + height + padding;
        }
      if (covered < fewest) fewest = covered, best_left = left, best_top = top;
    }
  std::string svg = "<rect class='legend' x='" + coordinate(best_left) + "' y='" + coordinate(best_top) + "' width='" +
                    coordinate(width) + "' height='" + coordinate(height) + "' rx='4'/>";
  double middle = best_top + padding / 2 + legend_line / 2;
  const double mark = best_left + padding;
  for (const Series* series : shown) {
    if (series->style != Series::Style::points)
      svg += "<path d='M" + coordinate(mark) + " " + coordinate(middle) + "h" + coordinate(legend_mark) + "' " + stroke(*series) + "/>";
    if (series->has_points())
      svg += dot(mark + legend_mark / 2, middle, series->colour);
    svg += text(mark + legend_mark + padding, middle + 4.5, series->label, "class='tick'");
    middle += legend_line;
  }
  if (has_band) {
    svg += "<rect class='band' x='" + coordinate(mark) + "' y='" + coordinate(middle - 6) + "' width='" +
           coordinate(legend_mark) + "' height='12'/>";
    svg += text(mark + legend_mark + padding, middle + 4.5, chart.band_label, "class='tick'");
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
  if (!std::isfinite(x_range.low) || !std::isfinite(y_range.low)) return "<p class='note'>There is nothing to draw yet.</p>";
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
  std::string svg = "<svg class='chart' viewBox='0 0 " + std::to_string(chart.width) + " " + std::to_string(chart.height) +
                    "' role='img' aria-label='" + escaped(chart.y_label + " against " + chart.x_label) + "'>";
  if (has_band)
    svg += "<rect class='band' x='" + coordinate(x.pixel_low) + "' y='" + coordinate(y.pixel(chart.band_high)) + "' width='" +
           coordinate(x.pixel_high - x.pixel_low) + "' height='" +
           coordinate(y.pixel(chart.band_low) - y.pixel(chart.band_high)) + "'/>";
  svg += frame(chart, x, y);
  for (const auto& series : chart.series) svg += curve(series, x, y);
  return svg + legend(chart, x, y) + "</svg>\n";
}

}  // namespace asperity::report

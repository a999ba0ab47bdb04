#include "report/diagnosis/diagnosis_figures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "report/page/axis.h"
#include "report/page/chart.h"
#include "report/page/page.h"

namespace asperity::report {
namespace {

/// More points than a picture can show only make its file large.
constexpr std::size_t most_points = 4000;
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

const char* const recorded_colour = "#8a94a3";
const char* const before_colour = "#d55e00";
const char* const after_colour = "#0072b2";

double largest_of(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  return largest;
}

std::size_t stride_of(const ComparedTable& table) {
  return std::max<std::size_t>(1, table.x.size() / most_points);
}

std::string axis_label(const std::string& channel, const DisplayUnit& unit) {
  return channel_words(channel) + (unit.name.empty() ? "" : " [" + unit.name + "]");
}

/// Lines break where another segment or run begins; rows of a series are points.
Series series_of(const ComparedTable& table, const std::vector<double>& y, double x_factor, double y_factor,
                 bool trace) {
  Series series;
  const std::size_t stride = stride_of(table);
  for (std::size_t i = 0; i < table.x.size(); i += stride) {
    if (trace && i >= stride && table.curve[i] != table.curve[i - stride]) {
      series.x.push_back(nothing);
      series.y.push_back(nothing);
    }
    series.x.push_back(table.x[i] / x_factor);
    series.y.push_back(y[i] / y_factor);
  }
  series.style = trace ? Series::Style::line : Series::Style::points;
  return series;
}

bool is_trace(const ComparedTable& table) { return !table.is_series; }

}  // namespace

DisplayUnit display_unit(const std::string& si, double largest) {
  static const std::vector<std::pair<std::string, double>> prefixes{
      {"G", 1e9}, {"M", 1e6}, {"k", 1e3}, {"", 1}, {"m", 1e-3}, {"µ", 1e-6}, {"n", 1e-9}, {"p", 1e-12}};
  if (si.empty() || si == "rad" || si == "s/m" || !(largest > 0)) return {si, 1};
  for (const auto& [prefix, factor] : prefixes)
    if (largest >= factor) return {prefix + si, factor};
  return {"p" + si, 1e-12};
}

std::string channel_words(const std::string& channel) {
  std::string words = channel == "rms_roughness" ? "RMS roughness" : channel;
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

double residual_limit(const ComparedTable& table) {
  double limit = 4;
  for (std::size_t i = 0; i < table.x.size(); ++i)
    limit = std::max(limit, std::abs(table.recorded[i] - table.before[i]) / table.sd[i]);
  return 1.05 * limit;
}

std::string response_figure(const ComparedTable& table, Beside beside) {
  const DisplayUnit x = display_unit(table.variable_unit, largest_of(table.x)),
                    y = display_unit(table.unit, largest_of(table.recorded));
  Chart chart{axis_label(table.variable, x), axis_label(table.channel, y)};
  chart.x_from_zero = chart.y_from_zero = false;
  Series recorded = series_of(table, table.recorded, x.factor, y.factor, is_trace(table));
  recorded.label = "recorded";
  recorded.colour = recorded_colour;
  Series before = series_of(table, table.before, x.factor, y.factor, is_trace(table));
  before.label = beside == Beside::what_was_left_out ? "simulation as named" : "simulation";
  before.colour = before_colour;
  if (before.style == Series::Style::line) before.style = Series::Style::dashed;
  chart.series = {recorded, before};
  if (beside != Beside::nothing) {
    Series after = series_of(table, table.after, x.factor, y.factor, is_trace(table));
    after.label = beside == Beside::nearest ? "nearest, not named" : "with what was left out";
    after.colour = after_colour;
    chart.series.push_back(after);
  }
  std::string caption = "Grey: what was recorded. Orange: the simulation";
  if (beside == Beside::what_was_left_out)
    caption +=
        " alone, calibrated as it may be. Blue: with the effects named below. The nearer a curve is to grey, "
        "the better.";
  else if (beside == Beside::nearest)
    caption += ", calibrated as it may be. Blue: the nearest that the catalogue has, which is no answer.";
  else
    caption += ", calibrated as it may be.";
  return figure_html("Response", to_svg(chart), caption);
}

std::string residual_figure(const ComparedTable& table, const std::vector<double>& simulated,
                            const std::vector<MismatchRegion>& regions, const std::string& title,
                            double limit) {
  const DisplayUnit x = display_unit(table.variable_unit, largest_of(table.x));
  Chart chart{axis_label(table.variable, x), "(recorded − simulated)/noise"};
  chart.x_from_zero = false;
  chart.band_low = -2;
  chart.band_high = 2;
  chart.band_label = "noise (95 %)";
  Series inside{"", "#b5261e", Series::Style::points}, outside{"", "#5b6675", Series::Style::points};
  const std::size_t stride = std::max<std::size_t>(1, table.x.size() / (most_points / 2));
  for (std::size_t i = 0; i < table.x.size(); i += stride) {
    bool located = false;
    for (const auto& region : regions)
      located =
          located ||
          (region.table == table.table && region.variable == table.variable &&
           (region.segment.empty() || i >= table.segment.size() || table.segment[i] == region.segment) &&
           table.x[i] >= region.from && table.x[i] <= region.to);
    Series& series = located ? inside : outside;
    series.x.push_back(table.x[i] / x.factor);
    series.y.push_back(std::clamp((table.recorded[i] - simulated[i]) / table.sd[i], -limit, limit));
  }
  outside.label = "samples";
  inside.label = "where it is not noise";
  if (!outside.x.empty()) chart.series.push_back(outside);
  if (!inside.x.empty()) chart.series.push_back(inside);
  return figure_html(title, to_svg(chart),
                     "Each dot is a sample: how far it lies from the simulation, in standard deviations of "
                     "the noise. Noise alone keeps 95 % of them in the green band" +
                         std::string(inside.x.empty() ? "." : "; red marks the located mismatch."));
}

}  // namespace asperity::report

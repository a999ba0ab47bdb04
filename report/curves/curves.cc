#include "report/curves/curves.h"

#include <algorithm>
#include <cmath>

#include "core/printed.h"
#include "report/page/colour_scale.h"
#include "report/page/display_units.h"

namespace asperity::report {
namespace {

const std::string hertz_colour = "#555555";
const std::string loading_colour = "#0072b2", unloading_colour = "#d55e00", reloading_colour = "#009e73";

std::vector<double> divided(std::vector<double> values, double unit) {
  for (double& value : values) value /= unit;
  return values;
}

Series hertz_curve(const Hertz& hertz, double largest_approach, const ForceUnit& unit) {
  Series series{"Hertz: smooth, elastic", hertz_colour, Series::Style::dashed, {}, {}, {}};
  constexpr int points = 100;
  for (int i = 0; i <= points; ++i) {
    const double approach = largest_approach * i / points;
    series.x.push_back(approach / nm);
    series.y.push_back(hertz.force(approach) / unit.si);
  }
  return series;
}

/// Adds the way from one step to the next as a contact goes it: approach linear in F^(2/3), a straight line
/// for Hertz.
void add_between(Series& series, double approach0, double force0, double approach1, double force1) {
  constexpr int pieces = 12;
  const double g0 = std::pow(std::max(0.0, force0), 2.0 / 3.0),
               g1 = std::pow(std::max(0.0, force1), 2.0 / 3.0);
  for (int i = 0; i <= pieces; ++i) {
    const double share = static_cast<double>(i) / pieces;
    series.x.push_back(approach0 + share * (approach1 - approach0));
    series.y.push_back(std::pow(g0 + share * (g1 - g0), 1.5));
  }
}

/// Replaces the straight lines between the steps of load-approach curves; the steps themselves stay as
/// points.
std::vector<Series> smoothed(const std::vector<Series>& branches) {
  std::vector<Series> list;
  for (const auto& branch : branches) {
    Series line = branch;
    line.x.clear();
    line.y.clear();
    for (std::size_t i = 0; i + 1 < branch.x.size(); ++i)
      add_between(line, branch.x[i], branch.y[i], branch.x[i + 1], branch.y[i + 1]);
    if (branch.has_points()) {
      line.style = branch.is_dashed() ? Series::Style::dashed : Series::Style::line;
      Series points = branch;
      points.label.clear();
      points.style = Series::Style::points;
      list.push_back(std::move(points));
    }
    list.push_back(std::move(line));
  }
  return list;
}

/// Something of Hertz's as a function of load.
template <class Value>
Series hertz_over_load(double largest_force, const ForceUnit& unit, const Value& value) {
  Series series{"Hertz: smooth, elastic", hertz_colour, Series::Style::dashed, {}, {}, {}};
  constexpr int points = 200;
  for (int i = 1; i <= points; ++i) {
    const double force = largest_force * i / points;
    series.x.push_back(force / unit.si);
    series.y.push_back(value(force));
  }
  return series;
}

std::string branch_name(HistoryBranch::Kind kind, int loadings, int unloadings) {
  if (kind == HistoryBranch::Kind::loading)
    return loadings == 1 ? "loading" : loadings == 2 ? "reloading" : "";
  return unloadings == 1 ? "unloading" : unloadings == 2 ? "second unloading" : "";
}

/// Branches of a history, each as a series of one of its columns.
std::vector<Series> branch_series(const History& history, const std::vector<double>& x,
                                  const std::vector<double>& y) {
  std::vector<Series> list;
  int loadings = 0, unloadings = 0;
  for (const auto& branch : history_branches(history)) {
    if (branch.kind == HistoryBranch::Kind::hold) continue;
    const bool is_loading = branch.kind == HistoryBranch::Kind::loading;
    ++(is_loading ? loadings : unloadings);
    const bool is_first = (is_loading ? loadings : unloadings) == 1;
    Series series{branch_name(branch.kind, loadings, unloadings),
                  is_loading ? (is_first ? loading_colour : reloading_colour) : unloading_colour,
                  !is_first    ? Series::Style::dashed
                  : is_loading ? Series::Style::line_with_points
                               : Series::Style::dashed_with_points,
                  {},
                  {},
                  {}};
    for (std::size_t i = branch.first; i <= branch.last; ++i) {
      series.x.push_back(x[i]);
      series.y.push_back(y[i]);
    }
    list.push_back(std::move(series));
  }
  return list;
}

Series tangent_series(const std::vector<TangentStiffness>& tangents, const ForceUnit& unit,
                      const std::string& label, const std::string& colour, Series::Style style) {
  Series series{label, colour, style, {}, {}, {}};
  for (const auto& tangent : tangents) {
    series.x.push_back(tangent.force / unit.si);
    series.y.push_back(tangent.stiffness / kN_per_m);
    series.error.push_back(tangent.error / kN_per_m);
  }
  return series;
}

double largest_or_zero(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

}  // namespace

ForceUnit force_unit(double largest_force) {
  constexpr double largest_in_micronewton = 5e-3;
  return largest_force > largest_in_micronewton ? ForceUnit{1e-3, "mN"} : ForceUnit{};
}

Chart load_approach_chart(const SolvedCase& solved) {
  const History& history = solved.history;
  const ForceUnit unit = force_unit(largest_or_zero(history.normal_force));
  Chart chart;
  chart.x_label = "approach δ of the bodies [nm]";
  chart.y_label = "normal force F [" + unit.name + "]";
  chart.series = smoothed(branch_series(history, divided(history.normal_displacement, nm),
                                        divided(history.normal_force, unit.si)));
  chart.series.push_back(hertz_curve(solved.hertz(), largest_or_zero(history.normal_displacement), unit));
  return chart;
}

Chart stiffness_chart(const SolvedCase& solved, const NormalNumbers& numbers) {
  const ForceUnit unit = force_unit(numbers.largest_force);
  const Hertz hertz = solved.hertz();
  Chart chart;
  chart.x_label = "normal force F [" + unit.name + "]";
  chart.y_label = "normal stiffness dF/dδ [kN/m]";
  chart.series = {
      tangent_series(numbers.loading, unit, "loading", loading_colour, Series::Style::line_with_points),
      tangent_series(numbers.unloading, unit, "unloading", unloading_colour,
                     Series::Style::dashed_with_points)};
  if (!numbers.reloading.empty())
    chart.series.push_back(
        tangent_series(numbers.reloading, unit, "reloading", reloading_colour, Series::Style::dashed));
  chart.series.push_back(hertz_over_load(
      numbers.largest_force, unit, [&](double force) { return hertz.normal_stiffness(force) / kN_per_m; }));
  const EffectiveNumber elastic = solved.effective("normal_stiffness");
  if (std::isfinite(elastic.value) && elastic.unit == "N/m")
    chart.series.push_back({"elastic, at the largest load",
                            "#111111",
                            Series::Style::points,
                            {numbers.largest_force / unit.si},
                            {elastic.value / kN_per_m},
                            {}});
  chart.width = 520;
  return chart;
}

Chart contact_area_chart(const SolvedCase& solved) {
  const History& history = solved.history;
  const ForceUnit unit = force_unit(largest_or_zero(history.normal_force));
  const Hertz hertz = solved.hertz();
  Chart chart;
  chart.x_label = "normal force F [" + unit.name + "]";
  chart.y_label = "real contact area [µm²]";
  chart.series =
      branch_series(history, divided(history.normal_force, unit.si), divided(history.contact_area, um2));
  chart.series.push_back(hertz_over_load(largest_or_zero(history.normal_force), unit,
                                         [&](double force) { return hertz.contact_area(force) / um2; }));
  chart.width = 520;
  return chart;
}

Chart added_column_chart(const SolvedCase& solved, const AddedValues& column) {
  Chart chart;
  chart.x_label = "step";
  chart.y_label = column.name;
  chart.series = {
      {"", loading_colour, Series::Style::line_with_points, solved.history.step, column.values, {}}};
  chart.y_from_zero = false;
  chart.width = 520;
  return chart;
}

Chart load_approach_chart(const std::vector<StudyCurve>& curves) {
  double force = 0, approach = 0;
  for (const auto& curve : curves) {
    force = std::max(force, curve.last().numbers.force);
    approach = std::max(approach, largest_or_zero(curve.largest->first().history.normal_displacement));
  }
  const ForceUnit unit = force_unit(force);
  Chart chart;
  chart.x_label = "approach δ of the bodies [nm]";
  chart.y_label = "normal force F [" + unit.name + "]";
  for (std::size_t i = 0; i < curves.size(); ++i) {
    bool named = false;
    for (const auto& solved : curves[i].largest->cases) {
      const History& history = solved.history;
      const auto branches = history_branches(history);
      if (branches.empty()) continue;
      // Loading and first unloading; further cycles would hide the difference between the surfaces.
      std::size_t last = branches.front().last;
      for (const auto& branch : branches) {
        last = branch.last;
        if (branch.kind == HistoryBranch::Kind::unloading) break;
      }
      Series series{named ? "" : curves[i].label, line_colour(i), Series::Style::line, {}, {}, {}};
      for (std::size_t row = 0; row < last; ++row)
        add_between(series, history.normal_displacement[row] / nm, history.normal_force[row] / unit.si,
                    history.normal_displacement[row + 1] / nm, history.normal_force[row + 1] / unit.si);
      named = true;
      chart.series.push_back(std::move(series));
    }
  }
  if (!curves.empty())
    chart.series.push_back(hertz_curve(curves.front().last().numbers.hertz, approach, unit));
  return chart;
}

namespace {

/// Means and standard deviations over load, one series per curve.
std::vector<Series> over_load(const std::vector<StudyCurve>& curves, Estimate LoadComparison::*value,
                              double unit, const ForceUnit& force) {
  std::vector<Series> list;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    Series series{curves[i].label, line_colour(i), Series::Style::line_with_points, {}, {}, {}};
    for (const auto& load : curves[i].last().loads) {
      series.x.push_back(load.force / force.si);
      series.y.push_back((load.*value).mean / unit);
      series.error.push_back((load.*value).sd / unit);
    }
    list.push_back(std::move(series));
  }
  return list;
}

double largest_drawn_force(const std::vector<StudyCurve>& curves) {
  double force = 0;
  for (const auto& curve : curves) force = std::max(force, curve.last().numbers.force);
  return force;
}

}  // namespace

Chart ratio_chart(const std::vector<StudyCurve>& curves, Estimate LoadComparison::*ratio,
                  const std::string& label) {
  const ForceUnit unit = force_unit(largest_drawn_force(curves));
  Chart chart;
  chart.x_label = "normal force F [" + unit.name + "]";
  chart.y_label = label;
  chart.band_low = 1 - tolerance;
  chart.band_high = 1 + tolerance;
  chart.band_label = printed("Hertz ± %.3g %%", 100 * tolerance);
  chart.y_from_zero = false;
  chart.width = 520;
  chart.series = over_load(curves, ratio, 1, unit);
  return chart;
}

Chart value_chart(const std::vector<StudyCurve>& curves, Estimate LoadComparison::*value, double unit,
                  const std::string& label, const std::function<double(const Hertz&, double force)>& hertz) {
  const double largest = largest_drawn_force(curves);
  const ForceUnit force = force_unit(largest);
  Chart chart;
  chart.x_label = "normal force F [" + force.name + "]";
  chart.y_label = label;
  chart.width = 520;
  chart.series = over_load(curves, value, unit, force);
  if (!curves.empty())
    chart.series.push_back(hertz_over_load(
        largest, force, [&](double f) { return hertz(curves.front().last().numbers.hertz, f) / unit; }));
  return chart;
}

}  // namespace asperity::report

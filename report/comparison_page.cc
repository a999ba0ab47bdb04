#include "report/comparison_page.h"

#include <cctype>
#include <cstdio>
#include <ctime>
#include <map>
#include <tuple>

#include "report/axis.h"
#include "report/display_units.h"
#include "report/page.h"
#include "report/words.h"

namespace asperity::report {
namespace {

using Rows = std::vector<const ComparisonRow*>;

/// Rows that belong into one figure, in the order in which they come.
std::vector<Rows> grouped(const std::vector<ComparisonRow>& rows) {
  std::vector<Rows> groups;
  std::map<std::tuple<std::string, Quantity, std::string>, std::size_t> known;
  for (const auto& row : rows) {
    const auto [place, added] = known.try_emplace({row.contact, row.quantity, rail_words(row.rail_angle)}, groups.size());
    if (added) groups.emplace_back();
    groups[place->second].push_back(&row);
  }
  return groups;
}

std::string label_of(const std::string& kind, const Rows& rows, const ComparedValue& (*value)(const ComparisonRow&)) {
  for (const auto* row : rows)
    if (value(*row).known() && !value(*row).source.empty()) return kind + ": " + value(*row).source;
  return kind;
}

struct Source {
  const char* kind;
  const char* colour;
  Series::Style style;
  const ComparedValue& (*value)(const ComparisonRow&);
};

const std::vector<Source>& sources() {
  static const std::vector<Source> list{
      {"finite elements", "#0072b2", Series::Style::points, [](const ComparisonRow& r) -> const ComparedValue& { return r.finite_elements; }},
      {"law", "#555555", Series::Style::dashed_with_points, [](const ComparisonRow& r) -> const ComparedValue& { return r.reduced_law; }},
      {"engine", "#009e73", Series::Style::points, [](const ComparisonRow& r) -> const ComparedValue& { return r.engine; }},
      {"published", "#d55e00", Series::Style::points, [](const ComparisonRow& r) -> const ComparedValue& { return r.published; }}};
  return list;
}

std::string value_cell(const ComparedValue& value, double factor) {
  char text[64];
  if (!value.known()) return "–";
  if (std::isfinite(value.sd)) std::snprintf(text, sizeof text, "%.4g ± %.2g", value.value / factor, value.sd / factor);
  else std::snprintf(text, sizeof text, "%.4g", value.value / factor);
  return text;
}

std::string reasons(const Rows& rows) {
  std::string text;
  for (const auto& source : sources()) {
    const ComparedValue& first = source.value(*rows.front());
    if (!first.known() && !first.reason.empty()) text += (text.empty() ? "No value — " : "; ") + std::string(source.kind) + ": " + escaped(first.reason);
  }
  return text.empty() ? "" : note(text + ".");
}

std::string table_of(const Rows& rows) {
  const auto& display = display_of(rows.front()->quantity);
  const std::string unit = std::string(display.unit).empty() ? "" : std::string(" [") + display.unit + "]";
  Table table{{"load [µN]"}, {}, false};
  for (const auto& source : sources()) table.head.push_back(label_of(source.kind, rows, source.value) + unit);
  table.head.push_back("verdict");
  for (const auto* row : rows) {
    char load[32];
    std::snprintf(load, sizeof load, "%.4g", row->load / uN);
    std::vector<std::string> cells{load};
    for (const auto& source : sources()) cells.push_back(value_cell(source.value(*row), display.factor));
    cells.push_back(escaped(row->verdict));
    table.rows.push_back(cells);
  }
  return table_html(table);
}

std::string good_enough(const SideBySide& comparison) {
  Table table{{"simplification", "quantity", "judged by", "good enough"}, {}, true};
  for (const auto& verdict : comparison.verdicts)
    table.rows.push_back({escaped(verdict.law), display_of(verdict.quantity).words + rail_words(verdict.rail_angle), escaped(verdict.reference),
                          verdict.is_own_fit ? "fitted to this measurement: judges nothing" : escaped(good_words(verdict))});
  char title[64];
  std::snprintf(title, sizeof title, "Where each simplification is good within %.3g %%", 100 * comparison.tolerance);
  return section_html(title, table_html(table));
}

}  // namespace

Chart quantity_chart(const Rows& rows) {
  const auto& display = display_of(rows.front()->quantity);
  Chart chart;
  chart.x_label = "load [µN]";
  chart.y_label = std::string(display.words) + (std::string(display.unit).empty() ? "" : std::string(" [") + display.unit + "]");
  // Finite elements last, on top of what agrees with them.
  for (auto next = sources().rbegin(); next != sources().rend(); ++next) {
    const Source& source = *next;
    Series series{label_of(source.kind, rows, source.value), source.colour, source.style, {}, {}, {}};
    for (const auto* row : rows) {
      const ComparedValue& value = source.value(*row);
      if (!value.known()) continue;
      series.x.push_back(row->load / uN);
      series.y.push_back(value.value / display.factor);
      series.error.push_back(value.sd / display.factor);
    }
    if (!series.x.empty()) chart.series.push_back(std::move(series));
  }
  return chart;
}

std::string comparison_page(const SideBySide& comparison) {
  std::vector<std::string> sentences;
  for (const auto& verdict : comparison.verdicts) sentences.push_back(escaped(verdict.text));
  for (const auto& remark : comparison.remarks) sentences.push_back(escaped(remark));
  std::string body = verdict_html("Finite elements, reduced law, engine and measurement side by side", sentences);
  body += good_enough(comparison);
  for (const auto& rows : grouped(comparison.rows)) {
    const auto& display = display_of(rows.front()->quantity);
    const Chart chart = quantity_chart(rows);
    // One load and one value make no figure.
    std::size_t points = 0;
    for (const auto& series : chart.series) points += series.x.size();
    const std::string figure = points < 2 ? "" : figure_html("", to_svg(chart), "Bars are standard deviations where one is known.");
    std::string title = display.words;
    title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
    body += section_html(title + rail_words(rows.front()->rail_angle) + ", " + escaped(rows.front()->contact),
                         figure + table_of(rows) + reasons(rows));
  }
  const std::time_t now = std::time(nullptr);
  char date[64];
  std::strftime(date, sizeof date, "asperity compare, written %Y-%m-%d %H:%M", std::localtime(&now));
  return page_html("Comparison", date, body);
}

}  // namespace asperity::report

#include "report/comparison/comparison_page.h"

#include <algorithm>
#include <cctype>
#include <ctime>
#include <functional>
#include <map>
#include <tuple>

#include "core/printed.h"
#include "report/comparison/comparison_file.h"
#include "report/page/axis.h"
#include "report/page/display_units.h"
#include "report/page/page.h"
#include "report/page/words.h"
#include "report/sentences/phrases.h"
#include "report/sentences/verdict_words.h"

namespace asperity::report {
namespace {

using Rows = std::vector<const ComparisonRow*>;

/// Rows that belong into one figure, in the order in which they come.
std::vector<Rows> grouped(const std::vector<ComparisonRow>& rows) {
  std::vector<Rows> groups;
  std::map<std::tuple<std::string, Quantity, std::string>, std::size_t> known;
  for (const auto& row : rows) {
    const auto [place, added] =
        known.try_emplace({row.contact, row.quantity, rail_words(row.rail_angle)}, groups.size());
    if (added) groups.emplace_back();
    groups[place->second].push_back(&row);
  }
  return groups;
}

std::string label_of(const std::string& kind, const Rows& rows,
                     const ComparedValue& (*value)(const ComparisonRow&)) {
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
      {"finite elements", "#0072b2", Series::Style::points,
       [](const ComparisonRow& r) -> const ComparedValue& { return r.finite_elements; }},
      {"law", "#555555", Series::Style::dashed_with_points,
       [](const ComparisonRow& r) -> const ComparedValue& { return r.reduced_law; }},
      {"engine", "#009e73", Series::Style::points,
       [](const ComparisonRow& r) -> const ComparedValue& { return r.engine; }},
      {"published", "#d55e00", Series::Style::points,
       [](const ComparisonRow& r) -> const ComparedValue& { return r.published; }}};
  return list;
}

bool is_law(const Source& source) { return source.kind == std::string("law"); }

/// Names of the laws among the rows, in the order in which they come.
std::vector<std::string> laws_of(const Rows& rows) {
  std::vector<std::string> laws;
  for (const auto* row : rows)
    if (row->reduced_law.known() &&
        std::find(laws.begin(), laws.end(), row->reduced_law.source) == laws.end())
      laws.push_back(row->reduced_law.source);
  return laws;
}

std::string value_cell(const ComparedValue& value, double factor) {
  if (!value.known()) return "–";
  return printed("%.4g", value.value / factor) +
         (std::isfinite(value.sd) ? printed(" ± %.2g", value.sd / factor) : "");
}

std::string reasons(const Rows& rows) {
  std::string text;
  for (const auto& source : sources()) {
    const ComparedValue& first = source.value(*rows.front());
    if (!first.known() && !first.reason.empty())
      text += (text.empty() ? "No value — " : "; ") + std::string(source.kind) + ": " + escaped(first.reason);
  }
  return text.empty() ? "" : note(text + ".");
}

std::string table_of(const Rows& rows, double tolerance) {
  const auto& display = display_of(rows.front()->quantity);
  const std::string unit = std::string(display.unit).empty() ? "" : std::string(" [") + display.unit + "]";
  Table table{{"load [µN]"}, {}, false};
  for (const auto& source : sources()) {
    // Several laws take turns in the rows.
    if (is_law(source))
      table.head.push_back("reduced law"), table.head.push_back("its value" + unit);
    else
      table.head.push_back(source.kind + unit);
  }
  table.head.push_back("verdict");
  for (const auto* row : rows) {
    std::vector<std::string> cells{printed("%.4g", row->load / uN)};
    for (const auto& source : sources()) {
      if (is_law(source)) cells.push_back(escaped(row->reduced_law.source));
      cells.push_back(value_cell(source.value(*row), display.factor));
    }
    cells.push_back("<span class='wrapped'>" + escaped(row_verdict_text(*row, tolerance)) + "</span>");
    table.rows.push_back(cells);
  }
  return table_html(table);
}

std::string good_enough(const SideBySide& comparison, const std::string& contact) {
  Table table{{"simplification", "quantity", "judged by", "good enough"}};
  for (const auto& verdict : comparison.verdicts)
    if (verdict.contact == contact)
      table.rows.push_back(
          {escaped(verdict.law), display_of(verdict.quantity).words + rail_words(verdict.rail_angle),
           escaped(verdict.reference),
           verdict.is_own_fit ? "fitted to this measurement: judges nothing" : escaped(good_words(verdict))});
  const std::string title = "Where each simplification is good " + within_text(comparison.tolerance);
  return table.rows.empty() ? "" : details_html(title, table_html(table));
}

std::string verdicts_of(const SideBySide& comparison, const std::string& contact) {
  std::string html;
  for (const auto& [reference, headline] : {std::pair{"finite elements", "Against finite elements"},
                                            std::pair{"measurement", "Against the measurement"}}) {
    std::vector<std::string> sentences;
    for (const auto& verdict : comparison.verdicts)
      if (verdict.contact == contact && verdict.reference == reference)
        sentences.push_back(escaped(verdict_text(verdict, comparison.tolerance)));
    if (!sentences.empty()) html += verdict_html(headline, sentences);
  }
  return html;
}

std::string quantity_block(const Rows& rows, double tolerance) {
  const Chart chart = quantity_chart(rows);
  // One load and one value make no figure.
  std::size_t points = 0;
  for (const auto& series : chart.series) points += series.x.size();
  const std::string figure =
      points < 2 ? "" : figure_html("", to_svg(chart), "Bars are standard deviations where one is known.");
  std::string title = display_of(rows.front()->quantity).words;
  title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  return "<h3>" + title + rail_words(rows.front()->rail_angle) + "</h3>\n" + figure +
         table_of(rows, tolerance) + reasons(rows);
}

}  // namespace

Chart quantity_chart(const Rows& rows) {
  const auto& display = display_of(rows.front()->quantity);
  Chart chart{"load [µN]",
              std::string(display.words) +
                  (std::string(display.unit).empty() ? "" : std::string(" [") + display.unit + "]")};
  const auto add = [&](Series series, const Source& source,
                       const std::function<bool(const ComparisonRow&)>& belongs) {
    for (const auto* row : rows) {
      const ComparedValue& value = source.value(*row);
      if (!value.known() || !belongs(*row)) continue;
      series.x.push_back(row->load / uN);
      series.y.push_back(value.value / display.factor);
      series.error.push_back(value.sd / display.factor);
    }
    if (!series.x.empty()) chart.series.push_back(std::move(series));
  };
  // Lines of laws below, finite elements last: on top of what agrees with them.
  for (const auto& source : sources()) {
    if (!is_law(source)) continue;
    const char* colours[] = {source.colour, "#cc79a7", "#b59f00"};
    const std::vector<std::string> laws = laws_of(rows);
    for (std::size_t i = 0; i < laws.size(); ++i)
      add({"law: " + laws[i], colours[i % std::size(colours)], source.style, {}, {}, {}}, source,
          [&](const ComparisonRow& row) { return row.reduced_law.source == laws[i]; });
  }
  for (auto source = sources().rbegin(); source != sources().rend(); ++source)
    if (!is_law(*source))
      add({label_of(source->kind, rows, source->value), source->colour, source->style, {}, {}, {}}, *source,
          [](const ComparisonRow&) { return true; });
  return chart;
}

std::string comparison_page(const SideBySide& comparison) {
  const std::vector<std::string> contacts = contacts_of(comparison);
  std::vector<std::string> sentences;
  for (std::size_t i = 0; i < contacts.size(); ++i)
    sentences.push_back("<a href='#contact-" + std::to_string(i + 1) + "'>" + escaped(contacts[i]) + "</a>");
  const std::string engine = engine_sentence(comparison);
  if (!engine.empty()) sentences.push_back(escaped(engine));
  for (const auto& remark : comparison.remarks) sentences.push_back(escaped(remark));
  std::string body =
      verdict_html("Finite elements, reduced law, engine and measurement side by side", sentences);
  const auto groups = grouped(comparison.rows);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    std::string section = verdicts_of(comparison, contacts[i]) + good_enough(comparison, contacts[i]);
    for (const auto& rows : groups)
      if (rows.front()->contact == contacts[i]) section += quantity_block(rows, comparison.tolerance);
    body += "<a id='contact-" + std::to_string(i + 1) + "'></a>" + section_html(contacts[i], section);
  }
  const std::time_t now = std::time(nullptr);
  char date[64];
  std::strftime(date, sizeof date, "asperity compare, written %Y-%m-%d %H:%M", std::localtime(&now));
  return page_html("Comparison", date, body);
}

}  // namespace asperity::report

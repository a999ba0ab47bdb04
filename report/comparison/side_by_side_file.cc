#include <algorithm>
#include <cmath>

#include "core/csv.h"
#include "core/joined.h"
#include "core/printed.h"
#include "report/comparison/comparison_file.h"
#include "report/page/json_numbers.h"
#include "report/sentences/phrases.h"
#include "report/sentences/verdict_words.h"

namespace asperity::report {
namespace {

using Json = nlohmann::ordered_json;

Json value_json(const ComparedValue& value) {
  if (!value.known()) return {{"value", nullptr}, {"reason", value.reason}};
  return {{"value", value.value}, {"sd", value.sd}, {"source", value.source}};
}

Json row_json(const ComparisonRow& row, double tolerance) {
  const QuantityDisplay& display = display_of(row.quantity);
  Json object{{"contact", row.contact},
              {"mode", name_of(row.mode())},
              {"quantity", display.key},
              {"unit", display.si},
              {"load_N", row.load},
              {"rms_m", row.rms},
              {"rail_angle_rad", row.rail_angle}};
  object["finite_elements"] = value_json(row.finite_elements);
  if (row.finite_elements.known()) {
    object["finite_elements"]["realisations"] = row.finite_elements.realisations;
    object["finite_elements"]["relative_mesh_error"] = row.finite_elements.mesh_error;
  }
  object["reduced_law"] = value_json(row.reduced_law);
  object["engine"] = value_json(row.engine);
  object["published"] = value_json(row.published);
  object["ratios"] = {{"law_over_finite_elements", ratio(row.reduced_law, row.finite_elements)},
                      {"law_over_published", ratio(row.reduced_law, row.published)},
                      {"finite_elements_over_published", ratio(row.finite_elements, row.published)},
                      {"engine_over_law", engine_over_law(row)}};
  object["verdict"] = row_verdict_text(row, tolerance);
  return object;
}

/// Reasons for dashes and sources of numbers, numbered in the order they come up.
class Notes {
 public:
  std::string mark(const std::string& reason) {
    auto found = std::find(reasons_.begin(), reasons_.end(), reason);
    if (found == reasons_.end()) found = reasons_.insert(found, reason);
    return "[" + std::to_string(found - reasons_.begin() + 1) + "]";
  }
  std::string text() const {
    std::string lines;
    for (std::size_t i = 0; i < reasons_.size(); ++i)
      lines += "- [" + std::to_string(i + 1) + "] " + reasons_[i] + "\n";
    return lines;
  }

 private:
  std::vector<std::string> reasons_;
};

std::string cell(const ComparedValue& value, const QuantityDisplay& display, Notes& notes) {
  if (!value.known()) return value.reason.empty() ? "–" : "– " + notes.mark(value.reason);
  constexpr double least_shown = 5e-5;  // of the table's unit: below it, "± 0.0000" says nothing
  const double sd = value.sd / display.factor >= least_shown ? value.sd : NAN;
  return plus_minus(Scatter{1, value.value, sd, NAN}, display.factor);
}

/// Of a ratio: three decimals, two where its sd makes more pointless.
std::string cell(const Uncertain& ratio) {
  if (!std::isfinite(ratio.value)) return "–";
  constexpr double coarse = 0.01, large = 10, least_shown = 5e-4;
  const int decimals = ratio.sd >= coarse || ratio.value >= large ? 2 : 3;
  return printed("%.*f", decimals, ratio.value) +
         (ratio.sd >= least_shown ? printed(" ± %.*f", decimals, ratio.sd) : "");
}

std::string roughness(const ComparisonRow& row) {
  if (std::isnan(row.rms)) return "–";
  if (row.rms == 0) return "smooth";
  constexpr double nm = 1e-9;  // for all, so that rows can be compared at a glance
  return printed("%.3g nm", row.rms / nm);
}

std::string quantity_cell(const ComparisonRow& row) {
  const QuantityDisplay& display = display_of(row.quantity);
  const std::string text = display.words + rail_words(row.rail_angle);
  return *display.unit ? text + " [" + display.unit + "]" : text;
}

std::string contact_table(const std::vector<const ComparisonRow*>& rows, Notes& notes) {
  std::string text =
      "| mode | quantity | load | RMS | finite elements | reduced law | | law / FE | engine | engine / law | "
      "published | law / published |\n"
      "| --- | --- | ---: | ---: | ---: | --- | ---: | ---: | ---: | ---: | ---: | ---: |\n";
  for (const ComparisonRow* row : rows) {
    const QuantityDisplay& display = display_of(row->quantity);
    text += std::string("| ") + name_of(row->mode()) + " | " + quantity_cell(*row) + " | " +
            format_quantity(row->load, Dimension::force) + " | " + roughness(*row) + " | " +
            cell(row->finite_elements, display, notes) + " | " +
            (row->reduced_law.known() ? row->reduced_law.source : "") + " | " +
            cell(row->reduced_law, display, notes) + " | " +
            cell(ratio(row->reduced_law, row->finite_elements)) + " | " + cell(row->engine, display, notes) +
            " | " + cell({engine_over_law(*row), NAN}) + " | " + cell(row->published, display, notes) +
            (row->published.known() ? " " + notes.mark(row->published.source) : "") + " | " +
            cell(ratio(row->reduced_law, row->published)) + " |\n";
  }
  return text;
}

std::string good_table(const std::vector<LawVerdict>& verdicts) {
  std::string text =
      "| simplification | quantity | contact | judged by | good enough |\n| --- | --- | --- | --- | --- |\n";
  std::vector<const LawVerdict*> sorted;
  for (const auto& verdict : verdicts) sorted.push_back(&verdict);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto* a, const auto* b) { return a->quantity < b->quantity; });
  for (const auto* verdict : sorted)
    text += "| " + verdict->law + " | " + display_of(verdict->quantity).words +
            rail_words(verdict->rail_angle) + " | " + verdict->contact + " | " + verdict->reference + " | " +
            good_words(*verdict) + " |\n";
  return text;
}

Json verdict_json(const LawVerdict& verdict, double tolerance) {
  Json object{{"contact", verdict.contact},
              {"mode", name_of(display_of(verdict.quantity).mode)},
              {"quantity", display_of(verdict.quantity).key},
              {"rail_angle_rad", verdict.rail_angle},
              {"law", verdict.law},
              {"against", verdict.reference},
              {"text", verdict_text(verdict, tolerance)},
              {"compared_from_N", verdict.compared.low},
              {"compared_to_N", verdict.compared.high}};
  object["loads_outside"] = verdict.outside;
  object["loads_not_known"] = verdict.not_known;
  object["good_enough"] = Json::array();
  for (const auto& range : verdict.good)
    object["good_enough"].push_back({{"from_N", range.low},
                                     {"to_N", range.high},
                                     {"from_lowest_compared", range.reaches_lowest},
                                     {"to_highest_compared", range.reaches_highest}});
  return object;
}

}  // namespace

std::vector<std::string> contacts_of(const SideBySide& comparison) {
  std::vector<std::string> contacts;
  for (const auto& row : comparison.rows)
    if (std::find(contacts.begin(), contacts.end(), row.contact) == contacts.end())
      contacts.push_back(row.contact);
  return contacts;
}

std::string side_by_side_csv(const SideBySide& comparison) {
  const auto cells = [](const Uncertain& number) {
    return csv_cell(number.value) + "," + csv_cell(number.sd);
  };
  std::string text =
      "contact,mode,quantity,unit,load [N],rms [m],rail_angle "
      "[rad],finite_elements,finite_elements_sd,realisations,mesh_error,law,reduced_law,reduced_law_sd,"
      "engine,published,published_sd,published_source,law_over_finite_elements,law_over_finite_elements_sd,"
      "law_over_published,law_over_published_sd,engine_over_law,verdict\n";
  for (const auto& row : comparison.rows) {
    const QuantityDisplay& display = display_of(row.quantity);
    const auto& fe = row.finite_elements;
    text +=
        joined({csv_cell(row.contact), name_of(row.mode()), display.key, display.si, csv_cell(row.load),
                csv_cell(row.rms), csv_cell(row.rail_angle), cells({fe.value, fe.sd}),
                std::to_string(fe.realisations), csv_cell(fe.mesh_error), csv_cell(row.reduced_law.source),
                cells({row.reduced_law.value, row.reduced_law.sd}), csv_cell(row.engine.value),
                cells({row.published.value, row.published.sd}), csv_cell(row.published.source),
                cells(ratio(row.reduced_law, fe)), cells(ratio(row.reduced_law, row.published)),
                csv_cell(engine_over_law(row)), csv_cell(row_verdict_text(row, comparison.tolerance))},
               ",") +
        "\n";
  }
  return text;
}

Json side_by_side_json(const SideBySide& comparison) {
  Json object{
      {"engine", comparison.engine.empty() ? Json(nullptr) : Json(comparison.engine)},
      {"engine_version", comparison.engine_version},
      {"engine_failure", comparison.engine_failure.empty() ? Json(nullptr) : Json(comparison.engine_failure)},
      {"remarks", comparison.remarks}};
  object["rows"] = Json::array();
  for (const auto& row : comparison.rows) object["rows"].push_back(row_json(row, comparison.tolerance));
  object["verdicts"] = Json::array();
  for (const auto& verdict : comparison.verdicts)
    object["verdicts"].push_back(verdict_json(verdict, comparison.tolerance));
  return object;
}

std::string side_by_side_markdown(const SideBySide& comparison) {
  std::string text = printed(
      "# Side by side: finite elements, reduced laws, engine, measurement\n\n"
      "Tolerance %.3g %%. ± is the standard deviation: over realisations where there are several, otherwise "
      "the solver's own.\n"
      "RMS is the substrate's; the load is the substrate's, in a rail that of each slope. Each engine run "
      "got the law's number\n"
      "beside it. Numbers in [ ] are notes at the end.\n",
      100 * comparison.tolerance);
  Notes notes;
  for (const auto& contact : contacts_of(comparison)) {
    std::vector<const ComparisonRow*> rows;
    for (const auto& row : comparison.rows)
      if (row.contact == contact) rows.push_back(&row);
    text += "\n## " + contact + "\n\n" + contact_table(rows, notes);
    for (const char* reference : {"finite elements", "measurement"}) {
      std::string lines;
      for (const auto& verdict : comparison.verdicts)
        if (verdict.contact == contact && verdict.reference == reference)
          lines += "- " + verdict_text(verdict, comparison.tolerance) + "\n";
      if (!lines.empty())
        text += std::string("\nAgainst ") + (*reference == 'm' ? "the " : "") + reference + ":\n" + lines;
    }
  }
  text += "\n## Where each simplification is good enough\n\n" + good_table(comparison.verdicts);
  text += "\n## Notes\n\n" + notes.text();
  for (const auto& remark : comparison.remarks) text += "- " + remark + "\n";
  const std::string engine = engine_sentence(comparison);
  if (!engine.empty()) text += "\n" + engine;
  return text;
}

}  // namespace asperity::report

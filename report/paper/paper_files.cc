#include "report/paper/paper_files.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/csv.h"
#include "core/joined.h"
#include "core/printed.h"
#include "report/sentences/phrases.h"

namespace asperity::report {
namespace {

std::string with_sd(const std::optional<Uncertain>& number, const DisplayUnit& unit) {
  if (!number) return "";
  return number->has_sd() ? number_text({number->value / unit.factor, number->sd / unit.factor})
                          : printed("%.5g", number->value / unit.factor);
}

std::string sigma(double deviation) { return std::isfinite(deviation) ? printed("%+.2f", deviation) : ""; }

/// Deviations over the published sd, and over both.
std::pair<double, double> deviations(const PaperNumber& n) {
  if (!n.published || !n.computed) return {std::nan(""), std::nan("")};
  return {deviation_in_sigma(*n.computed, *n.published), deviation_in_both_sigmas(*n.computed, *n.published)};
}

/// A curve with its rows thinned to what a screen takes.
std::string curve_text(const PaperCurve& curve) {
  constexpr std::size_t rows_shown = 9;
  std::string text = "\n" + curve.title + " (" + curve.name + ".csv)\n";
  for (std::size_t column = 0; column < curve.columns.size(); ++column)
    text += "  column " + std::to_string(column + 1) + ": " + curve.columns[column] + "\n";
  const std::size_t rows = curve.values.front().size(),
                    step = std::max<std::size_t>(1, (rows - 1) / (rows_shown - 1));
  for (std::size_t row = 0; row < rows; row += step) {
    for (const auto& column : curve.values) text += printed(" %12.5g", column[row]);
    text += "\n";
  }
  return text;
}

}  // namespace

std::string paper_text(const PaperAnalysis& analysis) {
  std::string text =
      "Rolling, sliding and torsion of micron-sized silica particles (Fuchs, Weinhart et al. 2014): "
      "published numbers beside what its inputs give.\nsigma: (computed - published) over the published sd; "
      "both: over that of both.\n";
  const auto line = [](const std::string& what, const std::string& published, const std::string& computed,
                       const char* unit, const std::string& own, const std::string& both) {
    return printed("  %-64s %-22s %-22s %-8s %7s %7s\n", what.c_str(), published.c_str(), computed.c_str(),
                   unit, own.c_str(), both.c_str());
  };
  for (const auto& section : analysis.sections) {
    text += "\n" + section.title + "\n" + line("", "published", "computed", "", "sigma", "both");
    for (const auto& n : section.numbers) {
      const auto [own, both] = deviations(n);
      text += line(n.what, with_sd(n.published, n.unit), with_sd(n.computed, n.unit), n.unit.name, sigma(own),
                   sigma(both));
      if (!n.remark.empty()) text += "      ^ " + n.remark + "\n";
    }
  }
  if (!analysis.curves.empty()) text += "\nCurves of the figures, SI units\n";
  for (const auto& curve : analysis.curves) text += curve_text(curve);
  return text;
}

std::string paper_json(const PaperAnalysis& analysis) {
  using Json = nlohmann::ordered_json;
  const auto number = [](const Uncertain& n) {
    Json json{{"value", n.value}};
    if (n.has_sd()) json["sd"] = n.sd;
    return json;
  };
  Json json;
  json["format"] = "asperity-paper/1";
  json["sections"] = Json::array();
  for (const auto& section : analysis.sections) {
    Json rows = Json::array();
    for (const auto& n : section.numbers) {
      Json row{{"what", n.what}, {"unit", n.unit.si}};
      if (n.published) row["published"] = number(*n.published);
      if (n.computed) row["computed"] = number(*n.computed);
      const auto [own, both] = deviations(n);
      if (std::isfinite(own)) row["deviation_in_sigma"] = own;
      if (std::isfinite(both)) row["deviation_in_both_sigmas"] = both;
      if (!n.remark.empty()) row["remark"] = n.remark;
      rows.push_back(row);
    }
    json["sections"].push_back({{"title", section.title}, {"numbers", rows}});
  }
  json["curves"] = Json::array();
  for (const auto& curve : analysis.curves) {
    Json columns = Json::array();
    for (std::size_t i = 0; i < curve.columns.size(); ++i)
      columns.push_back({{"name", curve.columns[i]}, {"values", curve.values[i]}});
    json["curves"].push_back({{"name", curve.name}, {"title", curve.title}, {"columns", columns}});
  }
  return json.dump(1) + "\n";
}

std::string paper_csv(const PaperSection& section) {
  std::string text =
      "what,unit,published,published_sd,computed,computed_sd,deviation_in_sigma,deviation_in_both_sigmas,"
      "remark\n";
  const auto cells = [](const std::optional<Uncertain>& number) {
    return number ? csv_cell(number->value) + "," + csv_cell(number->sd) : ",";
  };
  for (const auto& n : section.numbers) {
    const auto [own, both] = deviations(n);
    text += joined({csv_cell(n.what), n.unit.si, cells(n.published), cells(n.computed), csv_cell(own),
                    csv_cell(both), csv_cell(n.remark)},
                   ",") +
            "\n";
  }
  return text;
}

}  // namespace asperity::report

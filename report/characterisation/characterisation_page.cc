#include "report/characterisation/characterisation_page.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/joined.h"
#include "core/printed.h"
#include "core/quantity.h"
#include "report/page/axis.h"
#include "report/page/page.h"
#include "report/page/words.h"

namespace asperity::report {
namespace {

/// The dimension of a unit of parameters.json that takes prefixes; none for the others.
Dimension dimension_of(const std::string& unit) {
  for (const Dimension dimension :
       {Dimension::pressure, Dimension::stiffness, Dimension::force, Dimension::length})
    if (unit == si_symbol(dimension)) return dimension;
  return Dimension::none;
}

/// A number with a prefix for its unit, or as a power of ten.
std::string value_text(double value, const std::string& unit) {
  const Dimension dimension = dimension_of(unit);
  if (value == 0) return unit.empty() ? "0" : "0 " + unit;
  if (dimension != Dimension::none) return format_quantity(value, dimension);
  return printed("%.3g", value) + (unit.empty() ? "" : " " + unit);
}

std::string interval_text(const CharacterisedNumber& number) {
  const double half = number.half_width();
  if (!std::isfinite(half)) return "not known";
  return value_text(number.value - half, number.unit) + " to " + value_text(number.value + half, number.unit);
}

/// What the interval does not hold, or how it stands to what was asked.
std::string remark_of(const CharacterisedNumber& number, double accuracy) {
  std::vector<std::string> remarks;
  if (number.is_assumed) return "assumed: one load does not tell it";
  if (number.value == 0) return "none on this mesh, at this load";
  if (std::isfinite(number.local_friction))
    remarks.push_back(printed("follows the local friction of %.3g that went in", number.local_friction) +
                      (number.input_is_known ? "" : ", a guess"));
  const double relative = number.relative_half_width();
  if (relative >= 1)
    remarks.emplace_back("not told from 0, which its interval holds");
  else if (std::isfinite(relative))
    remarks.push_back(printed("±%.2g %%", 100 * relative) +
                      (relative <= accuracy ? "" : printed(", more than the %.3g %% asked", 100 * accuracy)));
  if (!number.holds_scatter) remarks.emplace_back("without the scatter over the surface");
  return joined(remarks, "; ");
}

/// "normal stiffness" of normal_stiffness.
std::string name_of(std::string key) {
  if (key == "pull_off_force") return "pull-off force";
  std::replace(key.begin(), key.end(), '_', ' ');
  return key;
}

std::vector<std::string> names_of(const std::vector<std::string>& keys) {
  std::vector<std::string> names;
  for (const auto& key : keys) names.push_back(name_of(key));
  return names;
}

std::string quantity_text(const CharacterisedNumber& number) {
  return name_of(number.key) +
         (std::isfinite(number.at_load) ? " at " + format_quantity(number.at_load, Dimension::force) : "");
}

Table table_of(const Characterisation& characterisation, double accuracy) {
  Table table{{"quantity", "value", "95 % interval", "remark"}, {}, true};
  for (const auto& number : characterisation.numbers)
    table.rows.push_back({readable(quantity_text(number)), readable(value_text(number.value, number.unit)),
                          readable(interval_text(number)),
                          "<span class='wrapped'>" + readable(remark_of(number, accuracy)) + "</span>"});
  return table;
}

/// What each number means, and which cases it is from.
std::string origins_of(const Characterisation& characterisation) {
  Table table{{"quantity", "meaning and origin"}, {}, true};
  for (const auto& number : characterisation.numbers)
    table.rows.push_back(
        {readable(quantity_text(number)),
         "<span class='wrapped'>" + readable(number.meaning + "; " + number.from) + "</span>"});
  return details_html("What each number means and is from", table_html(table));
}

}  // namespace

std::string characterisation_text(const Characterisation& characterisation, double accuracy) {
  std::vector<std::array<std::string, 4>> rows;
  std::array<std::size_t, 4> widths{};
  for (const auto& number : characterisation.numbers) {
    rows.push_back({quantity_text(number), value_text(number.value, number.unit), interval_text(number),
                    remark_of(number, accuracy)});
    for (std::size_t i = 0; i < 4; ++i) widths[i] = std::max(widths[i], rows.back()[i].size());
  }
  std::string text = characterisation.label.empty() ? "" : characterisation.label + "\n";
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < 3; ++i) text += row[i] + std::string(widths[i] - row[i].size() + 2, ' ');
    text += row[3] + "\n";
  }
  if (!characterisation.not_known.empty())
    text += "not known: " + joined(names_of(characterisation.not_known), ", ") + "\n";
  return text;
}

std::string characterisation_page(const std::vector<Characterisation>& tables,
                                  const CharacterisationText& text) {
  std::string body;
  for (const auto& table : tables) {
    std::string section = table_html(table_of(table, text.accuracy));
    if (!table.not_known.empty())
      section += note("Not known: " + readable(joined(names_of(table.not_known), ", ")) + ".");
    section += origins_of(table);
    body += section_html(table.label.empty() ? "The numbers" : escaped(table.label), section);
  }
  std::string how;
  for (const auto& sentence : text.sentences) how += paragraph(readable(sentence) + ".");
  body += section_html("What they are from", how);
  std::string files;
  for (const auto& file : text.files)
    files += paragraph("<a href='" + escaped(file) + "'>" + escaped(file) + "</a>");
  body += section_html("Files", files);
  return page_html(text.title, "Contact characterised by finite elements", body);
}

}  // namespace asperity::report

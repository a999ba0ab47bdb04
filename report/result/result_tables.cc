#include "report/result/result_tables.h"

#include <cmath>

#include "core/printed.h"
#include "report/curves/curves.h"
#include "report/page/axis.h"
#include "report/page/page.h"
#include "report/page/words.h"
#include "report/sentences/phrases.h"

namespace asperity::report {
namespace {

using Json = nlohmann::ordered_json;

std::string general(double value, int digits = 4) {
  return std::isfinite(value) ? printed("%.*g", digits, value) : "–";
}

std::string spaced(std::string name) {
  for (char& c : name)
    if (c == '_') c = ' ';
  return name;
}

std::string value_in_words(const std::string& name, const Json& value) {
  if (value.is_object() && value.contains("value"))
    return value_in_words(name, value["value"]) +
           (value.contains("unit") ? " " + escaped(value.value("unit", "")) : "");
  if (value.is_number_integer()) return std::to_string(value.get<long long>());
  if (value.is_number()) {
    const double number = value.get<double>();
    if (name.find("wall_time") != std::string::npos || name.find("seconds") != std::string::npos)
      return duration_text(number);
    return general(number, 6);
  }
  if (value.is_string()) return escaped(value.get<std::string>());
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_null()) return "–";
  return escaped(value.dump());
}

void add_rows(Table& table, const std::string& name, const Json& value) {
  if (value.is_object() && !value.contains("value"))
    for (const auto& [part, inner] : value.items())
      add_rows(table, name.empty() ? part : name + ", " + part, inner);
  else
    table.rows.push_back({escaped(spaced(name)), value_in_words(name, value)});
}

/// Memory is written in bytes.
std::string memory_text(double bytes) { return printed("%.3g GiB", bytes / (1024.0 * 1024 * 1024)); }

const char* meaning_of_balance(const std::string& name) {
  if (name == "force") return "contact tractions against the reactions at the supports";
  if (name == "moment") return "moment of the tractions against that of the reactions";
  if (name == "energy") return "work put in, less what is stored and what was dissipated";
  return "";
}

}  // namespace

std::string effective_table(const SolvedCase& solved) {
  if (!solved.finished()) return "";
  Table table{{"effective quantity", "value", "± sd", "unit"}};
  for (const auto& [name, number] : solved.result->effective)
    table.rows.push_back({escaped(spaced(name)), general(number.value, 5),
                          std::isfinite(number.sd) ? general(number.sd, 2) : "–", escaped(number.unit)});
  return table.rows.empty() ? "" : table_html(table);
}

std::string balance_table(const SolvedCase& solved) {
  if (!solved.finished() || solved.result->balance.empty())
    return note("The balances are known when the case is finished.");
  Table table{{"balance", "relative error", "compares"}};
  for (const auto& [name, error] : solved.result->balance)
    table.rows.push_back({escaped(spaced(name)), general(error, 2), meaning_of_balance(name)});
  return table_html(table);
}

std::string balance_sentence(const SolvedCase& solved) {
  if (!solved.finished()) return "";
  std::string parts;
  for (const auto& [name, error] : solved.result->balance)
    if (std::isfinite(error))
      parts += (parts.empty() ? "" : ", ") + spaced(name) + " within " + percent_bound(std::abs(error));
  return parts.empty() ? "" : "The computation balances: " + parts + ".";
}

std::string resolved_roughness_sentence(const SolvedCase& solved, const std::string& body) {
  if (!solved.finished()) return "";
  const std::optional<ResolvedRoughness>& said = solved.result->roughness[body == "particle" ? 0 : 1];
  if (!said) return "";
  const double cells = said->cells_over_shortest_wave, shorter = said->slope_variance_in_shorter_waves,
               period = said->repeats_every;
  const double missed = said->missed_slope_variance;
  constexpr double worth_saying = 0.01;
  std::string text = "Roughness of the " + body + ":";
  if (std::isfinite(cells))
    text += " " + general(cells, 2) + " cells over its shortest wave of " +
            in_units(said->shortest_wave, Dimension::length) + ";";
  text += " the mesh's facets miss " + percent_text(std::isfinite(missed) ? missed : 0) +
          " of its slope variance, so the largest pressures read too small (their ± sd says by how much)";
  if (shorter > worth_saying)
    text += "; waves shorter still, with " + percent_text(shorter) +
            " of the scan's slope variance, are not in the simulation";
  if (std::isfinite(period)) text += "; the surface repeats every " + in_units(period, Dimension::length);
  return text + ".";
}

std::string remaining_tables(const SolvedCase& solved) {
  if (!solved.finished()) return "";
  Table table{{"", ""}};
  for (const auto& [name, value] : solved.result->document.items()) {
    if (name == "inputs" || name == "effective" || name == "balance" || name == "title" ||
        name == "experiment")
      continue;
    if (name == "cost" && value.is_object()) {
      for (const auto& [part, inner] : value.items()) {
        const double number = number_of(inner);
        const bool is_memory =
            part == "peak_memory" && std::isfinite(number) && !(inner.is_object() && inner.contains("unit"));
        table.rows.push_back({"cost, " + escaped(spaced(part)),
                              is_memory ? memory_text(number) : value_in_words(part, inner)});
      }
      continue;
    }
    add_rows(table, name, value);
  }
  table.head.clear();
  return table.rows.empty() ? "" : table_html(table);
}

std::string inputs_table(const SolvedCase& solved) {
  Table table{{"entry of the case file", "value"}};
  for (const auto& [path, text] : solved.entries.all()) table.rows.push_back({escaped(path), escaped(text)});
  std::string entries = details_html("All entries of the case", table_html(table));
  if (!solved.finished() || !solved.result->document.contains("inputs")) return entries;
  Table taken;
  add_rows(taken, "", solved.result->document["inputs"]);
  return entries + details_html("What the solver made of them (SI units), and what its results mean",
                                table_html(taken));
}

std::string ratio_table(const GroupComparison& group) {
  const ForceUnit unit = force_unit(group.numbers.force);
  Table table{
      {"load [" + unit.name + "]", "force / Hertz<br>(same approach)", "stiffness / Hertz<br>(same load)",
       "real contact area / Hertz<br>(same load)", "largest pressure / Hertz<br>(same load)"},
      {},
      false};
  for (const auto& load : group.loads)
    table.rows.push_back({general(load.force / unit.si), ratio_text(load.force_ratio),
                          ratio_text(load.stiffness_ratio), ratio_text(load.area_ratio),
                          ratio_text(load.pressure_ratio)});
  return table_html(table);
}

std::string fit_table(const NormalNumbers& numbers, double true_radius) {
  if (!numbers.has_fits) return note("The first loading has too few steps for a fit (five are needed).");
  constexpr double nm = 1e-9, um = 1e-6;
  const auto with_error = [](const FittedNumber& number, double unit, const std::string& name) {
    return plus_minus({2, number.value, number.standard_error, number.standard_error}, unit, 3) + " " + name;
  };
  Table table{{"what is fitted to the loading curve", "result", "zero of approach", "misfit"}};
  const auto row = [&](const std::string& what, const std::string& result, const FittedNumber& offset,
                       bool has_offset, double rms) {
    table.rows.push_back(
        {what, result, has_offset ? with_error(offset, nm, "nm") : "as computed", percent_text(rms)});
  };
  row("Hertz's law, radius free", with_error(numbers.radius.radius, um, "µm"), {}, false,
      numbers.radius.relative_rms);
  row("Hertz's law, radius and zero free", with_error(numbers.radius_with_offset.radius, um, "µm"),
      numbers.radius_with_offset.offset, true, numbers.radius_with_offset.relative_rms);
  row("power law, exponent free", with_error(numbers.exponent.exponent, 1, ""), {}, false,
      numbers.exponent.relative_rms);
  row("power law, exponent and zero free", with_error(numbers.exponent_with_offset.exponent, 1, ""),
      numbers.exponent_with_offset.offset, true, numbers.exponent_with_offset.relative_rms);
  return table_html(table) +
         note("The sphere of the computation has " + in_units(true_radius, Dimension::length) +
              ", and Hertz's exponent is 1.5. An experimenter who fits Hertz's law to such a curve reads off "
              "the radius given here, not the true one. ± is the standard error of the fit, from its misfit; "
              "misfit is the root mean square over the largest force.");
}

}  // namespace asperity::report

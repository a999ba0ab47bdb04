// A comparison as markdown for people, as JSON and CSV for programs.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "dem_compare/compare/comparison.h"
#include "dem_compare/numbers/json_number.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

Json estimate_json(const Estimate& estimate, const char* unit) {
  Json object{{"value", number_or_null(estimate.mean)},
              {"unit", unit},
              {"sd", number_or_null(estimate.sd)},
              {"standard_error", number_or_null(estimate.standard_error)},
              {"count", estimate.count}};
  if (estimate.mesh)
    object["mesh_error"] = {{"relative", number_or_null(estimate.mesh->relative_error)},
                            {"standard_error", number_or_null(estimate.mesh->standard_error)},
                            {"extrapolated", number_or_null(estimate.mesh->extrapolated)},
                            {"order", estimate.mesh->order},
                            {"order_is_assumed", estimate.mesh->order_is_assumed}};
  return object;
}

/// What is known at a load, as files name it.
struct LoadColumn {
  const char *name, *unit;
  Estimate LoadComparison::*estimate;
};
const std::vector<LoadColumn>& load_columns() {
  static const std::vector<LoadColumn> columns{
      {"approach", "m", &LoadComparison::approach},
      {"stiffness", "N/m", &LoadComparison::stiffness},
      {"unloading_stiffness", "N/m", &LoadComparison::unloading_stiffness},
      {"contact_area", "m^2", &LoadComparison::contact_area},
      {"mean_pressure", "Pa", &LoadComparison::mean_pressure},
      {"largest_pressure", "Pa", &LoadComparison::largest_pressure},
      {"plastic_volume", "m^3", &LoadComparison::plastic_volume},
      {"force_ratio", "1", &LoadComparison::force_ratio},
      {"stiffness_ratio", "1", &LoadComparison::stiffness_ratio},
      {"unloading_stiffness_ratio", "1", &LoadComparison::unloading_ratio},
      {"contact_area_ratio", "1", &LoadComparison::area_ratio},
      {"largest_pressure_ratio", "1", &LoadComparison::pressure_ratio}};
  return columns;
}

Json numbers_json(const GroupNumbers& numbers) {
  return {{"normal_force_N", number_or_null(numbers.force)},
          {"hertz",
           {{"reduced_modulus_Pa", numbers.hertz.reduced_modulus},
            {"radius_m", numbers.hertz.radius},
            {"approach_m", number_or_null(numbers.hertz.approach(numbers.force))},
            {"normal_stiffness_N_per_m", number_or_null(numbers.hertz.normal_stiffness(numbers.force))},
            {"contact_area_m2", number_or_null(numbers.hertz.contact_area(numbers.force))},
            {"peak_pressure_Pa", number_or_null(numbers.hertz.peak_pressure(numbers.force))}}},
          {"approach", estimate_json(numbers.approach, "m")},
          {"loading_stiffness", estimate_json(numbers.loading_stiffness, "N/m")},
          {"unloading_stiffness", estimate_json(numbers.unloading_stiffness, "N/m")},
          {"contact_area", estimate_json(numbers.contact_area, "m^2")},
          {"mean_pressure", estimate_json(numbers.mean_pressure, "Pa")},
          {"largest_pressure", estimate_json(numbers.largest_pressure, "Pa")},
          {"plastic_volume", estimate_json(numbers.plastic_volume, "m^3")},
          {"residual_imprint", estimate_json(numbers.residual_imprint, "m")},
          {"dissipated_energy", estimate_json(numbers.dissipated_energy, "J")},
          {"fitted_radius", estimate_json(numbers.fitted_radius, "m")},
          {"fitted_radius_with_offset", estimate_json(numbers.fitted_radius_with_offset, "m")},
          {"fitted_exponent", estimate_json(numbers.exponent, "1")},
          {"fitted_exponent_with_offset", estimate_json(numbers.exponent_with_offset, "1")},
          {"load_step_error_of_stiffness", number_or_null(numbers.differencing_error)}};
}

const char* word_of(Judged judged) {
  return judged == Judged::within ? "within" : judged == Judged::outside ? "outside" : "not known";
}

Json group_json(const GroupComparison& group) {
  Json object{{"label", group.label},
              {"realisations", group.realisations},
              {"interface_spacing_m", number_or_null(group.interface_spacing)},
              {"is_finest_spacing", group.is_finest},
              {"other_spacings_m", group.other_spacings},
              {"verdict", group.verdict},
              {"is_smooth_control", group.is_control},
              {"as_stiff_as_hertz_at_all_loads", word_of(group.judged_at_all_loads)},
              {"hertzian_from_N", number_or_null(group.hertzian_from)},
              {"at_largest_load", numbers_json(group.numbers)}};
  object["loads"] = Json::array();
  for (const auto& load : group.loads) {
    Json at{{"normal_force_N", load.force}};
    for (const auto& column : load_columns())
      at[column.name] = estimate_json(load.*column.estimate, column.unit);
    at["load_step_error_of_stiffness"] = number_or_null(load.step_error);
    at["stiffness_ratio_half_width"] = number_or_null(load.stiffness_doubt);
    at["as_stiff_as_hertz"] = word_of(load.stiffness_judged);
    object["loads"].push_back(at);
  }
  return object;
}

/// Mean and scatter, and the mesh error, as two cells.
std::string two_cells(const Estimate& estimate, double unit = 1) {
  return plus_minus(estimate, unit) + " | " + mesh_error_text(estimate) + " | ";
}

}  // namespace

std::string plus_minus(const Scatter& scatter, double unit, int digits) {
  if (!std::isfinite(scatter.mean)) return "–";
  // Beyond these decimals of the chosen unit a number is zero to whoever reads the table.
  constexpr int most_decimals = 4;
  if (scatter.mean == 0 && !(scatter.sd > 0)) return "0";
  const double sd = scatter.sd / unit;
  const double mean =
      std::abs(scatter.mean / unit) < 0.5 * std::pow(10, -most_decimals) ? 0.0 : scatter.mean / unit;
  const auto place = [](double x) {
    return x > 0 ? static_cast<int>(std::floor(std::log10(x))) : -most_decimals;
  };
  char buffer[80];
  if (!std::isfinite(sd)) {
    const int decimals = std::clamp(digits - 1 - place(std::abs(mean)), 0, most_decimals);
    std::snprintf(buffer, sizeof buffer, "%.*f", decimals, mean);
    return buffer;
  }
  // As many decimals as show two digits of the scatter, but not more digits of the mean than asked for plus
  // one.
  const int decimals = std::clamp(std::min(1 - place(sd), digits - place(std::abs(mean))), 0, most_decimals);
  std::snprintf(buffer, sizeof buffer, "%.*f ± %.*f", decimals, mean, decimals, sd);
  return buffer;
}

std::string mesh_error_text(const Estimate& estimate) {
  if (!estimate.mesh || !std::isfinite(estimate.mesh->relative_error)) return "–";
  const double error = 100 * estimate.mesh->relative_error, doubt = 100 * estimate.mesh->standard_error;
  constexpr double whole_percents_from = 9.95;
  const int decimals =
      std::max(std::abs(error), std::isfinite(doubt) ? doubt : 0) < whole_percents_from ? 1 : 0;
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%+.*f", decimals, error);
  const bool is_zero = std::strtod(buffer, nullptr) == 0;
  std::string text = (is_zero ? "" : error < 0 ? "−" : "+") + std::string(buffer + 1);
  if (std::isfinite(doubt)) {
    std::snprintf(buffer, sizeof buffer, " ± %.*f", decimals, doubt);
    text += buffer;
  }
  return text + " %";
}

std::string to_csv(const Comparison& comparison) {
  const auto cell = [](double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.9g", value);
    return std::isfinite(value) ? std::string(buffer) : std::string();
  };
  std::string text = "contact,interface_spacing [m],realisations,normal_force [N]";
  for (const auto& column : load_columns()) {
    const std::string name = column.name,
                      unit = std::string(column.unit) == "1" ? "" : " [" + std::string(column.unit) + "]";
    text += "," + name + unit + "," + name + "_sd" + unit + "," + name + "_mesh_error";
  }
  text += ",load_step_error_of_stiffness\n";
  for (const auto& group : comparison.groups)
    for (const auto& load : group.loads) {
      text += "\"" + group.label + "\"," + cell(group.interface_spacing) + "," +
              std::to_string(group.realisations) + "," + cell(load.force);
      for (const auto& column : load_columns()) {
        const Estimate& estimate = load.*column.estimate;
        text += "," + cell(estimate.mean) + "," + cell(estimate.sd) + "," +
                cell(estimate.mesh ? estimate.mesh->relative_error : NAN);
      }
      text += "," + cell(load.step_error) + "\n";
    }
  return text;
}

Json to_json(const Comparison& comparison) {
  Json object{{"format", "asperity-comparison/2"},
              {"title", comparison.title},
              {"tolerance", comparison.tolerance},
              {"cases_planned", comparison.planned}};
  object["missing"] = Json::array();
  for (const auto& missing : comparison.missing)
    object["missing"].push_back(
        {{"name", missing.name}, {"state", missing.state}, {"message", missing.message}});
  object["in_doubt"] = comparison.remarks;
  object["groups"] = Json::array();
  for (const auto& group : comparison.groups) object["groups"].push_back(group_json(group));
  return object;
}

std::string to_markdown(const Comparison& comparison) {
  std::string text =
      "# " + (comparison.title.empty() ? "Comparison" : comparison.title) + ": comparison with Hertz\n\n";
  char buffer[400];
  std::snprintf(buffer, sizeof buffer,
                "Ratios are to Hertz for the same smooth, elastic bodies; tolerance %.3g %%. ± is the "
                "standard deviation\n"
                "over realisations. The mesh error, a number of its own and not contained in ±, is that of "
                "the value before it;\n"
                "its own ± is a standard error.\n",
                100 * comparison.tolerance);
  text += buffer;
  if (!comparison.missing.empty()) {
    text += "\nNot in it (" + std::to_string(comparison.missing.size()) + " of " +
            std::to_string(comparison.planned) + " cases):\n";
    for (const auto& missing : comparison.missing)
      text += "- " + missing.name + ": " + missing.state +
              (missing.message.empty() ? "" : ", " + missing.message) + "\n";
  }
  if (!comparison.remarks.empty()) text += "\nIn doubt:\n";
  for (const auto& remark : comparison.remarks) text += "- " + remark + "\n";
  for (const auto& group : comparison.groups) {
    // Coarser spacings judge the finest; their own numbers are in the JSON and CSV.
    if (!group.is_finest) continue;
    text += "\n## " + group.label + "\n\n" + group.verdict + "\n";
    std::snprintf(buffer, sizeof buffer, "Realisations: %d. ", group.realisations);
    text += std::string("\n") + buffer;
    if (std::isfinite(group.interface_spacing))
      text += "Interface spacing: " + format_quantity(group.interface_spacing, Dimension::length) + ". ";
    if (group.other_spacings.empty()) text += "Mesh error: not known, only one spacing was solved.";
    for (std::size_t i = 0; i < group.other_spacings.size(); ++i)
      text += (i ? ", " : "Mesh error from a comparison with ") +
              format_quantity(group.other_spacings[i], Dimension::length);
    if (group.numbers.loading_stiffness.mesh) {
      std::snprintf(buffer, sizeof buffer, " (order %.2g%s).", group.numbers.loading_stiffness.mesh->order,
                    group.numbers.loading_stiffness.mesh->order_is_assumed ? ", assumed" : ", observed");
      text += buffer;
    }
    constexpr double kN_per_m = 1e3, GPa = 1e9;
    text +=
        "\n\n| load | stiffness [kN/m] | mesh error | over Hertz | unloading [kN/m] | mesh error | force "
        "over Hertz | mesh error |\n"
        "| ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
    for (const auto& load : group.loads)
      text += "| " + format_quantity(load.force, Dimension::force) + " | " +
              two_cells(load.stiffness, kN_per_m) + plus_minus(load.stiffness_ratio) + " | " +
              two_cells(load.unloading_stiffness, kN_per_m) + two_cells(load.force_ratio) + "\n";
    text +=
        "\n| load | real area over Hertz | mesh error | mean pressure [GPa] | mesh error | largest pressure "
        "[GPa] | mesh error |\n"
        "| ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
    for (const auto& load : group.loads)
      text += "| " + format_quantity(load.force, Dimension::force) + " | " + two_cells(load.area_ratio) +
              two_cells(load.mean_pressure, GPa) + two_cells(load.largest_pressure, GPa) + "\n";
  }
  return text;
}

}  // namespace asperity

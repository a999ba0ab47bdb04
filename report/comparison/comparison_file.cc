#include "report/comparison/comparison_file.h"

#include <cmath>

#include "core/csv.h"
#include "core/joined.h"
#include "core/printed.h"
#include "report/sentences/hertz_words.h"
#include "report/sentences/phrases.h"

namespace asperity::report {
namespace {

using Json = nlohmann::ordered_json;

Json estimate_json(const Estimate& estimate, const char* unit) {
  Json object{{"value", estimate.mean},
              {"unit", unit},
              {"sd", estimate.sd},
              {"standard_error", estimate.standard_error},
              {"count", estimate.count}};
  if (estimate.mesh)
    object["mesh_error"] = {{"relative", estimate.mesh->relative_error},
                            {"standard_error", estimate.mesh->standard_error},
                            {"extrapolated", estimate.mesh->extrapolated},
                            {"order", estimate.mesh->order},
                            {"order_is_assumed", estimate.mesh->order_is_assumed}};
  return object;
}

Json numbers_json(const GroupNumbers& numbers) {
  return {{"normal_force_N", numbers.force},
          {"hertz",
           {{"reduced_modulus_Pa", numbers.hertz.reduced_modulus},
            {"radius_m", numbers.hertz.radius},
            {"approach_m", numbers.hertz.approach(numbers.force)},
            {"normal_stiffness_N_per_m", numbers.hertz.normal_stiffness(numbers.force)},
            {"contact_area_m2", numbers.hertz.contact_area(numbers.force)},
            {"peak_pressure_Pa", numbers.hertz.peak_pressure(numbers.force)}}},
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
          {"load_step_error_of_stiffness", numbers.differencing_error}};
}

const char* word_of(Judged judged) {
  return judged == Judged::within ? "within" : judged == Judged::outside ? "outside" : "not known";
}

Json group_json(const GroupComparison& group, double tolerance) {
  Json object{{"label", group.label},
              {"realisations", group.realisations},
              {"interface_spacing_m", group.interface_spacing},
              {"is_finest_spacing", group.is_finest},
              {"other_spacings_m", group.other_spacings},
              {"verdict", verdict_against_hertz(group, tolerance)},
              {"is_smooth_control", group.is_control},
              {"as_stiff_as_hertz_at_all_loads", word_of(group.judged_at_all_loads)},
              {"hertzian_from_N", group.hertzian_from},
              {"at_largest_load", numbers_json(group.numbers)}};
  object["loads"] = Json::array();
  for (const auto& load : group.loads) {
    Json at{{"normal_force_N", load.force}};
    for (const auto& column : load_columns())
      at[column.name] = estimate_json(load.*column.estimate, column.unit);
    at["load_step_error_of_stiffness"] = load.step_error;
    at["stiffness_ratio_half_width"] = load.stiffness_half_width;
    at["as_stiff_as_hertz"] = word_of(load.stiffness_judged);
    object["loads"].push_back(at);
  }
  return object;
}

/// Mean and scatter, and the mesh error, as two cells.
std::string two_cells(const Estimate& estimate, double unit = 1) {
  return plus_minus(estimate, unit) + " | " + mesh_error_text(estimate) + " | ";
}

std::string mesh_sentence(const GroupComparison& group) {
  std::vector<std::string> spacings;
  for (const double spacing : group.other_spacings) spacings.push_back(length_text(spacing));
  const auto& mesh = group.numbers.loading_stiffness.mesh;
  return (spacings.empty() ? "Mesh error: not known, only one spacing was solved."
                           : "Mesh error from a comparison with " + joined(spacings, ", ")) +
         (mesh ? printed(" (order %.2g, %s).", mesh->order, mesh->order_is_assumed ? "assumed" : "observed")
               : "");
}

std::string group_markdown(const GroupComparison& group, double tolerance) {
  std::string text =
      say("\n## {}\n\n{}\n\nRealisations: {}. {}{}",
          {group.label, verdict_against_hertz(group, tolerance), std::to_string(group.realisations),
           std::isfinite(group.interface_spacing)
               ? say("Interface spacing: {}. ", {length_text(group.interface_spacing)})
               : "",
           mesh_sentence(group)});
  constexpr double kN_per_m = 1e3, GPa = 1e9;
  text +=
      "\n\n| load | stiffness [kN/m] | mesh error | over Hertz | unloading [kN/m] | mesh error | force "
      "over Hertz | mesh error |\n"
      "| ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
  for (const auto& load : group.loads)
    text += "| " + force_text(load.force) + " | " + two_cells(load.stiffness, kN_per_m) +
            plus_minus(load.stiffness_ratio) + " | " + two_cells(load.unloading_stiffness, kN_per_m) +
            two_cells(load.force_ratio) + "\n";
  text +=
      "\n| load | real area over Hertz | mesh error | mean pressure [GPa] | mesh error | largest pressure "
      "[GPa] | mesh error |\n"
      "| ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
  for (const auto& load : group.loads)
    text += "| " + force_text(load.force) + " | " + two_cells(load.area_ratio) +
            two_cells(load.mean_pressure, GPa) + two_cells(load.largest_pressure, GPa) + "\n";
  return text;
}

}  // namespace

std::string comparison_csv(const Comparison& comparison) {
  std::string text = "contact,interface_spacing [m],realisations,normal_force [N]";
  for (const auto& column : load_columns()) {
    const std::string unit = std::string(column.unit) == "1" ? "" : say(" [{}]", {column.unit});
    text += say(",{}{},{}_sd{},{}_mesh_error", {column.name, unit, column.name, unit, column.name});
  }
  text += ",load_step_error_of_stiffness\n";
  for (const auto& group : comparison.groups)
    for (const auto& load : group.loads) {
      std::vector<std::string> cells{csv_cell(group.label), csv_cell(group.interface_spacing),
                                     std::to_string(group.realisations), csv_cell(load.force)};
      for (const auto& column : load_columns()) {
        const Estimate& estimate = load.*column.estimate;
        for (const double value :
             {estimate.mean, estimate.sd, estimate.mesh ? estimate.mesh->relative_error : NAN})
          cells.push_back(csv_cell(value));
      }
      cells.push_back(csv_cell(load.step_error));
      text += joined(cells, ",") + "\n";
    }
  return text;
}

Json comparison_json(const Comparison& comparison) {
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
  for (const auto& group : comparison.groups)
    object["groups"].push_back(group_json(group, comparison.tolerance));
  return object;
}

std::string comparison_markdown(const Comparison& comparison) {
  std::string text = say(
      "# {}: comparison with Hertz\n\n"
      "Ratios are to Hertz for the same smooth, elastic bodies; tolerance {} %. ± is the standard deviation\n"
      "over realisations. The mesh error, a number of its own and not contained in ±, is that of the value "
      "before it;\n"
      "its own ± is a standard error.\n",
      {comparison.title.empty() ? "Comparison" : comparison.title,
       printed("%.3g", 100 * comparison.tolerance)});
  if (!comparison.missing.empty())
    text += say("\nNot in it ({} of {} cases):\n",
                {std::to_string(comparison.missing.size()), std::to_string(comparison.planned)});
  for (const auto& missing : comparison.missing)
    text += say("- {}: {}{}\n",
                {missing.name, missing.state, missing.message.empty() ? "" : ", " + missing.message});
  if (!comparison.remarks.empty()) text += "\nIn doubt:\n";
  for (const auto& remark : comparison.remarks) text += "- " + remark + "\n";
  // Coarser spacings judge the finest; their own numbers are in the JSON and CSV.
  for (const auto& group : comparison.groups)
    if (group.is_finest) text += group_markdown(group, comparison.tolerance);
  return text;
}

}  // namespace asperity::report

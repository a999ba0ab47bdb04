// A comparison as markdown for people and as JSON for programs.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "dem_compare/comparison.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json scatter_json(const Scatter& scatter) {
  return {{"value", number(scatter.mean)},
          {"sd", number(scatter.sd)},
          {"standard_error", number(scatter.standard_error)},
          {"count", scatter.count}};
}

Json numbers_json(const GroupNumbers& numbers) {
  const auto with_unit = [](const Scatter& scatter, const char* unit) {
    Json object = scatter_json(scatter);
    object["unit"] = unit;
    return object;
  };
  return {{"normal_force_N", number(numbers.force)},
          {"hertz",
           {{"reduced_modulus_Pa", numbers.hertz.reduced_modulus},
            {"radius_m", numbers.hertz.radius},
            {"approach_m", number(numbers.hertz.approach(numbers.force))},
            {"normal_stiffness_N_per_m", number(numbers.hertz.normal_stiffness(numbers.force))},
            {"contact_area_m2", number(numbers.hertz.contact_area(numbers.force))},
            {"peak_pressure_Pa", number(numbers.hertz.peak_pressure(numbers.force))}}},
          {"approach", with_unit(numbers.approach, "m")},
          {"loading_stiffness", with_unit(numbers.loading_stiffness, "N/m")},
          {"unloading_stiffness", with_unit(numbers.unloading_stiffness, "N/m")},
          {"contact_area", with_unit(numbers.contact_area, "m^2")},
          {"largest_pressure", with_unit(numbers.largest_pressure, "Pa")},
          {"plastic_volume", with_unit(numbers.plastic_volume, "m^3")},
          {"residual_imprint", with_unit(numbers.residual_imprint, "m")},
          {"dissipated_energy", with_unit(numbers.dissipated_energy, "J")},
          {"fitted_radius", with_unit(numbers.fitted_radius, "m")},
          {"fitted_radius_with_offset", with_unit(numbers.fitted_radius_with_offset, "m")},
          {"fitted_exponent", with_unit(numbers.exponent, "1")},
          {"fitted_exponent_with_offset", with_unit(numbers.exponent_with_offset, "1")},
          {"load_step_error_of_stiffness", number(numbers.differencing_error)}};
}

Json group_json(const GroupComparison& group) {
  Json object{{"label", group.label},
              {"realisations", group.realisations},
              {"interface_spacing_m", number(group.interface_spacing)},
              {"verdict", group.verdict},
              {"hertzian_from_N", number(group.hertzian_from)},
              {"at_largest_load", numbers_json(group.numbers)}};
  if (group.mesh)
    object["mesh_error_of_stiffness"] = {{"relative", number(group.mesh->relative_error)},
                                         {"extrapolated_N_per_m", number(group.mesh->extrapolated)},
                                         {"order", group.mesh->order},
                                         {"order_is_assumed", group.mesh->order_is_assumed}};
  object["loads"] = Json::array();
  for (const auto& load : group.loads)
    object["loads"].push_back({{"normal_force_N", load.force},
                               {"force_ratio", scatter_json(load.force_ratio)},
                               {"stiffness_ratio", scatter_json(load.stiffness_ratio)},
                               {"contact_area_ratio", scatter_json(load.area_ratio)},
                               {"largest_pressure_ratio", scatter_json(load.pressure_ratio)}});
  return object;
}

}  // namespace

std::string plus_minus(const Scatter& scatter, double unit, int digits) {
  if (!std::isfinite(scatter.mean)) return "–";
  // Beyond these decimals of the chosen unit a number is zero to whoever reads the table.
  constexpr int most_decimals = 4;
  const double sd = scatter.sd / unit;
  const double mean = std::abs(scatter.mean / unit) < 0.5 * std::pow(10, -most_decimals) ? 0.0 : scatter.mean / unit;
  const auto place = [](double x) { return x > 0 ? static_cast<int>(std::floor(std::log10(x))) : -most_decimals; };
  char buffer[80];
  if (!std::isfinite(sd)) {
    const int decimals = std::clamp(digits - 1 - place(std::abs(mean)), 0, most_decimals);
    std::snprintf(buffer, sizeof buffer, "%.*f", decimals, mean);
    return buffer;
  }
  // As many decimals as show two digits of the scatter, but not more digits of the mean than asked for plus one.
  const int decimals = std::clamp(std::min(1 - place(sd), digits - place(std::abs(mean))), 0, most_decimals);
  std::snprintf(buffer, sizeof buffer, "%.*f ± %.*f", decimals, mean, decimals, sd);
  return buffer;
}

Json to_json(const Comparison& comparison) {
  Json object{{"format", "asperity-comparison/1"},
              {"title", comparison.title},
              {"tolerance", comparison.tolerance},
              {"cases_planned", comparison.planned}};
  object["missing"] = Json::array();
  for (const auto& missing : comparison.missing)
    object["missing"].push_back({{"name", missing.name}, {"state", missing.state}, {"message", missing.message}});
  object["groups"] = Json::array();
  for (const auto& group : comparison.groups) object["groups"].push_back(group_json(group));
  return object;
}

std::string to_markdown(const Comparison& comparison) {
  std::string text = "# " + (comparison.title.empty() ? "Comparison" : comparison.title) + ": comparison with Hertz\n\n";
  char buffer[200];
  std::snprintf(buffer, sizeof buffer, "Ratios to Hertz for the same smooth, elastic bodies; tolerance %.3g %%. "
                "± is the standard deviation over realisations; the mesh error is a number of its own.\n",
                100 * comparison.tolerance);
  text += buffer;
  if (!comparison.missing.empty()) {
    text += "\nNot in it (" + std::to_string(comparison.missing.size()) + " of " + std::to_string(comparison.planned) +
            " cases):\n";
    for (const auto& missing : comparison.missing)
      text += "- " + missing.name + ": " + missing.state + (missing.message.empty() ? "" : ", " + missing.message) + "\n";
  }
  for (const auto& group : comparison.groups) {
    text += "\n## " + group.label + "\n\n" + group.verdict + "\n";
    std::snprintf(buffer, sizeof buffer, "Realisations: %d. ", group.realisations);
    text += std::string("\n") + buffer;
    if (std::isfinite(group.interface_spacing))
      text += "Interface spacing: " + format_quantity(group.interface_spacing, Dimension::length) + ". ";
    if (group.mesh) {
      std::snprintf(buffer, sizeof buffer, "Mesh error of the stiffness: %+.2g %% (order %.2g%s).",
                    100 * group.mesh->relative_error, group.mesh->order,
                    group.mesh->order_is_assumed ? ", assumed" : ", observed");
      text += buffer;
    } else {
      text += "Mesh error: not known, only one spacing was solved.";
    }
    text += "\n\n| load | force ratio | stiffness ratio | real contact area ratio | largest pressure ratio |\n"
            "| ---: | ---: | ---: | ---: | ---: |\n";
    for (const auto& load : group.loads)
      text += "| " + format_quantity(load.force, Dimension::force) + " | " + plus_minus(load.force_ratio) + " | " +
              plus_minus(load.stiffness_ratio) + " | " + plus_minus(load.area_ratio) + " | " +
              plus_minus(load.pressure_ratio) + " |\n";
  }
  return text;
}

}  // namespace asperity

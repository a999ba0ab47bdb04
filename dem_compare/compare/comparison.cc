#include "dem_compare/compare/comparison.h"

#include <algorithm>
#include <cmath>

#include "dem_compare/cases/path_averages.h"
#include "dem_compare/compare/mesh_family.h"
#include "dem_compare/numbers/statistics.h"

namespace asperity {
namespace {

GroupNumbers numbers_of(const CaseGroup& group, const MeshFamily& family) {
  GroupNumbers result;
  result.hertz = group.first().hertz();
  const auto estimate = [&](const auto& number) { return family.estimate(number); };
  const auto at_largest = [&](double LoadPoint::*member) {
    return family.estimate(
        [member](const NormalNumbers& n) { return n.loads.empty() ? unknown : n.loads.back().*member; });
  };
  const auto fitted = [&](const auto& number) {
    return family.estimate([&](const NormalNumbers& n) { return n.has_fits ? number(n) : unknown; });
  };
  result.force = estimate([](const auto& n) { return n.largest_force; }).mean;
  result.approach = estimate([](const auto& n) { return n.approach_there; });
  result.loading_stiffness = estimate([](const auto& n) { return n.loading_stiffness(); });
  result.unloading_stiffness = estimate([](const auto& n) { return n.unloading_stiffness(); });
  result.contact_area = at_largest(&LoadPoint::contact_area);
  result.mean_pressure = at_largest(&LoadPoint::mean_pressure);
  result.largest_pressure = at_largest(&LoadPoint::largest_pressure);
  result.plastic_volume = estimate([](const auto& n) { return n.plastic_volume; });
  result.residual_imprint = estimate([](const auto& n) { return n.residual_imprint; });
  result.dissipated_energy = estimate([](const auto& n) { return n.dissipated_energy; });
  result.fitted_radius = fitted([](const auto& n) { return n.radius.radius.value; });
  result.fitted_radius_with_offset = fitted([](const auto& n) { return n.radius_with_offset.radius.value; });
  result.exponent = fitted([](const auto& n) { return n.exponent.exponent.value; });
  result.exponent_with_offset = fitted([](const auto& n) { return n.exponent_with_offset.exponent.value; });
  for (const auto& numbers : group.numbers)
    if (!numbers.loading.empty() && std::isfinite(numbers.loading.back().error))
      result.differencing_error = std::max(result.differencing_error,
                                           numbers.loading.back().error / numbers.loading.back().stiffness);
  return result;
}

/// Two relative standard deviations of the stiffness as `solve` states them for its mesh, the largest of the
/// cases; NaN without any.
double own_discretisation_error(const CaseGroup& group) {
  double largest = unknown;
  for (const auto& solved : group.cases) {
    const auto stiffness = solved.effective("normal_stiffness");
    if (stiffness.value > 0 && stiffness.sd >= 0)
      largest = std::fmax(largest, 2 * stiffness.sd / stiffness.value);
  }
  return largest;
}

/// Half width of the interval of a ratio: the scatter of its mean, what the mesh leaves open (from several
/// spacings, else as `solve` states it), and a relative bound from the steps. NaN where neither scatter nor
/// mesh is known.
double half_width_of(const Estimate& ratio, double own_error, double step_error) {
  const double of_mean =
      ratio.count > 1 ? 2 * student_factor(ratio.count - 1) * ratio.standard_error : unknown;
  const double of_mesh =
      std::abs(ratio.mean) * (ratio.mesh ? std::abs(ratio.mesh->relative_error) : own_error);
  if (!std::isfinite(of_mean) && !std::isfinite(of_mesh))
    return step_error > 0 ? step_error * std::abs(ratio.mean) : unknown;
  const auto known = [](double doubt) { return std::isfinite(doubt) ? doubt : 0; };
  return known(of_mean) + known(of_mesh) + step_error * std::abs(ratio.mean);
}

LoadComparison at_load(double force, const CaseGroup& group, const MeshFamily& family, double tolerance) {
  LoadComparison load;
  load.force = force;
  for (const auto& column : load_columns())
    load.*column.estimate =
        family.estimate([&](const NormalNumbers& n) { return n.at_load(force, column.of_case); });
  for (const auto& numbers : group.numbers) {
    const double error =
        numbers.at_load(force, &LoadPoint::step_error) / numbers.at_load(force, &LoadPoint::stiffness);
    if (std::isfinite(error)) load.step_error = std::max(load.step_error, error);
  }
  const double own = own_discretisation_error(group);
  load.stiffness_half_width = half_width_of(load.stiffness_ratio, own, load.step_error);
  load.unloading_half_width = half_width_of(load.unloading_ratio, own, load.step_error);
  load.force_half_width = half_width_of(load.force_ratio, unknown, 0);
  load.stiffness_judged = judged(load.stiffness_ratio.mean - 1, load.stiffness_half_width, tolerance);
  return load;
}

void judge_all_loads(GroupComparison& group) {
  const auto is = [](Judged judged) {
    return [judged](const LoadComparison& load) { return load.stiffness_judged == judged; };
  };
  const auto& loads = group.loads;
  group.judged_at_all_loads = std::any_of(loads.begin(), loads.end(), is(Judged::outside)) ? Judged::outside
                              : !loads.empty() && std::all_of(loads.begin(), loads.end(), is(Judged::within))
                                  ? Judged::within
                                  : Judged::not_known;
  group.hertzian_from = unknown;
  for (auto load = loads.rbegin(); load != loads.rend() && load->stiffness_judged == Judged::within; ++load)
    group.hertzian_from = load->force;
}

bool is_smooth_control(const CaseGroup& group, double force) {
  return !group.first().is_rough() && force < group.first().first_yield_force();
}

}  // namespace

const std::vector<LoadColumn>& load_columns() {
  using Load = LoadComparison;
  using Point = LoadPoint;
  static const std::vector<LoadColumn> columns{
      {"approach", "m", &Load::approach, &Point::approach},
      {"stiffness", "N/m", &Load::stiffness, &Point::stiffness},
      {"unloading_stiffness", "N/m", &Load::unloading_stiffness, &Point::unloading_stiffness},
      {"contact_area", "m^2", &Load::contact_area, &Point::contact_area},
      {"mean_pressure", "Pa", &Load::mean_pressure, &Point::mean_pressure},
      {"largest_pressure", "Pa", &Load::largest_pressure, &Point::largest_pressure},
      {"plastic_volume", "m^3", &Load::plastic_volume, &Point::plastic_volume},
      {"force_ratio", "1", &Load::force_ratio, &Point::force_ratio},
      {"stiffness_ratio", "1", &Load::stiffness_ratio, &Point::stiffness_ratio},
      {"unloading_stiffness_ratio", "1", &Load::unloading_ratio, &Point::unloading_ratio},
      {"contact_area_ratio", "1", &Load::area_ratio, &Point::area_ratio},
      {"largest_pressure_ratio", "1", &Load::pressure_ratio, &Point::pressure_ratio}};
  return columns;
}

Comparison compare_with_hertz(const CaseCollection& collection, double tolerance) {
  Comparison comparison{collection.title,   tolerance,          {},
                        collection.missing, collection.remarks, collection.planned};
  for (const auto& group : collection.groups) {
    GroupComparison result;
    result.label = group.label;
    result.values = group.values;
    result.realisations = static_cast<int>(group.cases.size());
    result.interface_spacing = group.first().interface_spacing();
    const MeshFamily family(collection, group);
    result.other_spacings = family.other_spacings();
    result.is_finest = family.own_is_finest();
    result.numbers = numbers_of(group, family);
    for (const auto& point : group.numbers.front().loads)
      result.loads.push_back(at_load(point.force, group, family, tolerance));
    judge_all_loads(result);
    result.is_control = is_smooth_control(group, result.numbers.force);
    comparison.groups.push_back(std::move(result));
  }
  return comparison;
}

}  // namespace asperity

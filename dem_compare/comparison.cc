#include "dem_compare/comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "dem_compare/mesh_family.h"
#include "dem_compare/statistics.h"

namespace asperity {
namespace {

GroupNumbers numbers_of(const CaseGroup& group, const MeshFamily& family) {
  GroupNumbers result;
  result.hertz = group.first().hertz();
  const auto estimate = [&](const auto& number) { return family.estimate(number); };
  const auto at_largest = [&](double LoadPoint::*member) {
    return family.estimate([member](const NormalNumbers& n) { return n.loads.empty() ? unknown : n.loads.back().*member; });
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
      result.differencing_error =
          std::max(result.differencing_error, numbers.loading.back().error / numbers.loading.back().stiffness);
  return result;
}

LoadComparison at_load(double force, const CaseGroup& group, const MeshFamily& family) {
  const auto estimate = [&](double LoadPoint::*member) {
    return family.estimate([=](const NormalNumbers& n) { return n.at_load(force, member); });
  };
  LoadComparison load;
  load.force = force;
  load.approach = estimate(&LoadPoint::approach);
  load.stiffness = estimate(&LoadPoint::stiffness);
  load.unloading_stiffness = estimate(&LoadPoint::unloading_stiffness);
  load.contact_area = estimate(&LoadPoint::contact_area);
  load.mean_pressure = estimate(&LoadPoint::mean_pressure);
  load.largest_pressure = estimate(&LoadPoint::largest_pressure);
  load.plastic_volume = estimate(&LoadPoint::plastic_volume);
  load.force_ratio = estimate(&LoadPoint::force_ratio);
  load.stiffness_ratio = estimate(&LoadPoint::stiffness_ratio);
  load.unloading_ratio = estimate(&LoadPoint::unloading_ratio);
  load.area_ratio = estimate(&LoadPoint::area_ratio);
  load.pressure_ratio = estimate(&LoadPoint::pressure_ratio);
  for (const auto& numbers : group.numbers) {
    const double error = numbers.at_load(force, &LoadPoint::step_error) / numbers.at_load(force, &LoadPoint::stiffness);
    if (std::isfinite(error)) load.step_error = std::max(load.step_error, error);
  }
  return load;
}

double hertzian_from(const std::vector<LoadComparison>& loads, double tolerance) {
  const auto departure = [&](std::size_t i) { return std::abs(loads[i].stiffness_ratio.mean - 1); };
  std::size_t first_within = loads.size();
  while (first_within > 0 && departure(first_within - 1) <= tolerance) --first_within;
  if (first_within == loads.size()) return unknown;
  if (first_within == 0) return loads.front().force;
  // Between the last load outside and the first within: linear in the logarithm of load.
  const double outside = departure(first_within - 1), within = departure(first_within);
  const double share = (outside - tolerance) / (outside - within);
  return loads[first_within - 1].force * std::pow(loads[first_within].force / loads[first_within - 1].force, share);
}

/// Of a ratio, how far it is from 1.
std::string percent_off_one(double ratio) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.2g %%", 100 * std::abs(ratio - 1));
  return buffer;
}

std::string rounded_force(double force) { return format_quantity(force, Dimension::force, 3); }

std::string stiffness_sentence(const GroupComparison& group, double tolerance) {
  if (group.loads.empty() || std::isnan(group.loads.back().stiffness_ratio.mean))
    return "too few load steps to judge (three are needed).";
  const auto& low = group.loads.front();
  const auto& high = group.loads.back();
  const auto softer = [](double ratio) { return ratio < 1 ? std::string("softer") : std::string("stiffer"); };
  const std::string within = percent_off_one(1 + tolerance);
  if (std::isnan(group.hertzian_from))
    return softer(high.stiffness_ratio.mean) + " than Hertz by " + percent_off_one(high.stiffness_ratio.mean) +
           " still at " + rounded_force(high.force) + " (" + percent_off_one(low.stiffness_ratio.mean) + " " +
           softer(low.stiffness_ratio.mean) + " at " + rounded_force(low.force) + ").";
  if (group.hertzian_from <= low.force)
    return "as stiff as Hertz within " + within + " from " + rounded_force(low.force) + " to " + rounded_force(high.force) + ".";
  return softer(low.stiffness_ratio.mean) + " than Hertz by " + percent_off_one(low.stiffness_ratio.mean) + " at " +
         rounded_force(low.force) + ", within " + within + " from " + rounded_force(group.hertzian_from) + " on.";
}

/// The verdict is on means: says so where single surfaces scatter by more than the tolerance.
std::string scatter_sentence(const GroupComparison& group, double tolerance) {
  const LoadComparison* worst = nullptr;
  for (const auto& load : group.loads)
    if (load.stiffness_ratio.sd > (worst ? worst->stiffness_ratio.sd : tolerance)) worst = &load;
  if (!worst) return "";
  return " That is the mean; single realisations scatter about it by up to " + percent_off_one(1 + worst->stiffness_ratio.sd) +
         " (at " + rounded_force(worst->force) + ").";
}

/// Not so if it is negative: the extrapolation of the first loading to zero is no better than that.
bool is_told_from_its_errors(const Estimate& imprint) {
  const double mesh = imprint.mesh ? std::abs(imprint.mean - imprint.mesh->extrapolated) : 0;
  return imprint.mean > 0 && !(imprint.mean <= imprint.sd) && imprint.mean > mesh;
}

std::string verdict_of(const GroupComparison& group, double tolerance) {
  std::string words = "Loading: " + stiffness_sentence(group, tolerance) + scatter_sentence(group, tolerance);
  const GroupNumbers& numbers = group.numbers;
  if (!group.loads.empty()) {
    const double ratio = group.loads.back().force_ratio.mean;
    words += " Force at the same approach is " +
             (std::abs(ratio - 1) <= tolerance ? "Hertz's within " + percent_off_one(1 + tolerance)
                                               : percent_off_one(ratio) + (ratio < 1 ? " below" : " above") + " Hertz's") +
             " at " + rounded_force(numbers.force) + ".";
  }
  const double unloading = numbers.unloading_stiffness.mean / numbers.hertz.normal_stiffness(numbers.force);
  if (std::isfinite(unloading))
    words += " Unloading starts " +
             (std::abs(unloading - 1) <= tolerance ? "as stiff as Hertz within " + percent_off_one(1 + tolerance)
                                                   : percent_off_one(unloading) + (unloading < 1 ? " softer" : " stiffer") +
                                                         " than Hertz") +
             ".";
  if (numbers.plastic_volume.mean > 0) {
    words += " Material yielded";
    if (std::isfinite(numbers.residual_imprint.mean))
      words += is_told_from_its_errors(numbers.residual_imprint)
                   ? "; an imprint of " + format_quantity(numbers.residual_imprint.mean, Dimension::length, 3) + " stays"
                   : "; its imprint is too small to be told from scatter and mesh error";
    words += ".";
  }
  return words;
}

}  // namespace

Comparison compare_with_hertz(const CaseCollection& collection, double tolerance) {
  Comparison comparison{collection.title, tolerance, {}, collection.missing, collection.planned};
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
    for (const auto& point : group.numbers.front().loads) result.loads.push_back(at_load(point.force, group, family));
    result.hertzian_from = hertzian_from(result.loads, tolerance);
    result.verdict = verdict_of(result, tolerance);
    comparison.groups.push_back(std::move(result));
  }
  return comparison;
}

}  // namespace asperity

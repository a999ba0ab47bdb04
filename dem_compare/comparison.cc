#include "dem_compare/comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace asperity {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// A ratio at a load, linear between the steps; NaN outside of them.
double ratio_at(const std::vector<HertzRatios>& ratios, double force, double HertzRatios::*member) {
  const double tolerance = 1e-6 * force;  // a step's own load but for rounding
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    if (std::abs(ratios[i].force - force) <= tolerance) return ratios[i].*member;
    if (i + 1 < ratios.size() && ratios[i].force < force && force < ratios[i + 1].force) {
      const double share = (force - ratios[i].force) / (ratios[i + 1].force - ratios[i].force);
      return ratios[i].*member + share * (ratios[i + 1].*member - ratios[i].*member);
    }
  }
  return unknown;
}

Scatter over_realisations(const CaseGroup& group, double force, double HertzRatios::*member) {
  std::vector<double> values;
  for (const auto& numbers : group.numbers) values.push_back(ratio_at(numbers.ratios, force, member));
  return scatter_of(values);
}

template <class Value>
Scatter over_cases(const CaseGroup& group, const Value& value) {
  std::vector<double> values;
  for (const auto& numbers : group.numbers) values.push_back(value(numbers));
  return scatter_of(values);
}

GroupNumbers numbers_of(const CaseGroup& group) {
  GroupNumbers result;
  result.hertz = group.first().hertz();
  result.force = over_cases(group, [](const auto& n) { return n.largest_force; }).mean;
  result.approach = over_cases(group, [](const auto& n) { return n.approach_there; });
  result.loading_stiffness = over_cases(group, [](const auto& n) { return n.loading_stiffness(); });
  result.unloading_stiffness = over_cases(group, [](const auto& n) { return n.unloading_stiffness(); });
  const Hertz& hertz = result.hertz;
  result.contact_area = over_cases(group, [&](const auto& n) {
    return n.ratios.empty() ? unknown : n.ratios.back().area_ratio * hertz.contact_area(n.ratios.back().force);
  });
  result.largest_pressure = over_cases(group, [&](const auto& n) {
    return n.ratios.empty() ? unknown : n.ratios.back().pressure_ratio * hertz.peak_pressure(n.ratios.back().force);
  });
  result.plastic_volume = over_cases(group, [](const auto& n) { return n.plastic_volume; });
  result.residual_imprint = over_cases(group, [](const auto& n) { return n.residual_imprint; });
  result.dissipated_energy = over_cases(group, [](const auto& n) { return n.dissipated_energy; });
  const auto fitted = [&](auto value) {
    return over_cases(group, [&](const auto& n) { return n.has_fits ? value(n) : unknown; });
  };
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

std::string percent(double ratio) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.2g %%", 100 * std::abs(ratio - 1));
  return buffer;
}

std::string force_text(double force) { return format_quantity(force, Dimension::force, 3); }

std::string stiffness_sentence(const GroupComparison& group, double tolerance) {
  if (group.loads.empty() || std::isnan(group.loads.back().stiffness_ratio.mean))
    return "too few load steps to judge (three are needed).";
  const auto& low = group.loads.front();
  const auto& high = group.loads.back();
  const auto softer = [](double ratio) { return ratio < 1 ? std::string("softer") : std::string("stiffer"); };
  const std::string within = percent(1 + tolerance);
  if (std::isnan(group.hertzian_from))
    return softer(high.stiffness_ratio.mean) + " than Hertz by " + percent(high.stiffness_ratio.mean) + " still at " +
           force_text(high.force) + " (" + percent(low.stiffness_ratio.mean) + " " + softer(low.stiffness_ratio.mean) +
           " at " + force_text(low.force) + ").";
  if (group.hertzian_from <= low.force)
    return "as stiff as Hertz within " + within + " from " + force_text(low.force) + " to " + force_text(high.force) + ".";
  return softer(low.stiffness_ratio.mean) + " than Hertz by " + percent(low.stiffness_ratio.mean) + " at " +
         force_text(low.force) + ", within " + within + " from " + force_text(group.hertzian_from) + " on.";
}

std::string verdict_of(const GroupComparison& group, double tolerance) {
  std::string words = "Loading: " + stiffness_sentence(group, tolerance);
  const GroupNumbers& numbers = group.numbers;
  if (!group.loads.empty()) {
    const double ratio = group.loads.back().force_ratio.mean;
    words += " Force at the same approach is " +
             (std::abs(ratio - 1) <= tolerance ? "Hertz's within " + percent(1 + tolerance)
                                               : percent(ratio) + (ratio < 1 ? " below" : " above") + " Hertz's") +
             " at " + force_text(numbers.force) + ".";
  }
  const double unloading = numbers.unloading_stiffness.mean / numbers.hertz.normal_stiffness(numbers.force);
  if (std::isfinite(unloading))
    words += " Unloading starts " +
             (std::abs(unloading - 1) <= tolerance ? "as stiff as Hertz within " + percent(1 + tolerance)
                                                   : percent(unloading) + (unloading < 1 ? " softer" : " stiffer") +
                                                         " than Hertz") +
             ".";
  if (numbers.plastic_volume.mean > 0) {
    words += " Material yielded";
    if (std::isfinite(numbers.residual_imprint.mean))
      // Less than the scatter, or negative: the extrapolation of the first loading to zero is no better than that.
      words += numbers.residual_imprint.mean > 0 && !(numbers.residual_imprint.mean <= numbers.residual_imprint.sd)
                   ? "; an imprint of " + format_quantity(numbers.residual_imprint.mean, Dimension::length, 3) + " stays"
                   : "; its imprint is too small to be told from the scatter";
    words += ".";
  }
  return words;
}

void add_mesh_errors(const CaseCollection& collection, std::vector<GroupComparison>& groups) {
  for (std::size_t i = 0; i < groups.size(); ++i) {
    std::vector<double> spacings, values;
    for (std::size_t j = 0; j < groups.size(); ++j) {
      const double value = groups[j].numbers.loading_stiffness.mean;
      if (collection.groups[j].physics() != collection.groups[i].physics() || std::isnan(groups[j].interface_spacing) ||
          std::isnan(value) || std::find(spacings.begin(), spacings.end(), groups[j].interface_spacing) != spacings.end())
        continue;
      spacings.push_back(groups[j].interface_spacing);
      values.push_back(value);
    }
    if (spacings.size() < 2) continue;
    MeshError error = mesh_error(spacings, values);
    // The limit is the family's; the error is that of this group's own spacing.
    error.relative_error = groups[i].numbers.loading_stiffness.mean / error.extrapolated - 1;
    groups[i].mesh = error;
  }
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
    result.numbers = numbers_of(group);
    for (const auto& step : group.numbers.front().ratios)
      result.loads.push_back({step.force, over_realisations(group, step.force, &HertzRatios::force_ratio),
                              over_realisations(group, step.force, &HertzRatios::stiffness_ratio),
                              over_realisations(group, step.force, &HertzRatios::area_ratio),
                              over_realisations(group, step.force, &HertzRatios::pressure_ratio)});
    result.hertzian_from = hertzian_from(result.loads, tolerance);
    result.verdict = verdict_of(result, tolerance);
    comparison.groups.push_back(std::move(result));
  }
  add_mesh_errors(collection, comparison.groups);
  return comparison;
}

}  // namespace asperity

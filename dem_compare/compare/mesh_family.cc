#include "dem_compare/compare/mesh_family.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace asperity {
namespace {

using ByRealisation = std::map<std::string, double>;

/// Realisations are told apart by their surfaces; cases with the same ones are counted.
ByRealisation by_realisation(const CaseGroup& group,
                             const std::function<double(const NormalNumbers&)>& number) {
  ByRealisation values;
  std::map<std::string, int> occurrences;
  for (std::size_t i = 0; i < group.cases.size(); ++i) {
    const CaseEntries& entries = group.cases[i].entries;
    const double value = number(group.numbers[i]);
    const std::string surfaces =
        entries.text("Particle/Topography") + "\n" + entries.text("Substrate/Topography") + "\n";
    if (std::isfinite(value)) values[surfaces + std::to_string(occurrences[surfaces]++)] = value;
  }
  return values;
}

}  // namespace

MeshFamily::MeshFamily(const CaseCollection& collection, const CaseGroup& own) : own_(own) {
  const ContactInputs physics = own.physics();
  std::vector<double> spacings{own.first().interface_spacing()};
  if (std::isnan(spacings.front())) return;
  for (const auto& group : collection.groups) {
    const double spacing = group.first().interface_spacing();
    if (&group == &own || std::isnan(spacing) || group.physics() != physics ||
        std::find(spacings.begin(), spacings.end(), spacing) != spacings.end())
      continue;
    spacings.push_back(spacing);
    others_.push_back(&group);
  }
}

bool MeshFamily::own_is_finest() const {
  const auto spacings = other_spacings();
  return std::all_of(spacings.begin(), spacings.end(),
                     [&](double h) { return h > own_.first().interface_spacing(); });
}

std::vector<double> MeshFamily::other_spacings() const {
  std::vector<double> spacings;
  for (const CaseGroup* group : others_) spacings.push_back(group->first().interface_spacing());
  return spacings;
}

Estimate MeshFamily::estimate(const std::function<double(const NormalNumbers&)>& number) const {
  const ByRealisation own = by_realisation(own_, number);
  Estimate estimate;
  std::vector<double> all;
  for (const auto& [surface, value] : own) all.push_back(value);
  static_cast<Scatter&>(estimate) = scatter_of(all);

  std::vector<double> spacings{own_.first().interface_spacing()};
  std::vector<ByRealisation> values{own};
  for (const CaseGroup* group : others_) {
    ByRealisation there = by_realisation(*group, number);
    if (there.empty()) continue;
    spacings.push_back(group->first().interface_spacing());
    values.push_back(std::move(there));
  }
  if (values.size() < 2) return estimate;
  // Values of each spacing over the common realisations.
  std::vector<std::vector<double>> common(values.size());
  for (const auto& [surface, value] : own) {
    if (!std::all_of(values.begin(), values.end(),
                     [&, name = surface](const auto& there) { return there.count(name) > 0; }))
      continue;
    for (std::size_t i = 0; i < values.size(); ++i) common[i].push_back(values[i].at(surface));
  }
  if (common.front().empty()) return estimate;

  std::vector<double> means;
  for (const auto& list : common) means.push_back(scatter_of(list).mean);
  const double own_mean = means.front();
  if (own_mean == 0) return estimate;
  MeshError error = mesh_error(spacings, means);
  // The limit is the family's; the error is that of this group's own spacing.
  error.relative_error = (own_mean - error.extrapolated) / std::abs(own_mean);
  if (spacings.size() == 2) {
    std::vector<double> errors;
    for (std::size_t r = 0; r < common[0].size(); ++r)
      errors.push_back((common[0][r] - mesh_error(spacings, {common[0][r], common[1][r]}).extrapolated) /
                       std::abs(own_mean));
    error.standard_error = scatter_of(errors).standard_error;
  }
  estimate.mesh = error;
  return estimate;
}

}  // namespace asperity

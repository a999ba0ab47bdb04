#include <tuple>

#include "dem_compare/derive/derivation.h"
#include "dem_compare/derive/length_choice.h"

namespace asperity {
namespace {

bool same_but_for_radius(const ParameterSet& one, const ParameterSet& other) {
  for (std::size_t i = 0; i < one.inputs.size(); ++i)
    if (one.inputs[i] != other.inputs[i] && one.inputs[i].first != "Particle/Radius") return false;
  return true;
}

/// The report of a mode over several radii.
LawReport report_of(const std::string& mode, const std::vector<std::size_t>& family, const std::vector<Derivation>& derivations, std::size_t law) {
  LawReport report;
  std::string radii;
  for (const auto set : family) {
    const std::string radius = format_quantity(derivations[set].parameters.particle.radius, Dimension::length);
    radii += (radii.empty() ? "" : ", ") + radius;
    for (auto point : derivations[set].laws[law].points) {
      point.realisation += " at " + radius;  // the same seed under another sphere is another contact
      report.points.push_back(point);
    }
  }
  report.title = mode + " over the radii " + radii + ", one mu and h for all";
  const LengthChoice choice = choose_length(report.points);
  tell_choice(choice, report);
  report.details = to_json(choice);
  return report;
}

}  // namespace

std::vector<LawReport> compare_radii(const std::vector<ParameterSet>& sets, std::vector<Derivation>& derivations) {
  std::vector<LawReport> reports;
  std::vector<bool> seen(sets.size(), false);
  for (std::size_t i = 0; i < sets.size(); ++i) {
    if (seen[i]) continue;
    std::vector<std::size_t> alike;
    for (std::size_t k = i; k < sets.size(); ++k)
      if (same_but_for_radius(sets[i], sets[k])) alike.push_back(k), seen[k] = true;
    for (const auto& [name, mode, key] : {std::tuple{"Torsion", "torsion", Derivation::torsion}, std::tuple{"Rolling", "rolling", Derivation::rolling}}) {
      std::vector<std::size_t> family;
      for (const auto set : alike)
        if (!derivations[set].laws[key].points.empty()) family.push_back(set);
      if (family.size() < 2) continue;
      reports.push_back(report_of(name, family, derivations, key));
      for (const auto set : family) derivations[set].parameters.derivation[mode]["over_radii"] = reports.back().details;
    }
  }
  return reports;
}

}  // namespace asperity

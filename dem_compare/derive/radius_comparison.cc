#include <algorithm>
#include <utility>

#include "dem_compare/cases/motion_mode.h"
#include "dem_compare/derive/derivation.h"
#include "dem_compare/derive/length_choice.h"

namespace asperity {
namespace {

bool same_but_for_radius(const ParameterSet& one, const ParameterSet& other) {
  const auto differ = differing_entries(one.inputs, other.inputs);
  return std::all_of(differ.begin(), differ.end(),
                     [](const std::string& entry) { return entry == "Particle/Radius"; });
}

/// Contacts of several sets.
std::vector<ResistancePoint> points_of_sets(const std::vector<std::size_t>& family,
                                            const std::vector<Derivation>& derivations, Motion motion) {
  std::vector<ResistancePoint> points;
  for (const auto set : family)
    for (auto point : derivations[set].law_of(motion).points) {
      // The same seed under another sphere is another contact.
      point.realisation += " at " + format_quantity(point.particle_radius, Dimension::length);
      points.push_back(point);
    }
  return points;
}

/// Where a set alone could not tell lambda but all radii do, its law is written with theirs.
void adopt_length(const LengthChoice& all, const MotionMode& mode, Derivation& derivation) {
  const LengthChoice own = choose_length(derivation.law_of(mode.motion).points);
  if (own.is_told() || !all.is_told()) return;
  const bool is_radius = all.scale() == LengthScale::particle_radius;
  const ResistanceLaw& adopted = is_radius ? own.with_radius : own.with_contact;
  EffectiveQuantity &friction = *(derivation.parameters.*mode.friction),
                    &offset = *(derivation.parameters.*mode.offset);
  friction.value = adopted.coefficient;
  friction.sd = adopted.coefficient_sd();
  friction.length_scale = all.scale();
  friction.provenance += "; lambda told by the particle's other radii";
  offset.value = adopted.offset;
  if (adopted.has_offset) offset.sd = adopted.offset_sd();
}

}  // namespace

std::vector<LawReport> compare_radii(const std::vector<ParameterSet>& sets,
                                     std::vector<Derivation>& derivations) {
  std::vector<LawReport> reports;
  std::vector<bool> seen(sets.size(), false);
  for (std::size_t i = 0; i < sets.size(); ++i) {
    if (seen[i]) continue;
    std::vector<std::size_t> alike;
    for (std::size_t k = i; k < sets.size(); ++k)
      if (same_but_for_radius(sets[i], sets[k])) alike.push_back(k), seen[k] = true;
    for (const MotionMode* mode : {&torsion_mode(), &rolling_mode()}) {
      std::vector<std::size_t> family;
      std::string radii;
      for (const auto set : alike) {
        if (derivations[set].law_of(mode->motion).points.empty()) continue;
        radii += (radii.empty() ? "" : ", ") +
                 format_quantity(derivations[set].parameters.particle.radius, Dimension::length);
        family.push_back(set);
      }
      if (family.size() < 2) continue;
      LawReport report;
      report.title = std::string(mode->title) + ", over the radii " + radii + " with one mu and h for all";
      report.points = points_of_sets(family, derivations, mode->motion);
      const LengthChoice choice = choose_length(report.points);
      tell_choice(choice, report);
      report.details = to_json(choice);
      for (const auto set : family) {
        adopt_length(choice, *mode, derivations[set]);
        derivations[set].parameters.derivation[name_of(mode->motion)]["over_radii"] = report.details;
      }
      reports.push_back(std::move(report));
    }
  }
  return reports;
}

}  // namespace asperity

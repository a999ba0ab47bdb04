#include <algorithm>
#include <utility>

#include "dem_compare/derive/derivation.h"

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
  derivation.origin_of(mode.friction).push_back({Origin::From::other_radii});
  offset.value = adopted.offset;
  if (adopted.has_offset) offset.sd = adopted.offset_sd();
}

}  // namespace

std::vector<LawFindings> compare_radii(const std::vector<ParameterSet>& sets,
                                       std::vector<Derivation>& derivations) {
  std::vector<LawFindings> compared;
  std::vector<bool> seen(sets.size(), false);
  for (std::size_t i = 0; i < sets.size(); ++i) {
    if (seen[i]) continue;
    std::vector<std::size_t> alike;
    for (std::size_t k = i; k < sets.size(); ++k)
      if (same_but_for_radius(sets[i], sets[k])) alike.push_back(k), seen[k] = true;
    for (const MotionMode* mode : {&torsion_mode(), &rolling_mode()}) {
      LawFindings findings;
      findings.mode = mode;
      std::vector<std::size_t> family;
      for (const auto set : alike) {
        if (derivations[set].law_of(mode->motion).points.empty()) continue;
        findings.radii.push_back(derivations[set].parameters.particle.radius);
        family.push_back(set);
      }
      if (family.size() < 2) continue;
      findings.points = points_of_sets(family, derivations, mode->motion);
      const LengthChoice choice = choose_length(findings.points);
      find_length(choice, findings);
      findings.details = to_json(choice);
      for (const auto set : family) {
        adopt_length(choice, *mode, derivations[set]);
        derivations[set].parameters.derivation[name_of(mode->motion)]["over_radii"] = findings.details;
      }
      compared.push_back(std::move(findings));
    }
  }
  return compared;
}

}  // namespace asperity

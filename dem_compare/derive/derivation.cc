#include "dem_compare/derive/derivation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/joined.h"
#include "core/shear_moduli.h"
#include "dem_compare/cases/compared_contact.h"
#include "dem_compare/derive/motion_derivation.h"
#include "dem_compare/derive/normal_derivation.h"
#include "dem_compare/laws/hertzian_torsion.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

ContactBody body_of(const ElasticBody& body, double radius) {
  ContactBody contact;
  contact.radius = radius;
  contact.youngs_modulus = body.youngs_modulus;
  contact.poissons_ratio = body.poisson_ratio;
  return contact;
}

Json cases_json(const ReducedCases& cases) {
  Json all = Json::array();
  for (const ReducedCase& one : cases) {
    Json entry{{"folder", one.folder()},
               {"experiment", name_of(one.motion)},
               {"load", std::max(0.0, one.largest_force)},
               {"realisation", one.realisation}};
    if (std::isfinite(one.spacing)) entry["interface_spacing"] = one.spacing;
    if (!one.solved->version().empty()) entry["asperity"] = one.solved->version();
    if (std::isfinite(one.solved->open_energy())) entry["open_energy"] = one.solved->open_energy();
    all.push_back(std::move(entry));
  }
  return all;
}

/// Which versions solved the cases, for the provenance of what they told.
std::vector<std::string> versions_of(const ReducedCases& cases) {
  std::set<std::string> versions;
  for (const ReducedCase& one : cases)
    if (!one.solved->version().empty()) versions.insert(one.solved->version());
  return {versions.begin(), versions.end()};
}

/// The record of what was derived from what, and what is in doubt.
void write_record(const ReducedCases& cases, Derivation& derivation) {
  for (auto& [member, origin] : derivation.origins)
    if ((derivation.parameters.*member)->load_range)
      origin.push_back({Origin::From::solver, unknown, joined(versions_of(cases), ", ")});
  Json& record = derivation.parameters.derivation;
  for (const auto& [entry, value] : derivation.inputs) record["inputs"][entry] = value;
  record["cases"] = cases_json(cases);
  for (const ReducedCase& one : cases)
    for (const std::string& doubt : one.doubts) record["in_doubt"].push_back(one.folder() + ": " + doubt);
  for (const LawFindings& law : derivation.laws) record[name_of(law.motion())] = law.details;
}

/// G* of the materials where no sliding case told one: an engine's laws need it.
void complete_shear_modulus(const SolvedCase& solved, Derivation& derivation) {
  const double mindlin = reduced_shear_modulus(solved.particle(), solved.substrate());
  LawFindings& sliding = derivation.laws.back();
  auto& modulus = derivation.parameters.reduced_shear_modulus;
  if (modulus) {
    sliding.found.push_back(ShearModulusFact{{modulus->value, modulus->sd}, mindlin});
    return;
  }
  modulus.emplace().value = mindlin;
  derivation.origin_of(&ContactParameters::reduced_shear_modulus) = {{Origin::From::material_shear}};
  sliding.open.push_back({OpenQuestion::About::shear_modulus, Derived::stiffness, sliding.mode, mindlin});
}

/// What sliding friction alone would make of torsion.
void compare_torsion_with_sliding(const ContactParameters& parameters, LawFindings& torsion) {
  if (!parameters.sliding_friction || !parameters.torsion_friction ||
      parameters.torsion_friction->length_scale != LengthScale::contact_radius)
    return;
  torsion.found.push_back(TorsionFact{parameters.torsion_friction->value /
                                      full_slip_torsion_coefficient(parameters.sliding_friction->value)});
}

}  // namespace

Derivation derive_parameters(const ReducedSet& set) {
  const SolvedCase& first = *set.cases.front().solved;
  Derivation derivation;
  derivation.inputs = set.inputs;
  derivation.cases = set.cases.size();
  ContactParameters& parameters = derivation.parameters;
  parameters.particle = body_of(first.particle(), first.hertz().radius);
  parameters.target = body_of(first.substrate(), std::numeric_limits<double>::infinity());
  parameters.particle.rms = first.entries.topography("Particle").rms();
  parameters.target.rms = first.entries.topography("Substrate").rms();
  derive_normal(set, derivation);
  derive_motion(set, sliding_mode(), derivation);
  complete_shear_modulus(first, derivation);
  derive_motion(set, torsion_mode(), derivation);
  compare_torsion_with_sliding(parameters, derivation.laws.back());
  derive_motion(set, rolling_mode(), derivation);
  write_record(set.cases, derivation);
  return derivation;
}

const LawFindings& Derivation::law_of(Motion motion) const {
  return *std::find_if(laws.begin(), laws.end(),
                       [&](const LawFindings& law) { return law.motion() == motion; });
}

std::vector<Origin>& Derivation::origin_of(Member member) {
  for (auto& [known, origin] : origins)
    if (known == member) return origin;
  return origins.emplace_back(member, std::vector<Origin>{}).second;
}

}  // namespace asperity

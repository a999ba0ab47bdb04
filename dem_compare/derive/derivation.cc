#include "dem_compare/derive/derivation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "dem_compare/cases/compared_contact.h"
#include "dem_compare/derive/motion_derivation.h"
#include "dem_compare/derive/normal_derivation.h"
#include "dem_compare/laws/hertzian_torsion.h"
#include "dem_compare/laws/shear_moduli.h"
#include "results/energy_balance.h"

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

std::string elastic_text(const ElasticBody& body) {
  return "E " + format_quantity(body.youngs_modulus, Dimension::pressure) + ", nu " +
         format_quantity(body.poisson_ratio, Dimension::none);
}

Json cases_json(const ParameterSet& set) {
  Json cases = Json::array();
  for (const auto& solved : set.cases) {
    double load = 0;
    for (const double force : solved.history.normal_force) load = std::max(load, force);
    Json entry{{"folder", solved.folder.string()},
               {"experiment", name_of(solved.motion())},
               {"load", load},
               {"realisation", realisation_of(solved)}};
    if (std::isfinite(solved.interface_spacing())) entry["interface_spacing"] = solved.interface_spacing();
    if (!solved.version().empty()) entry["asperity"] = solved.version();
    if (std::isfinite(solved.open_energy())) entry["open_energy"] = solved.open_energy();
    cases.push_back(std::move(entry));
  }
  return cases;
}

/// Which versions solved the cases, for the provenance of what they told.
std::string versions_of(const ParameterSet& set) {
  std::set<std::string> versions;
  for (const auto& solved : set.cases)
    if (!solved.version().empty()) versions.insert(solved.version());
  std::string text;
  for (const auto& version : versions) text += (text.empty() ? "asperity " : ", ") + version;
  return text.empty() ? "a version that is not said" : text;
}

/// G* of the materials where no sliding case told one: an engine's laws need it.
void complete_shear_modulus(const SolvedCase& solved, ContactParameters& parameters, LawReport& sliding) {
  const double mindlin = sliding_modulus(solved.particle(), solved.substrate());
  if (parameters.reduced_shear_modulus) {
    sliding.findings.push_back(
        "G* of k_l = 8 G* a: " +
        with_error(parameters.reduced_shear_modulus->value, parameters.reduced_shear_modulus->sd,
                   Dimension::pressure) +
        " (materials, Mindlin 1949: " + format_quantity(mindlin, Dimension::pressure, 4) + ")");
    return;
  }
  parameters.reduced_shear_modulus.emplace();
  parameters.reduced_shear_modulus->value = mindlin;
  parameters.reduced_shear_modulus->provenance =
      "of the materials (Mindlin 1949, 2 - nu): no sliding case told it";
  sliding.not_identifiable.push_back("G*: that of the materials is written, " +
                                     format_quantity(mindlin, Dimension::pressure, 4));
}

/// What sliding friction alone would make of torsion.
void compare_torsion_with_sliding(const ContactParameters& parameters, LawReport& torsion) {
  if (!parameters.sliding_friction || !parameters.torsion_friction ||
      parameters.torsion_friction->length_scale != LengthScale::contact_radius)
    return;
  const double expected = full_slip_torsion_coefficient(parameters.sliding_friction->value);
  torsion.findings.push_back(
      "mu of torsion over that of sliding friction spread as Hertz' pressure, 3 pi/16 mu_l (Lubkin 1951): " +
      with_error(parameters.torsion_friction->value / expected, std::numeric_limits<double>::quiet_NaN(),
                 ""));
}

}  // namespace

Derivation derive_parameters(const ParameterSet& set) {
  const SolvedCase& first = set.cases.front();
  Derivation derivation;
  ContactParameters& parameters = derivation.parameters;
  parameters.particle = body_of(first.particle(), first.hertz().radius);
  parameters.target = body_of(first.substrate(), std::numeric_limits<double>::infinity());
  parameters.particle.rms = first.entries.topography("Particle").rms();
  parameters.target.rms = first.entries.topography("Substrate").rms();
  const std::string particle = "sphere " + format_quantity(first.hertz().radius, Dimension::length) + " (" +
                               elastic_text(first.particle()) + ")";
  parameters.title = "Derived from " + std::to_string(set.cases.size()) +
                     (set.cases.size() == 1 ? " solved case: " : " solved cases: ") + particle +
                     " on plane (" + elastic_text(first.substrate()) + ")";
  derivation.heading = parameters.title;
  for (const auto& [entry, value] : set.inputs) {
    const bool says_nothing = value == "smooth" || value == "isotropic" || value == "dugdale" ||
                              value == "inf" || value.rfind("0", 0) == 0;
    const bool is_said = entry.find("Radius") != std::string::npos ||
                         entry.find("Young") != std::string::npos ||
                         entry.find("Poisson") != std::string::npos;
    if (!is_said && (!says_nothing || entry == "Interface/Friction coefficient"))
      derivation.heading += "\n  " + entry + " = " + value;
  }
  derivation.laws.push_back(derive_normal(set, parameters));
  derivation.laws.push_back(derive_motion(set, sliding_mode(), parameters));
  complete_shear_modulus(first, parameters, derivation.laws.back());
  derivation.laws.push_back(derive_motion(set, torsion_mode(), parameters));
  compare_torsion_with_sliding(parameters, derivation.laws.back());
  derivation.laws.push_back(derive_motion(set, rolling_mode(), parameters));

  const std::string solver = versions_of(set);
  for (const auto& entry : quantity_entries())
    if (auto& quantity = parameters.*entry.member; quantity && quantity->load_range)
      quantity->provenance += "; solved by " + solver + ", folders in derivation/cases";
  Json& record = parameters.derivation;
  for (const auto& [entry, value] : set.inputs) record["inputs"][entry] = value;
  record["cases"] = cases_json(set);
  for (const auto& solved : set.cases)
    if (is_energy_flagged(solved))
      record["in_doubt"].push_back(solved.folder.string() + ": " + open_energy_words(solved));
  for (const LawReport& report : derivation.laws) {
    Json law = report.details;
    law["findings"] = report.findings;
    law["not_told"] = report.not_identifiable;
    record[name_of(report.motion)] = std::move(law);
  }
  return derivation;
}

const LawReport& Derivation::law_of(Motion motion) const {
  return *std::find_if(laws.begin(), laws.end(), [&](const LawReport& law) { return law.motion == motion; });
}

std::string to_text(const LawReport& report) {
  std::string text = report.title + "\n";
  for (const auto& finding : report.findings) text += "  " + finding + "\n";
  for (const auto& open : report.not_identifiable) text += "  not identifiable: " + open + "\n";
  return text;
}

std::string to_text(const Derivation& derivation) {
  std::string text = derivation.heading + "\n";
  for (const auto& law : derivation.laws) text += "\n" + to_text(law);
  return text;
}

}  // namespace asperity
